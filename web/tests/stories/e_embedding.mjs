// Within other pages.

import assert from "node:assert/strict";
import { ready, state, story, until } from "../browser.mjs";

/** The example, with everything noted that its frames say. */
async function example(server, visitor) {
  const { context } = await visitor();
  const page = await context.newPage();
  await page.addInitScript(() => {
    if (window.parent !== window) return;
    globalThis.heard = [];
    addEventListener("message", ({ data }) => globalThis.heard.push(data));
  });
  await page.goto(`${server.address}examples/embed.html`);
  const frames = [];
  for (const iframe of await page.locator("iframe").all()) {
    await iframe.scrollIntoViewIfNeeded();
    const frame = await (await iframe.elementHandle()).contentFrame();
    await ready(frame);
    frames.push(frame);
  }
  return { page, frames };
}

story("three live steps stand in a chapter, each at its event", {}, async ({ server, visitor }) => {
  const { page, frames } = await example(server, visitor);
  const events = [];
  for (const frame of frames) events.push((await state(frame)).event);
  assert.deepEqual(events, [10, 6, 47]);
  assert.ok(await page.evaluate(() => document.activeElement === document.body), "a frame took the reader's place");
});

story("frames tell the page around that they are ready, where they are, and their size", {}, async ({ server, visitor }) => {
  const { page } = await example(server, visitor);
  const heard = (type) => page.waitForFunction((type) => globalThis.heard.find((data) => data.source === "rayscope" && data.type === type), type);
  await heard("ready");
  const size = await (await heard("size")).jsonValue();
  assert.deepEqual(size.least, [320, 240]);
  assert.ok(size.width >= 320 && size.height >= 240);
  await heard("step");
});

story("the buttons of the chapter step one frame and leave the others", {}, async ({ server, visitor }) => {
  const { page, frames } = await example(server, visitor);
  await page.locator("figure").first().getByRole("button", { name: "Next" }).click();
  await until(frames[0], ({ event }) => event !== 10);
  assert.equal((await state(frames[1])).event, 6);
});

story("what is no command, and what comes from elsewhere, is not obeyed", {}, async ({ server, visitor }) => {
  const { page, frames } = await example(server, visitor);
  const told = await page.evaluate(() => {
    const frame = document.querySelector("iframe").contentWindow;
    const bad = [null, 7, "next", { do: "toString" }, { do: "select", event: -1 }, { do: "select", event: "1" }, { do: "pixel", x: 1.5, y: 0 },
      { do: "open", link: "https://example.org" }, { do: "open", link: `rayscope:${"x".repeat(40_000)}` }, { do: "fail" }];
    for (const data of bad) frame.postMessage(data, "*");
    // Another frame is not the page around.
    return bad.length;
  });
  assert.ok(told > 0);
  await frames[1].evaluate(() => window.parent.frames[0].postMessage({ do: "next" }, "*"));
  // A command that is obeyed comes after all those; so they were all looked at when it shows.
  await page.evaluate(() => document.querySelector("iframe").contentWindow.postMessage({ do: "select", event: 12 }, "*"));
  await until(frames[0], ({ event }) => event === 12);
  assert.equal(await frames[0].evaluate(() => document.documentElement.dataset.problem ?? null), null);
});
