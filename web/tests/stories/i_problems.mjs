// Where the workbench cannot run, the page says so, and what to do.

import assert from "node:assert/strict";
import { pathToFileURL } from "node:url";
import { join } from "node:path";
import { DIST, send, story } from "../browser.mjs";

/** Opens the page after `init` has changed the browser, and waits for the message. */
async function told(server, visitor, init) {
  const { context } = await visitor();
  const page = await context.newPage();
  if (init) await page.addInitScript(init);
  await page.goto(server.address);
  return read(page);
}

async function read(page) {
  await page.locator("#problem").waitFor();
  assert.equal(await page.evaluate(() => document.activeElement.id), "problem-title");
  return { page, kind: await page.evaluate(() => document.documentElement.dataset.problem), text: await page.locator("#problem").innerText() };
}

story("without WebGL the page says what is missing and what to do", { flags: ["--disable-gpu", "--disable-webgl", "--disable-3d-apis"], expectsErrors: true }, async ({ server, visitor }) => {
  const { kind, text } = await told(server, visitor);
  assert.equal(kind, "webgl");
  assert.match(text, /hardware acceleration/);
});

story("without WebAssembly the page says what is missing and what to do", {}, async ({ server, visitor }) => {
  const { kind, text } = await told(server, visitor, () => { delete globalThis.WebAssembly; });
  assert.equal(kind, "wasm");
  assert.match(text, /another browser/);
});

story("when the program does not arrive the page names the file", { expectsErrors: true }, async ({ server, visitor }) => {
  const { context } = await visitor();
  const page = await context.newPage();
  await page.route("**/*.wasm*", (route) => route.fulfill({ status: 404, body: "" }));
  await page.goto(server.address);
  const { kind, text } = await read(page);
  assert.equal(kind, "load");
  assert.match(text, /rayscope\.[0-9a-f]{16}\.wasm/);
});

story("when the program stops, the page says why, what is kept, and begins again", { expectsErrors: true }, async ({ visitor }) => {
  const page = await (await visitor()).opens("#csg/bowl?pixel=333,150");
  await page.evaluate(() => globalThis.rayscopeHost.failed("panicked at here:1"));
  const { kind, text } = await read(page);
  assert.equal(kind, "failed");
  assert.match(text, /panicked at here:1/);
  assert.match(text, /kept in this browser/);
  await Promise.all([page.waitForEvent("load"), page.getByRole("button", { name: "Begin at the first scene" }).click()]);
  assert.ok(!page.url().includes("333"), page.url());
});

story("when the graphics card is taken away, the page says so", { expectsErrors: true }, async ({ visitor }) => {
  const page = await (await visitor()).opens();
  await page.evaluate(() => document.getElementById("workbench").dispatchEvent(new Event("webglcontextlost")));
  assert.equal((await read(page)).kind, "context");
});

story("opened straight from a folder the page says that a server is needed", { expectsErrors: true }, async ({ visitor }) => {
  const { context, requests } = await visitor();
  const page = await context.newPage();
  await page.goto(pathToFileURL(join(DIST, "index.html")).href);
  assert.equal((await read(page)).kind, "file");
  requests.length = 0;
});

story("a command that is none leaves the workbench running", {}, async ({ visitor }) => {
  const page = await (await visitor()).opens();
  await send(page, { do: "dance" });
  await send(page, { do: "next" });
  assert.equal(await page.evaluate(() => document.documentElement.dataset.problem ?? null), null);
});
