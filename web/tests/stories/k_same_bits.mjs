// Pictures and records have the same bits in the browser as on the desktop.

import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { join } from "node:path";
import { send, story, until } from "../browser.mjs";

const WIDTH = 64;
const rayscope = process.env.RAYSCOPE ?? join(import.meta.dirname, "../../../target/debug/rayscope");

/** The lines of each scene, by its name. */
function onTheDesktop() {
  const lines = execFileSync(rayscope, ["digest", "--width", String(WIDTH)], { encoding: "utf8", maxBuffer: 1 << 24 }).trim().split("\n");
  const scenes = new Map();
  for (const line of lines) {
    const scene = line.slice(17).replace(/(, \d+ wide| at \d+,\d+)$/, "");
    scenes.set(scene, [...(scenes.get(scene) ?? []), line]);
  }
  assert.ok(scenes.size > 50, `${scenes.size} scenes`);
  return scenes;
}

story("every scene has the same bits as on the desktop", { longest: 400_000 }, async ({ visitor }) => {
  const page = await (await visitor()).opens();
  await page.evaluate(() => {
    globalThis.rayscopeHost.tell = (json) => {
      const news = JSON.parse(json);
      if (news.type === "digests") globalThis.digests = news.lines;
    };
  });
  const different = [];
  for (const [scene, lines] of onTheDesktop()) {
    await send(page, { do: "open", link: `rayscope:${scene}` });
    await until(page, (told) => told.scene === scene && !told.opening);
    await page.evaluate(() => delete globalThis.digests);
    await send(page, { do: "digests", width: WIDTH });
    const here = await (await page.waitForFunction(() => globalThis.digests, null, { timeout: 60_000 })).jsonValue();
    different.push(...here.filter((line) => !lines.includes(line)));
    assert.equal(here.length, lines.length, scene);
  }
  assert.deepEqual(different, []);
});
