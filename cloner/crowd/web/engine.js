"use strict";
// The engine of crowds: the module that Python runs too (cloner/behaviour/core), begun with the same numbers, so that it
// makes the same steps.

const LENT = { "<f8": Float64Array, "<f4": Float32Array, "<i4": Int32Array, "|b1": Uint8Array };

// `told` and `tables` are what cloner/behaviour/beginning.py tells; `core` has what core/engine.ts exports.
async function engineOf(module, told, tables) {
  const { instance } = await WebAssembly.instantiate(module, {}), core = instance.exports, rows = {};
  new Int32Array(core.memory.buffer, core.counts(), told.counts.length).set(told.counts);
  core.begin(...told.low, told.period_m, BigInt(told.seed));
  told.arrays.forEach(([name, kind, size], k) => { rows[name] = new LENT[kind](core.memory.buffer, core.at(k) >>> 0, size); });
  for (const [name, own] of Object.entries(tables)) rows[name].set(own);
  core.ready();
  return { core, rows };
}
