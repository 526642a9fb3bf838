// Unpacks the program; all communication with it goes through call().

const program = (() => {
  const encoder = new TextEncoder();
  const decoder = new TextDecoder();
  let wasm = null;
  let told = 0;

  const memory = (at, length) => new Uint8Array(wasm.memory.buffer, at >>> 0, length);
  const random = (at, length) => {
    crypto.getRandomValues(memory(at, length));
    return length;
  };
  // The functions that SQLite needs from its host. `random` returns the number of bytes; from the
  // other functions 0 means "done" and 1 "not supported".
  const host = {
    rust_sqlite_wasm_host_sleep() {},
    rust_sqlite_wasm_host_random: random,
    rust_sqlite_wasm_host_fill_entropy: (at, length) => (random(at, length), 0),
    rust_sqlite_wasm_host_epoch_timestamp_in_ms(at) {
      new DataView(wasm.memory.buffer).setBigInt64(at >>> 0, BigInt(Date.now()), true);
      return 0;
    },
    rust_sqlite_wasm_host_localtime: () => 1,
  };

  // The bytes of a base64 string. Older browsers, such as Chrome before 140, have no function for
  // it.
  function bytesOf(text) {
    if (Uint8Array.fromBase64) return Uint8Array.fromBase64(text);
    const letters = atob(text);
    const bytes = new Uint8Array(letters.length);
    for (let i = 0; i < letters.length; i++) bytes[i] = letters.charCodeAt(i);
    return bytes;
  }

  // Compiles the program while it is being unpacked.
  async function load() {
    const packed = bytesOf(document.getElementById("program").textContent.trim());
    const unpacking = new Blob([packed]).stream().pipeThrough(new DecompressionStream("gzip"));
    const answer = new Response(unpacking, { headers: { "Content-Type": "application/wasm" } });
    const { instance } = await WebAssembly.instantiateStreaming(answer, { env: host });
    wasm = instance.exports;
  }

  // Sends a command, followed by bytes of files; returns the reply, with its bytes.
  function call(command, bytes) {
    // A newly opened program does not know the time.
    if (command.do === "open") told = 0;
    const json = encoder.encode(JSON.stringify(command));
    const length = json.length + (bytes ? 1 + bytes.length : 0);
    const room = memory(wasm.carrom_room(length), length);
    room.set(json);
    if (bytes) room.set(bytes, json.length + 1);
    const size = wasm.carrom_call();
    const answer = memory(wasm.carrom_reply(), size);
    const end = answer.indexOf(0);
    const reply = JSON.parse(decoder.decode(end < 0 ? answer : answer.subarray(0, end)));
    reply.bytes = end < 0 ? new Uint8Array() : answer.slice(end + 1);
    return reply;
  }

  // Sends the time, and the number of seconds by which local time is ahead of UTC.
  function tellTime() {
    const now = Date.now();
    if (now - told < 500) return;
    told = now;
    const offset_s = -60 * new Date().getTimezoneOffset();
    call({ do: "now", time_s: Math.floor(now / 1000), offset_s });
  }

  const cells = (count) => new Uint32Array(wasm.memory.buffer, wasm.carrom_cells() >>> 0, 4 * count);

  return { load, call, cells, tellTime };
})();
