// A host of the walkers' core for node and browsers: tells it what a log of Python's host says, and keeps the places.
"use strict";

const KINDS = { "<f8": Float64Array, "<i4": Int32Array, "|b1": Uint8Array };
const bytesOf = (text) => Uint8Array.from(atob(text), (one) => one.charCodeAt(0));

function textOf(bytes) {
  let text = "";
  for (let k = 0; k < bytes.length; k += 8192) text += String.fromCharCode(...bytes.subarray(k, k + 8192));
  return btoa(text);
}

async function play(log) {
  const { instance } = await WebAssembly.instantiate(bytesOf(log.module), {});
  const core = instance.exports;
  core.begin(...log.begin, BigInt(log.seed));
  const rows = {};
  for (const [name, bytes] of Object.entries(log.arrays)) {
    const [number, kind] = log.kinds[name], data = bytesOf(bytes);
    const at = core.at(number) >>> 0, type = KINDS[kind];
    new Uint8Array(core.memory.buffer, at, data.length).set(data);
    rows[name] = new type(core.memory.buffer, at, data.length / type.BYTES_PER_ELEMENT);
  }
  core.ready();
  const places = [], times = [];
  let next = 0;
  for (let step = 0; step < log.steps; step++) {
    for (; next < log.changes.length && log.changes[next][0] === step; next++) {
      const [, name, k, value] = log.changes[next];
      rows[name][k] = value;
    }
    const begun = performance.now();
    core.step();
    times.push(performance.now() - begun);
    if ((step + 1) % log.every === 0) {
      places.push(textOf(new Uint8Array(core.memory.buffer, rows.place.byteOffset, rows.place.byteLength)));
    }
  }
  return { places, mean_ms: times.reduce((a, b) => a + b, 0) / times.length, worst_ms: Math.max(...times) };
}
