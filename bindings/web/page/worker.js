// The web worker: holds the program and answers one request after the other. The page puts it after the binding, which
// defines `wasm_bindgen`.

/** @type {any} */
let door = null;

self.onmessage = async ({ data }) => {
  try {
    if (data.program) {
      const stream = new Blob([data.program]).stream().pipeThrough(new DecompressionStream('gzip'));
      const bytes = await new Response(stream).arrayBuffer();
      await wasm_bindgen({ module_or_path: bytes });
      door = new wasm_bindgen.Door();
      self.postMessage({ ready: true });
      return;
    }
    const start = performance.now();
    const answer = door.answer(data.request, data.bytes ?? new Uint8Array());
    const buffers = [];
    for (let k = 0; k < door.buffers(); k++) buffers.push(door.take(k));
    const milliseconds = performance.now() - start;
    const transfer = buffers.map((buffer) => buffer.buffer);
    self.postMessage({ id: data.id, answer, buffers, milliseconds }, { transfer });
  } catch (error) {
    // After a trap the memory of the program is in an unknown state: the page starts another worker.
    self.postMessage({ id: data.id, failed: String(error) });
  }
};
