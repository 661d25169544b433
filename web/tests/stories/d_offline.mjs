// Without a network, after one visit.

import assert from "node:assert/strict";
import { cp, mkdtemp, readFile, readdir, rename, rm, writeFile } from "node:fs/promises";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { ready, send, state, story, until } from "../browser.mjs";

const isKept = () => navigator.serviceWorker.ready.then(() => Boolean(navigator.serviceWorker.controller));

story("after one visit the page opens without a server, with another scene and with the examples", {}, async ({ server, visitor }) => {
  const { context, opens } = await visitor();
  const page = await opens();
  await page.waitForFunction(isKept);
  await server.close();
  await page.reload();
  await ready(page);
  await send(page, { do: "open", link: "rayscope:csg/bowl?pixel=333,150" });
  await until(page, ({ pixel }) => pixel[0] === 333);
  const example = await context.newPage();
  await example.goto(`${server.address}examples/embed.html`);
  assert.equal(await example.locator("iframe").count(), 3);
  const frame = example.frames()[1];
  await ready(frame);
  assert.equal((await state(frame)).event, 10);
});

story("keeping the page for later asks for no file a second time", {}, async ({ server, visitor }) => {
  const page = await (await visitor()).opens();
  await page.waitForFunction(isKept);
  const hashed = server.asked.map(({ path }) => path).filter((path) => /\.wasm\.gz$/.test(path));
  assert.equal(hashed.length, 1, hashed.join("\n"));
});

story("a newer version replaces the older one at the next visit, whole", {}, async ({ server, visitor }) => {
  const page = await (await visitor()).opens();
  await page.waitForFunction(isKept);
  server.folder = await newer(server.folder);
  const glue = await page.evaluate(() => globalThis.rayscopeHost.glue);
  const version = () => page.evaluate(() => document.body.dataset.version ?? "old");
  await page.evaluate(async () => {
    const taken = new Promise((resolve) => navigator.serviceWorker.addEventListener("controllerchange", resolve, { once: true }));
    await (await navigator.serviceWorker.ready).update();
    await taken;
  });
  // The open page still gets its own files, which the server has no more: a worker asks for them at any time.
  assert.equal((await page.evaluate(async (glue) => (await fetch(glue)).status, glue)), 200);
  assert.equal(await version(), "old");
  await page.reload();
  await ready(page);
  assert.equal(await version(), "new");
  await rm(server.folder, { recursive: true });
});

/** The same build as if it were a newer one: another first page, other bindings, and a service worker that knows them. */
async function newer(folder) {
  const copy = await mkdtemp(join(tmpdir(), "rayscope-newer-"));
  await cp(folder, copy, { recursive: true });
  const files = await readdir(join(copy, "files"));
  const renamed = files.filter((name) => /^(page|rayscope)\.[0-9a-f]{16}\.(html|js)$/.test(name));
  const names = renamed.map((name) => [name, name.replace(/\.[0-9a-f]{16}\./, ".0123456789abcdef.")]);
  for (const [before, after] of names) await rename(join(copy, "files", before), join(copy, "files", after));
  for (const path of ["index.html", "sw.js", "files/page.0123456789abcdef.html"]) {
    let text = await readFile(join(copy, path), "utf8");
    for (const [before, after] of names) text = text.replaceAll(before, after);
    text = text.replace("<body ", '<body data-version="new" ').replace(/(const VERSION = ")[0-9a-f]+/, "$10123456789abcdef");
    await writeFile(join(copy, path), text);
  }
  return copy;
}
