// Probes for crowd_card.py, run in the page of a pack: times of frames, a card's own times, frames a second as shown, a scene
// without its people. Never shipped.
window.burst = (most, seconds) => {
  const gl = renderer.getContext(), pixel = new Uint8Array(4);
  const wait = () => gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
  const rounds = [], choices = [], asks = [];
  draw(); wait(); draw(); wait();
  const one = performance.now(); draw(); wait();
  const frames = Math.max(1, Math.min(most, Math.floor((seconds * 1000) / (5 * Math.max(performance.now() - one, 0.1)))));
  for (let round = 0; round < 5; round++) {
    const begun = performance.now();
    for (let k = 0; k < frames; k++) { state.now += 1 / 60; const at = performance.now(); draw(); asks.push(performance.now() - at); choices.push(state.stats.choice); }
    wait();
    rounds.push((performance.now() - begun) / frames);
  }
  const middle = (list) => list.sort((a, b) => a - b)[list.length >> 1], high = (list) => list[Math.floor(list.length * 0.9)];
  return { ms: Math.min(...rounds), rounds, frames, choice: middle(choices), choice_high: high(choices), asked: middle(asks),
           counts: state.stats.counts, draws: state.stats.draws, triangles: state.stats.triangles };
};
window.cardTime = async (times) => {
  const gl = renderer.getContext(), timer = gl.getExtension("EXT_disjoint_timer_query_webgl2"), found = [];
  if (!timer) return null;
  for (let k = 0; k < times; k++) {
    const query = gl.createQuery();
    gl.beginQuery(timer.TIME_ELAPSED_EXT, query); draw(); gl.endQuery(timer.TIME_ELAPSED_EXT); gl.flush();
    const end = performance.now() + 4000;
    while (!gl.getQueryParameter(query, gl.QUERY_RESULT_AVAILABLE) && performance.now() < end) await new Promise((done) => setTimeout(done, 1));
    if (gl.getQueryParameter(query, gl.QUERY_RESULT_AVAILABLE) && !gl.getParameter(timer.GPU_DISJOINT_EXT)) found.push(gl.getQueryParameter(query, gl.QUERY_RESULT) / 1e6);
    gl.deleteQuery(query);
  }
  return found.length ? found.sort((a, b) => a - b)[found.length >> 1] : null;
};
window.shown = (seconds) => new Promise((done) => {
  const gl = renderer.getContext(), pixel = new Uint8Array(4), begun = performance.now();
  let frames = 0;
  const next = () => {
    if (performance.now() - begun > seconds * 1000) return done((frames * 1000) / (performance.now() - begun));
    state.now += 1 / 60; draw(); gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel); frames++;
    requestAnimationFrame(next);
  };
  requestAnimationFrame(next);
});
window.nobody = () => {
  window.choose = () => tiers.slice(0, LEVELS + 2).forEach((mesh) => { mesh.geometry.instanceCount = 0; mesh.visible = false; });
  state.stats.counts = [];
  if (passes) passes.cast = () => {};
};
0;
