// Keeps the page for offline use. All files but this one and the first page have a hash of their content in their names, so
// versions never mix: a page gets exactly the files that it names, from whatever version's store holds them.

const VERSION = "{version}";
/** Stores belong to a whole host, which may have the page in several folders. */
const OURS = `rayscope ${self.registration.scope} `;
const STORE = OURS + VERSION;
/** The first page as it goes with these files; its own address may already mean a newer one. */
const PAGE = "{page}";
const FILES = [/* {files} */];

const address = (path) => new URL(path, self.registration.scope).href;

self.addEventListener("install", (event) => event.waitUntil(keepAll()));

async function keepAll() {
  const store = await caches.open(STORE);
  await Promise.all([PAGE, ...FILES].map((path) => keep(store, address(path))));
  // A page that is open goes on with its own files: the store of the version before is not emptied yet.
  await self.skipWaiting();
}

async function keep(store, url) {
  const kept = await caches.match(url);
  const response = kept && isHashed(url) ? kept : await fetched(url);
  if (!response.ok) throw new Error(`${url}: ${response.status}`);
  // A page that was reached by a redirection may not be shown for another address; a copy has forgotten it.
  await store.put(url, new Response(response.body, { headers: { "Content-Type": typeOf(url, response) } }));
}

/** What the page has just loaded is taken from where the browser has it, packed or not. */
async function fetched(url) {
  if (url.endsWith(".wasm") && typeof DecompressionStream !== "undefined") {
    const packed = await fetch(`${url}.gz`, { cache: "only-if-cached", mode: "same-origin" }).catch(() => null);
    if (packed?.ok && !packed.headers.get("Content-Encoding")) {
      return new Response(packed.body.pipeThrough(new DecompressionStream("gzip")));
    }
  }
  return fetch(url, { cache: isHashed(url) ? "force-cache" : "no-cache" });
}

const isHashed = (url) => /\/files\/.*\.[0-9a-f]{16}\.\w+$/.test(url);

const typeOf = (url, response) =>
  url.endsWith(".wasm") ? "application/wasm" : response.headers.get("Content-Type") ?? "application/octet-stream";

self.addEventListener("activate", (event) => event.waitUntil(takeOver()));

/** Pages of the version before may still ask for their files, a worker's for instance; those of older ones are gone. */
async function takeOver() {
  const stores = (await caches.keys()).filter((name) => name.startsWith(OURS) && name !== STORE);
  await Promise.all(stores.slice(0, -1).map((name) => caches.delete(name)));
  await self.clients.claim();
}

self.addEventListener("fetch", (event) => {
  const url = new URL(event.request.url);
  const path = url.origin + url.pathname;
  const isOurs = event.request.method === "GET" && path.startsWith(self.registration.scope);
  if (!isOurs) return;
  const rest = path.slice(self.registration.scope.length);
  if (rest === "" || rest === "index.html") event.respondWith(kept(address(PAGE), event.request));
  else if (isHashed(path)) event.respondWith(kept(path, event.request));
  else event.respondWith(newest(path, event));
});

async function kept(url, request) {
  return (await caches.match(url)) ?? fetch(request);
}

/**
 * What has no hash may have changed: the kept copy is for when there is no network. What lies beside the workbench, such as the
 * pages of a book, is kept once it was read.
 */
async function newest(url, event) {
  try {
    const response = await fetch(event.request);
    if (response.status === 200 && response.type === "basic") {
      const copy = response.clone();
      event.waitUntil(caches.open(STORE).then((store) => store.put(url, copy)));
    }
    return response;
  } catch (error) {
    const copy = await caches.match(url);
    if (copy) return copy;
    throw error;
  }
}
