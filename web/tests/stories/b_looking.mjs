// Looking at a ray: a click, steps, an edit, a lesson.

import assert from "node:assert/strict";
import { placeOf, send, state, story, until } from "../browser.mjs";

story("a click on a pixel tells the story of that pixel", {}, async ({ visitor }) => {
  const page = await (await visitor()).opens();
  for (const pixel of [[333, 150], [60, 400]]) {
    const { x, y } = await placeOf(page, pixel);
    await page.mouse.click(x, y);
    const told = await until(page, (told) => told.pixel.every((at, i) => Math.abs(at - pixel[i]) <= 2));
    assert.match(told.rows[0], new RegExp(`${told.pixel[0]}, ${told.pixel[1]}`));
  }
});

story("a click through the opening of the bowl ends on the wall behind", {}, async ({ visitor }) => {
  const page = await (await visitor()).opens();
  await send(page, { do: "pixel", x: 333, y: 150 });
  const { rows } = await until(page, ({ pixel }) => pixel[0] === 333 && pixel[1] === 150);
  assert.ok(rows.some((row) => row.includes("S₂")), rows.join("\n"));
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
  await page.keyboard.press("p");
  await until(page, (told) => told.event === event);
});

story("what is typed into the scene file shows in the picture and the story", {}, async ({ visitor }) => {
  const page = await (await visitor()).opens();
  await command(page, "Scene file");
  await page.keyboard.press("Control+a");
  const scene = { title: "Only a ball", camera: { eye: [0, -5, 0], target: [0, 0, 0] }, objects: [{ name: "lone", shape: "sphere" }] };
  await page.keyboard.insertText(JSON.stringify(scene));
  const told = await until(page, ({ rows }) => rows.some((row) => row.includes("lone")));
  assert.ok(told.events > 3);
});

story("a question of a lesson is answered, and the answer judged", {}, async ({ visitor }) => {
  const page = await (await visitor()).opens();
  await send(page, { do: "open", link: "rayscope:lesson/01_six_steps" });
  const { lesson } = await until(page, ({ lesson }) => Boolean(lesson));
  assert.equal(lesson, "01_six_steps");
  const before = JSON.stringify((await state(page)).progress);
  await send(page, { do: "answer", question: 0, answer: 0 });
  await until(page, ({ progress }) => JSON.stringify(progress) !== before);
});

/** Chooses a command by its name, as a reader does who knows no other way. */
async function command(page, name) {
  await page.keyboard.press("Control+k");
  await page.keyboard.type(name);
  await page.keyboard.press("Enter");
}
