// The book beside the workbench: its chapters come alive, with and without a network.

import assert from "node:assert/strict";
import { execFile } from "node:child_process";
import { cp, mkdtemp, rm } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { promisify } from "node:util";
import { DIST, ready, state, story, until } from "../browser.mjs";

const ROOT = join(import.meta.dirname, "../../..");
const RAYSCOPE = process.env.RAYSCOPE ?? join(ROOT, "target/debug/rayscope");

/** A copy of the build with a book of one lesson beside it. */
async function withBook() {
  const folder = await mkdtemp(join(tmpdir(), "rayscope-book-"));
  await cp(DIST, join(folder, "dist"), { recursive: true });
  for (const part of ["06_cube", "glossary.md"]) await cp(join(ROOT, "lessons", part), join(folder, "lessons", part), { recursive: true });
  const told = ["book", join(folder, "lessons"), "--no-examples", "--workbench", "..", "-o", join(folder, "dist/book")];
  await promisify(execFile)(RAYSCOPE, told);
  return folder;
}

/** Unfolds the first three steps of the chapter; their frames, when they are there. */
async function unfolded(page) {
  const frames = [];
  for (const step of (await page.locator("details.live").all()).slice(0, 3)) {
    await step.locator("summary").click();
    const iframe = step.locator("iframe");
    await iframe.scrollIntoViewIfNeeded();
    const frame = await (await iframe.elementHandle()).contentFrame();
    await frame.waitForLoadState();
    await ready(frame);
    frames.push(frame);
  }
  return frames;
}

story("three steps of a chapter come alive, and do so without a server", { longest: 60_000 }, async ({ server, visitor }) => {
  const folder = await withBook();
  server.folder = join(folder, "dist");
  const { context } = await visitor();
  const page = await context.newPage();
  const address = `${server.address}book/lessons/06_cube.html`;
  await page.goto(address);
  assert.deepEqual(page.frames().slice(1).map((frame) => frame.url()).filter((url) => url.includes("embed")), [], "what is folded is not loaded");
  const frames = await unfolded(page);
  assert.equal(frames.length, 3);
  for (const frame of frames) await until(frame, ({ rendered, event }) => rendered === 1 && event !== null);
  await page.waitForFunction(() => navigator.serviceWorker.ready.then(() => Boolean(navigator.serviceWorker.controller)));
  await page.reload();
  await server.close();
  await page.goto(address);
  const [first] = await unfolded(page);
  assert.equal((await state(first)).scene, "primitives/cube");
  await rm(folder, { recursive: true });
});
