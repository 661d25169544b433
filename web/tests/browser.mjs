// A browser, and what each story needs of it: a server, a fresh profile, a page that is watched.

import assert from "node:assert/strict";
import { mkdir } from "node:fs/promises";
import { join } from "node:path";
import test, { after } from "node:test";
import { chromium } from "playwright-core";
import { serve } from "./server.mjs";

export const DIST = process.env.RAYSCOPE_DIST;
const FAILED = join(import.meta.dirname, "failed");
/** No story may take longer; waits within it end a little earlier, so that they say what was waited for. */
const LONGEST = 20_000;
const WAIT = 12_000;

const FLAGS = [
  "--no-sandbox", "--use-gl=angle", "--use-angle=swiftshader", "--enable-unsafe-swiftshader", "--disable-quic", "--no-first-run",
  "--disable-background-networking", "--disable-component-update", "--disable-sync",
  // Whatever the page asked of another host would not be found.
  "--host-resolver-rules=MAP * ~NOTFOUND, EXCLUDE localhost",
];

const launched = new Map();

async function browserWith(flags) {
  const key = flags.join(" ");
  if (!launched.has(key)) {
    const executablePath = process.env.CHROMIUM ?? "/usr/bin/chromium";
    launched.set(key, chromium.launch({ executablePath, args: [...FLAGS, ...flags] }));
  }
  return launched.get(key);
}

after(async () => {
  for (const browser of launched.values()) await (await browser).close();
});

/**
 * A test in the browser. `tell` gets the server and `visitor()`, which begins with a fresh profile each time. Afterwards no
 * other host was asked and no cookie is set, whatever the story was. When it fails, its pages are pictured in `failed/`.
 */
export function story(name, given, tell) {
  test(name, { timeout: given.longest ?? LONGEST }, async () => {
    const server = await serve(DIST, { isPacking: given.isPacking });
    const browser = await browserWith(given.flags ?? []);
    const visitors = [];
    const visitor = async () => {
      const context = await browser.newContext({ viewport: { width: 1280, height: 800 }, locale: "en-GB", ...given.context });
      visitors.push(await watched(context, server));
      return visitors.at(-1);
    };
    try {
      await tell({ server, visitor });
      for (const each of visitors) await each.keptToItself(given);
    } catch (error) {
      await pictured(name, visitors);
      throw error;
    } finally {
      for (const each of visitors) await each.context.close();
      await server.close().catch(() => {});
    }
  });
}

async function pictured(name, visitors) {
  await mkdir(FAILED, { recursive: true });
  const pages = visitors.flatMap((each) => each.context.pages());
  for (const [i, page] of pages.entries()) {
    const path = join(FAILED, `${name.replace(/\W+/g, "_")}_${i}.png`);
    await page.screenshot({ path, timeout: 3000 }).catch(() => {});
  }
}

async function watched(context, server) {
  const requests = [];
  const errors = [];
  context.setDefaultTimeout(WAIT);
  context.on("request", (request) => requests.push(request.url()));
  context.on("weberror", (error) => errors.push(String(error.error())));
  context.on("console", (message) => {
    if (message.type() === "error" && /Content Security Policy/.test(message.text())) errors.push(message.text());
  });
  return {
    context,
    requests,
    errors,
    /** Opens a page of the server, waits until the workbench shows a picture, and puts away the tour of the first visit. */
    async opens(path = "") {
      const page = await context.newPage();
      await page.goto(server.address + path);
      await ready(page);
      await page.keyboard.press("Escape");
      await painted(page);
      return page;
    },
    async keptToItself({ expectsErrors = false }) {
      const elsewhere = requests.filter((url) => !url.startsWith(server.address) && !/^(data|blob|chrome-extension):/.test(url));
      assert.deepEqual(elsewhere.filter((url) => !url.endsWith("/favicon.ico")), [], "requests went elsewhere");
      assert.deepEqual(await context.cookies(), [], "cookies were set");
      if (!expectsErrors) assert.deepEqual(errors, [], "errors were thrown");
    },
  };
}

/** Waits until the workbench runs and the page has made way for it. */
export async function ready(frame) {
  await frame.waitForFunction(() => document.documentElement.dataset.problem || (globalThis.rayscopeHost?.state && document.getElementById("loading").hidden));
  assert.equal(await frame.evaluate(() => document.documentElement.dataset.problem ?? null), null);
}

/** What the workbench says of itself. */
export function state(frame) {
  return frame.evaluate(() => JSON.parse(globalThis.rayscopeHost.state()));
}

/** Waits until what the workbench says of itself is as `is` wants it. */
export async function until(frame, is) {
  const end = performance.now() + WAIT;
  for (;;) {
    const now = await state(frame);
    if (is(now)) return now;
    assert.ok(performance.now() < end, `waited in vain for ${is}; the workbench says ${JSON.stringify(now)}`);
    await new Promise((resolve) => setTimeout(resolve, 20));
  }
}

/** The rows of the story, as the mirror tells them. */
export function rowsOf(frame) {
  return frame.locator("#rows li").allTextContents();
}

/** Waits until a row of the story says something. */
export async function untilRow(frame, text) {
  await frame.locator("#rows li", { hasText: text }).first().waitFor({ state: "attached" });
}

/** Sends a command as an embedding page or the mirror does. */
export function send(frame, command) {
  return frame.evaluate((json) => globalThis.rayscopeHost.receive(json), JSON.stringify(command));
}

/** Where a pixel of the picture is on the page. */
export async function placeOf(frame, [x, y]) {
  const { picture, size } = await state(frame);
  const [left, top, width, height] = picture;
  return { x: left + ((x + 0.5) / size[0]) * width, y: top + ((y + 0.5) / size[1]) * height };
}

/** Waits until what a key did is shown: no person presses the next key for what is not there yet. */
function painted(page) {
  return page.evaluate(() => new Promise((shown) => requestAnimationFrame(() => requestAnimationFrame(shown))));
}

/** Waits until what is typed goes into a field: then the element that takes text has the keyboard. */
function typing(page) {
  return page.waitForFunction(() => document.activeElement.tagName === "INPUT");
}

/** A scene of one ball, which no scene of the program calls so. */
export const LONE = JSON.stringify({
  camera: { eye: [0, -5, 0], look_at: [0, 0, 0], up: [0, 0, 1] },
  lights: [{ name: "sun", directional: [1, -1, 1], colour: [1, 1, 1] }],
  materials: { clay: { diffuse: [0.6, 0.3, 0.2] } },
  objects: [{ shape: "sphere", name: "lone", material: "clay" }],
});

/** Writes a text over the scene file: chooses its panel by name, clicks into it, and types over everything. */
export async function edit(page, text) {
  await page.keyboard.press("Control+k");
  await typing(page);
  await page.keyboard.type("Scene file", { delay: 30 });
  await painted(page);
  await page.keyboard.press("Enter");
  await until(page, ({ views }) => views.includes("pane-editor"));
  await painted(page);
  // The panel is in the middle of the window.
  await page.mouse.click(640, 500);
  await typing(page);
  await page.keyboard.press("Control+a");
  await page.keyboard.insertText(text);
}
