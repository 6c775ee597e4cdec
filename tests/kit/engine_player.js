// Plays a scenario's beginning in node or a browser with the page's own host (crowd/web/engine.js), and keeps places.
const bytesIn = (text) => Uint8Array.from(atob(text), (one) => one.charCodeAt(0));

function textOf(bytes) {
  let text = "";
  for (let k = 0; k < bytes.length; k += 8192) text += String.fromCharCode(...bytes.subarray(k, k + 8192));
  return btoa(text);
}

async function play(log) {
  const tables = {};
  for (const [name, kind] of log.told.arrays) {
    if (log.tables[name]) tables[name] = new LENT[kind](bytesIn(log.tables[name]).buffer);
  }
  const { core, rows } = await engineOf(bytesIn(log.module), log.told, tables);
  const places = [], times = [];
  for (let step = 0; step < log.steps; step++) {
    for (const [at, order] of log.orders) if (at === step) core.guide(...order);
    const begun = performance.now();
    core.live();
    times.push(performance.now() - begun);
    if ((step + 1) % log.every === 0) places.push(textOf(new Uint8Array(core.memory.buffer, rows.place.byteOffset, rows.place.byteLength)));
  }
  return { places, mean_ms: times.reduce((a, b) => a + b, 0) / times.length, worst_ms: Math.max(...times) };
}
