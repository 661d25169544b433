// The ray's story as text for those who do not see the canvas: a tree of the visible rows, and the selected event.

/**
 * Starts the mirror; `send` takes commands for the program. What is returned takes what the program tells:
 * `{"title", "before", "of", "rows": [{"event", "level", "text", "selected"}], "event": {"title", "explanation", "lines"}}`; of long
 * stories the rows around the selected one, with how many there are before them and of how many.
 */
export function startMirror(send) {
  const title = document.getElementById("story-title");
  const list = document.getElementById("rows");
  const detail = document.getElementById("event");
  list.addEventListener("keydown", (event) => follow(event, list, detail, send));
  list.addEventListener("click", (event) => choose(event.target.closest("li"), send));
  return (json) => {
    const told = JSON.parse(json);
    put(title, told.title ?? "");
    putRows(list, told);
    putDetail(detail, told.event);
  };
}

/** Writes only what is new: a screen reader reads again what is written again. */
function put(element, text) {
  if (element.textContent !== text) element.textContent = text;
}

function set(element, name, value) {
  if (element.getAttribute(name) !== value) element.setAttribute(name, value);
}

/** Elements of rows that stay are kept where they are, and with them the reader's place. */
function putRows(list, { rows = [], before = 0, of = rows.length }) {
  const hadFocus = list.contains(document.activeElement);
  const kept = new Map([...list.children].map((item) => [item.dataset.event, item]));
  const wanted = new Set(rows.map((row) => String(row.event)));
  for (const [event, item] of kept) if (!wanted.has(event)) item.remove();
  let next = list.firstElementChild;
  for (const [i, row] of rows.entries()) {
    const item = kept.get(String(row.event)) ?? made(row.event);
    if (item === next) next = next.nextElementSibling;
    else list.insertBefore(item, next);
    putRow(item, row);
    set(item, "aria-posinset", String(before + i + 1));
    set(item, "aria-setsize", String(of));
  }
  const selected = list.querySelector('[aria-selected="true"]') ?? list.firstElementChild;
  for (const item of list.children) item.tabIndex = item === selected ? 0 : -1;
  if (hadFocus && document.activeElement !== selected) selected?.focus();
}

function made(event) {
  const item = document.createElement("li");
  item.setAttribute("role", "treeitem");
  item.dataset.event = event;
  return item;
}

function putRow(item, row) {
  put(item, row.text);
  set(item, "aria-level", String(row.level + 1));
  set(item, "aria-selected", String(Boolean(row.selected)));
  item.style.setProperty("--level", row.level);
}

function putDetail(detail, event) {
  const texts = event ? [event.title, event.explanation, ...event.lines].filter(Boolean) : [];
  const before = [...detail.children].map((element) => element.textContent);
  if (before.length === texts.length && before.every((text, i) => text === texts[i])) return;
  detail.replaceChildren(...texts.map((text, i) => {
    const element = document.createElement(i === 0 ? "h2" : "p");
    if (i === 0) element.tabIndex = -1;
    element.textContent = text;
    return element;
  }));
}

function choose(item, send) {
  if (!item) return;
  item.focus();
  send({ do: "select", event: Number(item.dataset.event) });
}

/** The keys of a tree: up and down through the rows, left out of a row, right into the story, Enter to the numbers. */
function follow(event, list, detail, send) {
  const item = event.target.closest("li");
  if (!item || event.ctrlKey || event.altKey || event.metaKey) return;
  const steps = {
    ArrowDown: () => choose(item.nextElementSibling, send),
    ArrowUp: () => choose(item.previousElementSibling, send),
    Home: () => choose(list.firstElementChild, send),
    End: () => choose(list.lastElementChild, send),
    ArrowLeft: () => choose(holding(item), send),
    ArrowRight: () => send({ do: "next" }),
    Enter: () => detail.querySelector("h2")?.focus(),
  };
  if (!steps[event.key]) return;
  event.preventDefault();
  steps[event.key]();
}

/** The row that this one lies within. */
function holding(item) {
  const level = (row) => Number(row.getAttribute("aria-level"));
  let above = item.previousElementSibling;
  while (above && level(above) >= level(item)) above = above.previousElementSibling;
  return above;
}
