// With the keyboard alone, and with a screen reader.

import assert from "node:assert/strict";
import { send, state, story, until, untilRow } from "../browser.mjs";

const rows = (page) => page.getByRole("treeitem");

story("the mirror has the rows of the story as a tree, and the selected event as text", {}, async ({ visitor }) => {
  const page = await (await visitor()).opens();
  await send(page, { do: "pixel", x: 333, y: 150 });
  await until(page, ({ pixel }) => pixel[0] === 333);
  await untilRow(page, "(333, 150)");
  const texts = await rows(page).allTextContents();
  for (const said of [/^Pixel \(333, 150\)/, /^Camera ray/, /bowl/, /^hit surface of S₂ in bowl/, /^the pixel as written/]) {
    assert.equal(texts.filter((text) => said.test(text)).length >= 1, true, `${said} in ${texts.join("\n")}`);
  }
  const levels = await rows(page).evaluateAll((items) => items.map((item) => Number(item.ariaLevel)));
  assert.equal(levels[0], 1);
  assert.ok(levels.slice(1).every((level, i) => level >= 1 && level <= levels[i] + 1), "a level is left out");
  await page.waitForFunction(() => document.querySelectorAll('#rows [aria-selected="true"]').length === 1);
  assert.ok((await page.locator("#event h2").textContent()).length > 0);
  assert.ok(await page.locator("#event p").count() > 0);
});

story("only what changed is written anew, and the reader's place stays", {}, async ({ visitor }) => {
  const page = await (await visitor()).opens();
  await page.waitForFunction(() => document.querySelectorAll("#rows li").length > 2);
  await page.evaluate(() => { document.querySelector("#rows li").dataset.seen = "yes"; });
  await send(page, { do: "next" });
  await page.waitForFunction(() => document.querySelector('#rows [aria-selected="true"]'));
  assert.equal(await page.locator("#rows li").first().getAttribute("data-seen"), "yes");
});

story("with the keyboard alone one gets from loading to an event and its numbers", {}, async ({ visitor }) => {
  const page = await (await visitor()).opens();
  await page.waitForFunction(() => document.querySelectorAll("#rows li").length > 2);
  await page.keyboard.press("F9");
  await page.keyboard.press("Home");
  await until(page, ({ event }) => event === 0);
  await page.keyboard.press("ArrowDown");
  const { event } = await until(page, ({ event }) => event > 0);
  await page.waitForFunction((event) => document.activeElement.dataset.event === String(event), event);
  await page.keyboard.press("Enter");
  assert.equal(await page.evaluate(() => document.activeElement.closest("#event") !== null), true);
  await page.keyboard.press("Escape");
  assert.equal(await page.evaluate(() => document.activeElement.closest("#stage") !== null), true);
  await page.keyboard.press("n");
  await until(page, (told) => told.event !== event);
  assert.ok((await state(page)).events > 0);
});

story("the story is out of sight until the keyboard is in it", {}, async ({ visitor }) => {
  const page = await (await visitor()).opens();
  const width = () => page.locator("#story").evaluate((element) => element.getBoundingClientRect().width);
  assert.ok(await width() <= 1);
  await page.keyboard.press("F9");
  assert.ok(await width() >= 300);
});

story("a reader of German is told of the page in German", { context: { locale: "de-DE" } }, async ({ visitor }) => {
  const page = await (await visitor()).opens();
  assert.equal(await page.evaluate(() => document.documentElement.lang), "de");
  assert.match(await page.locator("#workbench").getAttribute("aria-label"), /Werkbank/);
});

story("every word of the page is there in every language", {}, async ({ visitor }) => {
  const page = await (await visitor()).opens();
  const { en, de } = await page.evaluate(() => globalThis.rayscopeWords.all);
  assert.deepEqual(Object.keys(de), Object.keys(en));
  const values = (text) => (text.match(/\{\w+\}/g) ?? []).sort();
  for (const name of Object.keys(en)) assert.deepEqual(values(de[name]), values(en[name]), name);
});
