// The web worker: holds the program and answers one request after the other. The page puts it after the binding, which
// defines `wasm_bindgen`.

/** @type {any} */
let door = null;

/** The bytes of a text in base64. @param {string} text */
function decoded(text) {
  const binary = atob(text.trim());
  const bytes = new Uint8Array(binary.length);
  for (let k = 0; k < binary.length; k++) bytes[k] = binary.charCodeAt(k);
  return bytes;
}

/** Starts the program, which is compressed. @param {string} text */
async function start(text) {
  // Not from a Blob: WebKit does not let a worker of a page from disk read one.
  const { writable, readable } = new DecompressionStream('gzip');
  const writer = writable.getWriter();
  const written = writer.write(decoded(text)).then(() => writer.close());
  const program = await new Response(readable).arrayBuffer();
  await written;
  await wasm_bindgen({ module_or_path: program });
  door = new wasm_bindgen.Door();
}

/** Ends when the program has started; requests wait for it. @type {Promise<void> | null} */
let started = null;

self.onmessage = async ({ data }) => {
  try {
    if (data.program) {
      started = start(data.program);
      await started;
      return;
    }
    await started;
    const begin = performance.now();
    const answer = door.answer(data.request, data.bytes ?? new Uint8Array());
    const buffers = [];
    for (let k = 0; k < door.buffers(); k++) buffers.push(door.take(k));
    const milliseconds = performance.now() - begin;
    const transfer = buffers.map((buffer) => buffer.buffer);
    self.postMessage({ id: data.id, answer, buffers, milliseconds }, { transfer });
  } catch (error) {
    // After a trap the memory of the program is in an unknown state: the page starts another worker.
    self.postMessage({ id: data.id, failed: String(error) });
  }
};
