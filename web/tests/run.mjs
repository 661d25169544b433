// Runs all stories against a built folder: `node run.mjs DIST [PART OF A FILE NAME]`. The program on the desktop that pictures are
// compared with is `target/debug/rayscope`, as `cargo build` makes it, or what RAYSCOPE names.

import { readdirSync, existsSync } from "node:fs";
import { join, resolve } from "node:path";
import { run } from "node:test";
import { spec } from "node:test/reporters";

const [dist, part = ""] = process.argv.slice(2);
if (!dist || !existsSync(join(dist, "index.html"))) {
  console.error(`${dist ?? "no folder"}: there is no index.html. Build the pages first, and name their folder: node run.mjs DIST`);
  process.exit(2);
}
process.env.RAYSCOPE_DIST = resolve(dist);

const folder = join(import.meta.dirname, "stories");
const files = readdirSync(folder).filter((name) => name.includes(part)).sort().map((name) => join(folder, name));
// One after the other: times are measured, and the machine may have two cores.
const failed = [];
for (const file of files) {
  if (await told(file)) continue;
  console.log("\nOnce more, for the machine may have been busy with something else:\n");
  if (!(await told(file))) failed.push(file);
}
if (failed.length > 0) {
  console.error(`\nfailed twice:\n${failed.join("\n")}`);
  process.exitCode = 1;
}

/** Runs the stories of a file; whether none failed. */
function told(file) {
  let isGood = true;
  const stories = run({ files: [file] });
  stories.on("test:fail", () => { isGood = false; });
  const ended = new Promise((end) => stories.on("end", end));
  stories.compose(new spec()).pipe(process.stdout, { end: false });
  return ended.then(() => isGood);
}
