// Fetches the program and compiles it while it arrives.

/** Below this much a second request takes longer than it saves. */
const WORTH_ASKING = 1 << 18;

/**
 * The compiled program. `told(done)` is called with the bytes that have arrived, of those that it has unpacked.
 */
export async function compiledProgram(url, told) {
  const body = await arriving(url);
  const counted = body.pipeThrough(counting(told));
  // Many servers do not know what .wasm is and call it something else, which is refused; so the type is said here.
  return WebAssembly.compileStreaming(new Response(counted, { headers: { "Content-Type": "application/wasm" } }));
}

async function arriving(url) {
  const response = await asked(url);
  return (await packedInstead(url, response)) ?? response.body;
}

async function asked(url, options) {
  const response = await fetch(url, { credentials: "same-origin", ...options });
  if (!response.ok) throw new Error(`${url}: ${response.status} ${response.statusText}`);
  return response;
}

/**
 * A third as much travels from a server that sends files as they are, when the packed variant is asked for and unpacked here.
 * Nothing, if there is no such variant or no need.
 */
async function packedInstead(url, response) {
  const length = Number(response.headers.get("Content-Length") ?? 0);
  const isPlain = !response.headers.get("Content-Encoding") && length > WORTH_ASKING;
  const isKept = Boolean(navigator.serviceWorker?.controller);
  if (!isPlain || isKept || typeof DecompressionStream === "undefined") return null;
  try {
    const packed = await asked(`${url}.gz`);
    // Some servers say of .gz files that they are packed for the way, and the browser has unpacked them already.
    const isUnpacked = Boolean(packed.headers.get("Content-Encoding"));
    await response.body.cancel();
    return isUnpacked ? packed.body : packed.body.pipeThrough(new DecompressionStream("gzip"));
  } catch {
    return null;
  }
}

function counting(told) {
  let done = 0;
  return new TransformStream({
    transform(chunk, controller) {
      done += chunk.byteLength;
      told(done);
      controller.enqueue(chunk);
    },
  });
}
