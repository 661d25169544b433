// What the page does for the program: files out and in, and workers.

import assert from "node:assert/strict";
import { readFile } from "node:fs/promises";
import { story } from "../browser.mjs";

story("what the program saves is downloaded under its name", {}, async ({ visitor }) => {
  const page = await (await visitor()).opens();
  const [download] = await Promise.all([
    page.waitForEvent("download"),
    page.evaluate(() => globalThis.rayscopeHost.save("bowl.json", "application/json", new TextEncoder().encode('{"α": 1}'))),
  ]);
  assert.equal(download.suggestedFilename(), "bowl.json");
  assert.equal(await readFile(await download.path(), "utf8"), '{"α": 1}');
});

story("a file that the reader chooses is given to the program with its name", {}, async ({ visitor }) => {
  const page = await (await visitor()).opens();
  const [chooser] = await Promise.all([
    page.waitForEvent("filechooser"),
    page.evaluate(() => {
      globalThis.rayscopeHost.open(".json", (name, bytes) => { globalThis.given = [name, new TextDecoder().decode(bytes)]; });
    }),
  ]);
  await chooser.setFiles({ name: "mine.json", mimeType: "application/json", buffer: Buffer.from("{}") });
  assert.deepEqual(await (await page.waitForFunction(() => globalThis.given)).jsonValue(), ["mine.json", "{}"]);
});

story("a worker gets the compiled program and says that it can answer", {}, async ({ server, visitor }) => {
  const page = await (await visitor()).opens();
  // What is kept for later is asked for at the same time; it is not what this is about.
  await page.waitForFunction(() => navigator.serviceWorker.ready.then(() => Boolean(navigator.serviceWorker.controller)));
  const before = server.asked.filter(({ path }) => path.includes(".wasm")).length;
  const said = await page.evaluate(() => new Promise((resolve, reject) => {
    const { worker, module, glue } = globalThis.rayscopeHost;
    const made = new Worker(worker, { type: "module" });
    made.onmessage = ({ data }) => resolve(data);
    made.onerror = (event) => reject(new Error(event.message));
    made.postMessage({ module, glue });
  }));
  assert.deepEqual(said, { ready: true });
  const after = server.asked.filter(({ path }) => path.includes(".wasm")).length;
  assert.equal(after, before, "the worker fetched the program again");
});
