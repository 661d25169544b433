// The workbench within another page: what it tells that page, and what it may be told by it.

/** Below this nothing can be read; the page around is told so. */
const LEAST = [320, 240];
/** The longest link that the program reads. */
const LONGEST = 32_000;

const isCount = (value) => Number.isSafeInteger(value) && value >= 0;
const isText = (value) => typeof value === "string" && value.length <= LONGEST;

/** The fields of each command, and what they must be. */
const COMMANDS = {
  select: { event: isCount },
  next: {},
  back: {},
  into: {},
  out: {},
  pixel: { x: isCount, y: isCount },
  open: { link: (value) => isText(value) && value.startsWith("rayscope:") },
  lesson: { lesson: isText, step: (value) => value === undefined || isCount(value) },
  answer: { question: isCount, answer: isAnswer },
};

function isAnswer(value) {
  const isOne = (one) => Number.isFinite(one) || isText(one);
  return isOne(value) || (Array.isArray(value) && value.length <= 1000 && value.flat(1).every(isOne));
}

/** The command as it is passed on, with nothing but the fields that it has; nothing if it is none. */
export function checked(data) {
  const fields = Object.hasOwn(COMMANDS, data?.do) ? COMMANDS[data.do] : null;
  if (!fields || !Object.entries(fields).every(([name, is]) => is(data[name]))) return null;
  return Object.fromEntries([["do", data.do], ...Object.keys(fields).map((name) => [name, data[name]])]);
}

/** Starts listening to the page around, if there is one. */
export function startEmbedding() {
  const value = new URLSearchParams(location.search).get("embed");
  const isFramed = window.parent !== window;
  if (value !== null) document.documentElement.dataset.embed = value;
  // What is told, a step and a score, is for whoever shows this frame; browsers that name it are held to it.
  const origin = location.ancestorOrigins?.[0] ?? (document.referrer ? new URL(document.referrer).origin : "*");
  const post = (message) => {
    if (isFramed) window.parent.postMessage({ source: "rayscope", ...message }, origin === "null" ? "*" : origin);
  };
  const waiting = [];
  const send = (command) => globalThis.rayscopeHost.receive(JSON.stringify(command));
  let isRunning = false;
  addEventListener("message", (event) => {
    const command = isFramed && event.source === window.parent ? checked(event.data) : null;
    if (!command) return;
    if (isRunning) send(command);
    else waiting.push(command);
  });
  new ResizeObserver(() => post({ type: "size", width: innerWidth, height: innerHeight, least: LEAST })).observe(document.documentElement);
  return {
    value,
    isFramed,
    tell: (json) => post(JSON.parse(json)),
    /** The program can be told things now. */
    begin() {
      isRunning = true;
      waiting.splice(0).forEach(send);
    },
  };
}
