// Looking at a ray: a click, steps, an edit, a lesson.

import assert from "node:assert/strict";
import { LONE, edit, placeOf, send, story, until, untilRow } from "../browser.mjs";

story("a click on a pixel tells the story of that pixel", {}, async ({ visitor }) => {
  const page = await (await visitor()).opens();
  for (const pixel of [[333, 150], [60, 400]]) {
    const { x, y } = await placeOf(page, pixel);
    await page.mouse.click(x, y);
    const told = await until(page, (told) => told.pixel.every((at, i) => Math.abs(at - pixel[i]) <= 2));
    await untilRow(page, `(${told.pixel.join(", ")})`);
  }
});

story("a click through the opening of the bowl ends on the wall behind", {}, async ({ visitor }) => {
  const page = await (await visitor()).opens();
  await send(page, { do: "pixel", x: 333, y: 150 });
  await until(page, ({ pixel }) => pixel[0] === 333 && pixel[1] === 150);
  await untilRow(page, /^hit surface of S₂ in bowl/);
});

story("keys step through the story, on and back", {}, async ({ visitor }) => {
  const page = await (await visitor()).opens();
  await send(page, { do: "pixel", x: 333, y: 150 });
  await until(page, ({ pixel }) => pixel[0] === 333);
  await send(page, { do: "select", event: 0 });
  await until(page, ({ event }) => event === 0);
  await page.keyboard.press("n");
  const { event } = await until(page, ({ event }) => event > 0);
  await page.keyboard.press("n");
  await until(page, (told) => told.event > event);
  await page.keyboard.press("b");
  await until(page, (told) => told.event === event);
});

story("what is typed into the scene file shows in the picture and the story", {}, async ({ visitor }) => {
  const page = await (await visitor()).opens();
  await edit(page, LONE);
  await untilRow(page, "lone");
  await until(page, ({ edited, problem }) => edited && problem === null);
});

story("a question of a lesson is answered, and the answer judged", {}, async ({ visitor }) => {
  const page = await (await visitor()).opens();
  await page.evaluate(() => {
    globalThis.heard = [];
    globalThis.rayscopeHost.tell = (json) => globalThis.heard.push(JSON.parse(json));
  });
  await send(page, { do: "lesson", lesson: "01_six_steps", step: 1 });
  await until(page, ({ lesson, questions }) => lesson === "01_six_steps" && questions > 0);
  await send(page, { do: "answer", question: 0, answer: 0 });
  const answer = await (await page.waitForFunction(() => globalThis.heard.find(({ type }) => type === "answer"))).jsonValue();
  assert.deepEqual({ lesson: answer.lesson, tries: answer.tries }, { lesson: "01_six_steps", tries: 1 });
});
