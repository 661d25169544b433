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
run({ files, concurrency: 1 })
  .on("test:fail", () => { process.exitCode = 1; })
  .compose(new spec())
  .pipe(process.stdout);
