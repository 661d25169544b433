// What the page does for the program.

const problem = globalThis.rayscopeProblem;

/** The host object that the program finds as `rayscopeHost`: what is given, files, and the message for when it cannot go on. */
export function makeHost(given) {
  return { ...given, failed: (text) => problem("failed", text), save, open };
}

/** Downloads bytes as a file. */
function save(name, type, bytes) {
  const link = document.createElement("a");
  link.href = URL.createObjectURL(new Blob([bytes], { type }));
  link.download = name;
  link.click();
  // The download has begun when this task is over, but Safari reads the address a little later.
  setTimeout(() => URL.revokeObjectURL(link.href), 60_000);
}

/** Lets the reader choose a file; `given(name, bytes)` is not called at all if none is chosen. */
function open(accept, given) {
  const input = document.createElement("input");
  input.type = "file";
  input.accept = accept;
  input.addEventListener("change", async () => {
    const file = input.files[0];
    if (file) given(file.name, new Uint8Array(await file.arrayBuffer()));
  });
  input.click();
}
