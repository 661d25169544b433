// Links, the ways back, and what is kept.

import assert from "node:assert/strict";
import { send, state, story, until } from "../browser.mjs";

const chosen = { do: "select", event: 10 };

story("the address is a link: in a fresh profile it opens the same scene, pixel and event", {}, async ({ visitor }) => {
  const page = await (await visitor()).opens();
  await send(page, { do: "open", link: "rayscope:csg/bowl?pixel=333,150" });
  await until(page, ({ pixel }) => pixel[0] === 333);
  await send(page, chosen);
  const told = await until(page, ({ event, link }) => event === 10 && link.includes("event=10"));
  assert.equal(`rayscope:${decodeURIComponent(new URL(page.url()).hash.slice(1))}`, decodeURIComponent(told.link));
  const again = await (await visitor()).opens(`#${told.link.slice("rayscope:".length)}`);
  const { scene, pixel, event, rows } = await until(again, ({ event }) => event === 10);
  assert.deepEqual({ scene, pixel, event, rows }, { scene: told.scene, pixel: told.pixel, event: told.event, rows: told.rows });
});

story("an edited scene travels in the link", {}, async ({ visitor }) => {
  const page = await (await visitor()).opens();
  await page.keyboard.press("Control+k");
  await page.keyboard.type("Scene file");
  await page.keyboard.press("Enter");
  await page.keyboard.press("Control+a");
  await page.keyboard.insertText('{ "objects": [{ "name": "lone", "shape": "sphere" }] }');
  const { link } = await until(page, ({ rows, link }) => rows.some((row) => row.includes("lone")) && link.includes("text="));
  const again = await (await visitor()).opens(`#${link.slice("rayscope:".length)}`);
  await until(again, ({ rows }) => rows.some((row) => row.includes("lone")));
});

story("back and forward go through the scenes that were opened", {}, async ({ visitor }) => {
  const page = await (await visitor()).opens();
  await send(page, { do: "open", link: "rayscope:optics/fishbowl" });
  await until(page, ({ scene }) => scene === "optics/fishbowl");
  await page.goBack();
  await until(page, ({ scene }) => scene === "csg/bowl");
  await page.goForward();
  await until(page, ({ scene }) => scene === "optics/fishbowl");
});

story("a broken link opens the workbench and harms nothing", {}, async ({ visitor }) => {
  const page = await (await visitor()).opens("#no/such/scene?pixel=1,2&event=%zz&text=!!");
  const { rows } = await state(page);
  assert.ok(rows.length > 0);
});
