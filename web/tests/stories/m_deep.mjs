// Light that goes round for long: a browser's stack is small and does not grow.

import { edit, story, until, untilRow } from "../browser.mjs";

/** A closed room whose walls mirror nearly all of the light, so that only the limit ends a ray. */
const ROOM = JSON.stringify({
  camera: { eye: [0.1, 0.2, 0.3], look_at: [1, 0.3, 0.2] },
  image: { width: 8, height: 6 },
  ambient: [1, 1, 1],
  limits: { depth: 10_000, contribution: 0 },
  materials: { mirror: { ambient: [0.0002, 0.0002, 0.0002], diffuse: [0, 0, 0], reflectivity: 0.9998 } },
  objects: [{ shape: "cube", name: "room of mirrors", material: "mirror", transform: [{ scale: 3 }] }],
});

story("a ray that is mirrored 10,000 times is drawn and told to its end", {}, async ({ visitor }) => {
  const page = await (await visitor()).opens();
  await edit(page, ROOM);
  await untilRow(page, "room of mirrors");
  // Each reflection is told by more than ten events.
  await until(page, ({ events, edited, finished, problem }) => events > 100_000 && edited && finished && problem === null);
});
