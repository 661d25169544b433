// Loads the program and starts it.

import { startEmbedding } from "./embed.js";
import { makeHost } from "./host.js";
import { startKeys } from "./keys.js";
import { startMirror } from "./mirror.js";
import { compiledProgram } from "./program.js";

const { say } = globalThis.rayscopeWords;
const problem = globalThis.rayscopeProblem;

const place = (name) => new URL(document.body.dataset[name], document.baseURI).href;
const megabytes = (bytes) => (bytes / 1e6).toLocaleString(document.documentElement.lang, { minimumFractionDigits: 1, maximumFractionDigits: 1 });

if (!document.documentElement.dataset.problem) start();

async function start() {
  const loaded = await load().catch((error) => problem("load", String(error?.message ?? error)));
  if (!loaded) return;
  document.getElementById("told").textContent = say("starting");
  try {
    await run(loaded);
  } catch (error) {
    problem("failed", String(error?.message ?? error));
  }
}

async function load() {
  const bar = document.getElementById("bar");
  const told = document.getElementById("told");
  const all = Number(document.body.dataset.bytes);
  const progress = (done) => {
    bar.value = Math.min(done / all, 1);
    told.textContent = say("loading-bytes", { done: megabytes(done), all: megabytes(all) });
  };
  const [module, bindings] = await Promise.all([compiledProgram(place("program"), progress), import(place("glue"))]);
  return { module, bindings };
}

async function run({ module, bindings }) {
  const canvas = document.getElementById("workbench");
  const embedding = startEmbedding();
  const host = makeHost({
    canvas,
    module,
    glue: place("glue"),
    worker: place("worker"),
    embed: embedding.value,
    tell: embedding.tell,
    mirror: startMirror((command) => host.receive?.(JSON.stringify(command))),
    shown: () => shown(canvas, embedding),
  });
  globalThis.rayscopeHost = host;
  startKeys(canvas);
  canvas.addEventListener("webglcontextlost", () => problem("context"));
  addEventListener("error", (event) => stopped(event.error));
  addEventListener("unhandledrejection", (event) => stopped(event.reason));
  await bindings.default({ module_or_path: module });
}

/** A trap in the program leaves it in no state to go on; other mistakes are told in the console and hurt nothing. */
function stopped(error) {
  if (error instanceof WebAssembly.RuntimeError) problem("failed", String(error.message));
}

/** The first picture is there: the page makes way. */
function shown(canvas, embedding) {
  const loading = document.getElementById("loading");
  loading.classList.add("leaving");
  const leave = () => { loading.hidden = true; };
  loading.addEventListener("transitionend", leave, { once: true });
  // Where nothing moves there is no end of a transition.
  setTimeout(leave, 300);
  document.getElementById("stage").inert = false;
  // Within another page the reader's place is in that page.
  if (!embedding.isFramed) canvas.focus({ preventScroll: true });
  embedding.begin();
  keepForOffline();
}

/** Only now, so that what is kept for later does not travel before what is waited for. */
function keepForOffline() {
  navigator.serviceWorker?.register(new URL("./sw.js", document.baseURI)).catch((error) => {
    console.info(`rayscope is not kept for offline use: ${error.message}`);
  });
}
