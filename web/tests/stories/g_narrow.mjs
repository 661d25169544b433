// A phone: narrow, touched, with many pixels to a point.

import assert from "node:assert/strict";
import { placeOf, state, story, until } from "../browser.mjs";

// The browser's stand-in for a phone does not tell a canvas how many pixels it has, as a phone does: so it has one to a point.
const phone = { viewport: { width: 360, height: 740 }, hasTouch: true, isMobile: true };

story("on a phone the workbench fills the screen, and nothing scrolls beside it", { context: phone }, async ({ visitor }) => {
  const page = await (await visitor()).opens();
  const canvas = await page.locator("#workbench").evaluate((canvas) => ({ width: canvas.width, height: canvas.height, css: [canvas.clientWidth, canvas.clientHeight] }));
  assert.deepEqual(canvas.css, [360, 740]);
  assert.deepEqual([canvas.width, canvas.height], [360, 740]);
  assert.ok(await page.evaluate(() => document.documentElement.scrollWidth <= innerWidth && document.documentElement.scrollHeight <= innerHeight));
});

story("a tap on a pixel tells its story", { context: phone }, async ({ visitor }) => {
  const page = await (await visitor()).opens();
  const { x, y } = await placeOf(page, [200, 300]);
  await page.touchscreen.tap(x, y);
  await until(page, ({ pixel, size, picture }) => Math.abs(pixel[0] - 200) <= (2 * size[0]) / picture[2] && Math.abs(pixel[1] - 300) <= (2 * size[1]) / picture[3]);
});

story("a long press is the second button and selects nothing of the page", { context: phone }, async ({ visitor }) => {
  const { context, opens } = await visitor();
  const page = await opens();
  const before = (await state(page)).pixel;
  const { x, y } = await placeOf(page, [120, 120]);
  const touch = await context.newCDPSession(page);
  await touch.send("Input.dispatchTouchEvent", { type: "touchStart", touchPoints: [{ x, y }] });
  await page.waitForFunction((start) => performance.now() - start > 900, await page.evaluate(() => performance.now()));
  await touch.send("Input.dispatchTouchEvent", { type: "touchEnd", touchPoints: [] });
  assert.equal(await page.evaluate(() => String(getSelection())), "");
  assert.deepEqual((await state(page)).pixel, before);
});
