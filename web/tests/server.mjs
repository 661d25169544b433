// A server as plain as a web host can be: files below a sub-path, no header but those that files cannot travel without.

import { createServer } from "node:http";
import { readFile } from "node:fs/promises";
import { extname, join, normalize } from "node:path";

/** What every server knows. It calls .wasm something that it is not, as many do. */
const TYPES = {
  ".html": "text/html", ".css": "text/css", ".js": "text/javascript", ".json": "application/json",
  ".svg": "image/svg+xml", ".png": "image/png", ".webp": "image/webp", ".txt": "text/plain",
};

const SUB_PATH = "/courses/graphics/";

/**
 * Serves a folder. `isPacking` sends the Brotli variants to those who take them, as hosts do that look for them; without, the
 * files go as they are. What was asked for is in `asked`: path, status and bytes of each answer; `folder` may be changed.
 */
export async function serve(folder, { isPacking = false } = {}) {
  const asked = [];
  const served = { folder };
  const server = createServer(async (request, response) => {
    const path = decodeURIComponent(new URL(request.url, "http://localhost").pathname);
    const found = path.startsWith(SUB_PATH) ? await read(served.folder, path.slice(SUB_PATH.length), isPacking && request) : null;
    const body = found?.body ?? Buffer.from("not here");
    asked.push({ path, status: found ? 200 : 404, bytes: body.length });
    const packed = found?.isPacked ? { "Content-Encoding": "br" } : {};
    response.writeHead(found ? 200 : 404, { "Content-Type": found?.type ?? "text/plain", "Content-Length": body.length, ...packed });
    response.end(body);
  });
  await new Promise((ready) => server.listen(0, "127.0.0.1", ready));
  const { port } = server.address();
  return Object.assign(served, {
    asked,
    address: `http://localhost:${port}${SUB_PATH}`,
    async close() {
      server.closeAllConnections();
      await new Promise((closed) => server.close(closed));
    },
  });
}

async function read(folder, path, packing) {
  const name = path === "" || path.endsWith("/") ? `${path}index.html` : path;
  const file = join(folder, normalize(`/${name}`));
  const type = TYPES[extname(file)] ?? "application/octet-stream";
  if (packing && /\bbr\b/.test(packing.headers["accept-encoding"] ?? "")) {
    const body = await readFile(`${file}.br`).catch(() => null);
    if (body) return { body, type, isPacked: true };
  }
  const body = await readFile(file).catch(() => null);
  return body && { body, type, isPacked: false };
}
