// The first picture: when it comes, and what travels until then.

import assert from "node:assert/strict";
import { ready, rowsOf, state, story } from "../browser.mjs";

const MOST_BYTES = 3.5 * 1024 * 1024;

story("the first picture is there within three seconds, after at most 3.5 MiB", { isPacking: true }, async ({ server, visitor }) => {
  const { context } = await visitor();
  const page = await context.newPage();
  await page.addInitScript(() => {
    // The loading page makes way with the first picture.
    new MutationObserver((_, observer) => {
      if (!document.querySelector("#loading.leaving")) return;
      globalThis.firstPicture = performance.now();
      observer.disconnect();
    }).observe(document, { subtree: true, childList: true, attributes: true, attributeFilter: ["class"] });
  });
  await page.goto(server.address);
  await ready(page);
  const took = await page.evaluate(() => globalThis.firstPicture);
  const entries = await page.evaluate(() => performance.getEntries().filter((entry) => entry.startTime <= globalThis.firstPicture)
    .map((entry) => ({ bytes: entry.transferSize, name: entry.name })).filter((entry) => entry.bytes));
  const bytes = entries.reduce((sum, entry) => sum + entry.bytes, 0);
  console.log(`first picture after ${Math.round(took)} ms and ${bytes} bytes in ${entries.length} requests`);
  assert.ok(bytes > 0 && bytes <= MOST_BYTES, `${bytes} bytes travelled`);
  assert.ok(took <= 3000, `it took ${took} ms`);
});

story("a picture, a name and the bytes are shown while the program loads", {}, async ({ server, visitor }) => {
  const { context } = await visitor();
  const page = await context.newPage();
  let goOn;
  const held = new Promise((resolve) => { goOn = resolve; });
  await page.route("**/*.wasm*", async (route) => { await held; await route.continue(); });
  await page.goto(server.address, { waitUntil: "load" });
  await page.locator("#loading img").waitFor();
  assert.equal(await page.locator("#loading .name").textContent(), "rayscope");
  assert.ok(await page.locator("#loading img").evaluate((image) => image.complete && image.naturalWidth === 640));
  assert.equal(await page.locator("#bar").getAttribute("aria-label"), "Loading");
  goOn();
  await ready(page);
});

story("a server that packs nothing sends the packed program, and not the other as well", {}, async ({ server, visitor }) => {
  await (await visitor()).opens();
  const packed = server.asked.filter(({ path, status }) => path.endsWith(".wasm.gz") && status === 200);
  const { length } = server.asked.filter(({ path }) => path.endsWith(".wasm"));
  assert.equal(packed.length, 1);
  assert.equal(length, 1, "it is asked for once, to see how the server sends it");
});

story("the workbench speaks for itself: scene, pixel, event and rows", {}, async ({ visitor }) => {
  const page = await (await visitor()).opens();
  const { scene, pixel, event, events } = await state(page);
  assert.equal(scene, "csg/bowl");
  assert.equal(pixel.length, 2);
  assert.ok(event < events);
  const rows = await rowsOf(page);
  assert.match(rows[0], /^Pixel/);
  assert.ok(rows.length >= 4, `${rows.length} rows`);
});
