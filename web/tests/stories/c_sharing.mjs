// Links, the ways back, and what is kept.

import assert from "node:assert/strict";
import { LONE, edit, rowsOf, send, story, until, untilRow } from "../browser.mjs";

const chosen = { do: "select", event: 10 };

story("the address is a link: in a fresh profile it opens the same scene, pixel and event", {}, async ({ visitor }) => {
  const page = await (await visitor()).opens();
  await send(page, { do: "open", link: "rayscope:csg/bowl?pixel=333,150" });
  await until(page, ({ pixel }) => pixel[0] === 333);
  await send(page, chosen);
  await page.waitForURL(/event=10\b/);
  const again = await (await visitor()).opens(new URL(page.url()).hash);
  const { scene, pixel } = await until(again, ({ event }) => event === 10);
  assert.deepEqual({ scene, pixel }, { scene: "csg/bowl", pixel: [333, 150] });
  assert.deepEqual(await rowsOf(again), await rowsOf(page));
});

story("an edited scene travels in the link", {}, async ({ visitor }) => {
  const page = await (await visitor()).opens();
  await edit(page, LONE);
  await untilRow(page, "lone");
  await page.waitForURL(/text=/);
  const again = await (await visitor()).opens(new URL(page.url()).hash);
  await untilRow(again, "lone");
});

story("back and forward go through the scenes that were opened", {}, async ({ visitor }) => {
  const page = await (await visitor()).opens();
  await send(page, { do: "open", link: "rayscope:optics/fishbowl" });
  await until(page, ({ scene }) => scene === "optics/fishbowl");
  await page.waitForURL(/fishbowl/);
  await page.goBack();
  await until(page, ({ scene }) => scene === "csg/bowl");
  await page.goForward();
  await until(page, ({ scene }) => scene === "optics/fishbowl");
});

story("a broken link opens the workbench and harms nothing", {}, async ({ visitor }) => {
  const page = await (await visitor()).opens("#rayscope:no/such/scene?pixel=1,2&event=%zz&text=!!");
  const { scene } = await until(page, ({ problem, scene }) => problem !== null && scene !== null);
  assert.equal(scene, "csg/bowl");
});
