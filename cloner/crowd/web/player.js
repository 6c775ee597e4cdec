"use strict";
// The crowd: who is seen and as what, cameras, knobs. window.crowd lets tests and curious people in.

const { facts, shaders } = JSON.parse(document.querySelector("#facts").textContent);
const say = (text) => { document.querySelector("#status").textContent = text; };
const LEVELS = facts.tiers.length, IMPOSTOR = LEVELS, HIDDEN = LEVELS + 1;
const HYSTERESIS = 0.05, FADE_S = 0.3, CELL_M = 16, REBIN_FRAMES = 12, MOST = 100000; // fade: taste
const STATURE_M = 1.75, ARM_M = 0.45; // nobody walks nearer to anybody: taste

const state = {
  scene: facts.scene, people: facts.people_count, now: 0, paused: false, debug: 0, mode: "hybrid", camera: "orbit",
  stats: {}, still: 0, hour: DAY, blocks: false, shown: null, whole: false, // whole: the impostors of all who are far are there
};
const canvas = document.querySelector("canvas");
let acted = null, blocks = null, room = null, passes = null, staging = null, sound = null, echo = null, live = null, minds = null;
let spoken = null, voices = {}, feelings = null;
let renderer, stage, uniforms, world, camera, controls, tiers, walkers, keys = new Set(), fly = { yaw: 0, pitch: 0 };

function open() {
  const context = canvas.getContext("webgl2", { antialias: true, powerPreference: "high-performance" });
  if (!context) return say("This browser has no WebGL2: the crowd cannot be shown here. Try a current Chrome, Firefox or Safari.");
  renderer = new THREE.WebGLRenderer({ canvas, context });
  renderer.info.autoReset = false;
  renderer.setClearColor(0xccd6e0, 1);
  camera = new THREE.PerspectiveCamera(45, 1, 0.1, 1200);
  controls = new THREE.OrbitControls(camera, canvas);
  controls.maxPolarAngle = Math.PI * 0.495;
  return start(context);
}

async function start(context) {
  stage = await loadStage(facts, (k, n) => say(`Loading ${k} of ${n}…`));
  if (facts.compressed && !facts.live) state.blocks = smaller(stage.textures, context);
  const numbers = facts.numbers, sun = new THREE.Vector3(...numbers.sun).normalize();
  uniforms = {
    people: { value: null }, now: { value: 0 }, laneLength: { value: 100 }, clipFromWorld: { value: new THREE.Matrix4() },
    eye: { value: new THREE.Vector3() }, focalPx: { value: 900 }, debugView: { value: 0 },
    rim: { value: 0 }, bakedFrom: { value: facts.impostors.baked_from_m }, sunWay: { value: sun },
    boxMin: { value: numbers.box_min_m }, boxStep: { value: numbers.box_step_m },
    boneReach: { value: numbers.bone_reach_m }, codeStep: { value: numbers.code_step },
    bodyVertices: { value: stage.body.uv.length / 2 }, depthRange: { value: facts.impostors.depth_range_m },
    rings: { value: facts.impostors.rings_deg.length }, classic: { value: facts.impostors.classic ? 1 : 0 },
    ringElevations: { value: [0, 1, 2, 3].map((k) => ((facts.impostors.rings_deg[k] || 0) * Math.PI) / 180) },
    dearFromPx: { value: 24 }, ...lightUniforms(),
    glow: { value: flatTexture(new Float32Array(4), 1, 1, FLOATS) }, ...faceUniforms(),
  };
  for (const [name, texture] of Object.entries(stage.textures)) uniforms[name] = { value: texture };
  if (facts.statues) uniforms.stoneColour.value.set(...facts.statues.colour);
  if (facts.faces) {
    dressFaces(uniforms, stage.body, stage.people);
    if (facts.acted) feelings = feelingsOf(facts.acted.people);
  }
  if (facts.spoken) {
    spoken = spokenOf(facts.spoken.said, (await arraysOf(bytesOf("spoken.bin"), facts.spoken.arrays)).weights);
    for (const { sound: name } of spoken.said) if (name && !voices[name]) voices[name] = bytesOf(name);
  }
  const arrays = facts.acted ? await arraysOf(bytesOf("acted.bin"), facts.acted.arrays) : null;
  if (arrays) acted = actedOf(arrays, facts.people.length);
  if (facts.staging) staging = stagingOf(facts.staging, facts.people.map((one) => one.stature_m));
  buildTiers();
  if (arrays && arrays.blocks.length) buildBlocks(arrays.blocks);
  if (facts.room) {
    if (facts.room.echo) echo = bytesOf("room_echo.wav");
    room = await loadRoom(facts.room, shaders, uniforms);
    passes = lightPasses(facts, stage.body, shaders, uniforms);
    world.add(room.mesh, passes.sky);
  }
  setScene(state.scene, state.people);
  if (directed()) setCamera("film");
  const statues = acted ? statuesOf(facts.staging && facts.staging.things ? facts.staging : null, staging, acted) : null;
  if (held.has("minds.bin")) {
    const engine = bytesOf("engine.wasm"), tables = await arraysOf(bytesOf("minds.bin"), facts.scenario.arrays);
    if (facts.live) live = liveOf(statues, engine, tables);
    else minds = mindsOf(engine, facts.scenario, tables, acted, statues);
  }
  buildKnobs();
  resize();
  view("overview");
  say("");
  renderer.setAnimationLoop((time) => frame(time / 1000));
  await new Promise((shown) => { state.shown = shown; });
  document.body.dataset.shown = "yes";
  for (const [name, texture] of Object.entries(await stage.far())) {
    uniforms[name].value.dispose();
    uniforms[name].value = state.blocks && name === "colours" ? blockTexture(texture, true) : texture;
  }
  state.whole = true;
  if (minds) minds.prepare();
  document.body.dataset.ready = "yes";
}

function instancesOf(count) {
  const attribute = new THREE.InstancedBufferAttribute(new Float32Array(2 * count), 2);
  attribute.setUsage(35048); // dynamic
  return attribute;
}

function buildTiers() {
  world = new THREE.Scene();
  tiers = [];
  const add = (geometry, material, order) => {
    const mesh = new THREE.Mesh(geometry, material);
    mesh.frustumCulled = false;
    mesh.renderOrder = order;
    world.add(mesh);
    tiers.push(mesh);
    return mesh;
  };
  for (let level = 0; level < LEVELS; level++) {
    const { geometry, start, triangles } = levelGeometry(facts, stage.body, level, instancesOf(MOST));
    const own = { ...uniforms, looseStart: { value: start }, coarse: { value: level >= 2 ? 1 : 0 } };
    add(geometry, materialOf(shaders, ["common.glsl", "person.vert"],
      ["common.glsl", "light.glsl", "shading.glsl", "worn.glsl", "person.frag"], own, { side: THREE.FrontSide }), 0).userData.triangles = triangles;
  }
  const far = (rim, options) => materialOf(shaders, ["common.glsl", "impostor.vert"],
    ["common.glsl", "light.glsl", "shading.glsl", "impostor.frag"], { ...uniforms, rim: { value: rim } }, options);
  const whole = add(quadGeometry(instancesOf(MOST)), far(0), 1);
  whole.userData.triangles = 4; // drawn twice
  const rims = new THREE.Mesh(whole.geometry, far(1, { transparent: true, depthWrite: false, depthFunc: 2 })); // less
  rims.frustumCulled = false;
  rims.renderOrder = 4;
  world.add(rims);
  const shadows = add(quadGeometry(instancesOf(MOST)), materialOf(shaders, ["common.glsl", "ground.vert"], ["light.glsl", "ground.frag"],
    uniforms, { transparent: true, depthWrite: false }), 3);
  shadows.userData.triangles = 2;
  const floor = add(quadGeometry(instancesOf(1)), materialOf(shaders, ["common.glsl", "ground.vert"], ["light.glsl", "ground.frag"],
    uniforms), 2); // behind people nothing of it is shaded
  floor.geometry.attributes.instance.array[0] = -1;
  floor.geometry.instanceCount = 1;
  floor.userData.triangles = 2;
}

// What stands in the way of those who act: corners and normals of triangles.
function buildBlocks(corners) {
  const geometry = new THREE.InstancedBufferGeometry(), part = (first) =>
    new THREE.BufferAttribute(corners.filter((_, k) => Math.floor((k % 6) / 3) === first), 3);
  geometry.setAttribute("position", part(0));
  geometry.setAttribute("normal", part(1));
  geometry.instanceCount = 1;
  blocks = new THREE.Mesh(geometry, materialOf(shaders, ["block.vert"], ["light.glsl", "shading.glsl", "block.frag"], uniforms));
  blocks.frustumCulled = false;
  world.add(blocks);
}

// ---- people ----------------------------------------------------------------------------------------------------------

function setScene(name, count) {
  state.scene = name;
  const asked = Math.max(1, Math.min(MOST, Math.round(count)));
  if (name !== ACTED) state.people = asked;
  const made = name === ACTED ? { rows: acted.people.slice(), lane: 1, count: acted.count }
    : sceneOf(name, state.people, facts.looks), rows = Math.ceil(made.count / ROW);
  const data = new Float32Array(rows * ROW * PERSON_TEXELS * 4);
  data.set(made.rows);
  if (uniforms.people.value) uniforms.people.value.dispose();
  uniforms.people.value = flatTexture(data, ROW * PERSON_TEXELS, rows, FLOATS);
  uniforms.laneLength.value = made.lane;
  walkers = {
    count: made.count, rows: made.rows, lane: made.lane, x: new Float32Array(made.count), y: new Float32Array(made.count),
    z: new Float32Array(made.count), tier: new Uint8Array(made.count).fill(HIDDEN), before: new Uint8Array(made.count),
    data, since: new Float32Array(made.count).fill(-9), pairs: new Float32Array(2 * made.count), cells: [], rebin: 0, next: 0,
  };
  if (blocks) blocks.visible = name === ACTED;
  if (room) {
    room.enter(name === ACTED, made.count);
    passes.sky.visible = name === ACTED;
  }
  uniforms.speakers.value = 0;
  uniforms.faced.value = feelings && name === ACTED ? 1 : 0;
  if (feelings) uniforms.feels.value = feelings.texture;
  if (name === ACTED) act();
  place(0, made.count);
  bin();
}

// When it is in what is acted: over and over, or on and on where that is told.
function actedNow() { return facts.live || (minds && minds.begun) ? state.now : state.now - Math.floor(state.now / facts.acted.seconds) * facts.acted.seconds; }

// Everybody where the scenario has them now.
function act() {
  const now = actedNow();
  acted.at(now, walkers.rows, staging ? (who) => staging.time(who, now) : undefined);
  if (staging) {
    staging.dress(walkers.rows, now);
    state.hour = staging.hour(now);
  }
  if (spoken) spoken.move(uniforms, now);
  if (feelings) feelings.feel(acted, now);
  const own = live ? live.own : minds ? minds.own : -1;
  if (own >= 0) walkers.rows[own * 4 * PERSON_TEXELS] = GONE; // nobody sees the own body
  walkers.data.set(walkers.rows);
  uniforms.people.value.needsUpdate = true;
  if (room) room.light(walkers.rows, walkers.count);
}

function place(first, last) {
  const { rows, lane, x, y, z } = walkers, now = state.now;
  for (let i = first; i < last; i++) {
    const at = i * 4 * PERSON_TEXELS, kind = rows[at], a = rows[at + 1], b = rows[at + 2], way = rows[at + 3];
    const speed = rows[at + 4];
    y[i] = rows[at + (kind >= BY_FOOTINGS ? UP : 16)];
    if (kind === 0 || kind >= BY_FOOTINGS) { x[i] = a; z[i] = b; }
    else if (kind === 1) {
      const along = b + speed * now;
      x[i] = a;
      z[i] = way * (along - Math.floor(along / lane) * lane - 0.5 * lane);
    } else {
      const angle = b + (way * speed * now) / a;
      x[i] = a * Math.sin(angle);
      z[i] = a * Math.cos(angle);
    }
  }
}

function bin() {
  const { count, x, y, z, pairs } = walkers;
  let x0 = Infinity, x1 = -Infinity, z0 = Infinity, z1 = -Infinity;
  for (let i = 0; i < count; i++) {
    if (x[i] < x0) x0 = x[i];
    if (x[i] > x1) x1 = x[i];
    if (z[i] < z0) z0 = z[i];
    if (z[i] > z1) z1 = z[i];
  }
  const wide = Math.floor((x1 - x0) / CELL_M) + 1, deep = Math.floor((z1 - z0) / CELL_M) + 1;
  const cell = walkers.cellOf && walkers.cellOf.length === count ? walkers.cellOf : (walkers.cellOf = new Uint32Array(count));
  const starts = new Uint32Array(wide * deep + 1);
  for (let i = 0; i < count; i++) {
    cell[i] = Math.floor((x[i] - x0) / CELL_M) + wide * Math.floor((z[i] - z0) / CELL_M);
    starts[cell[i] + 1]++;
  }
  for (let c = 0; c < wide * deep; c++) starts[c + 1] += starts[c];
  const at = starts.slice(), low = new Float32Array(wide * deep).fill(1e9), high = new Float32Array(wide * deep).fill(-1e9);
  for (let i = 0; i < count; i++) {
    const c = cell[i], k = at[c]++;
    pairs[2 * k] = i;
    pairs[2 * k + 1] = 1;
    if (y[i] < low[c]) low[c] = y[i];
    if (y[i] > high[c]) high[c] = y[i];
  }
  const order = [...starts.keys()].slice(0, -1).filter((c) => starts[c] < starts[c + 1]);
  walkers.cells = { x0, z0, wide, deep, starts, low, high, order };
}

// Positions are brought up to date a slice a frame; cells are made anew when all slices are through.
function keepCells() {
  if (state.scene === ACTED) {
    act();
    place(0, walkers.count);
    return bin();
  }
  const slice = Math.ceil(walkers.count / REBIN_FRAMES);
  place(walkers.next, Math.min(walkers.next + slice, walkers.count));
  walkers.next += slice;
  if (walkers.next < walkers.count) return;
  walkers.next = 0;
  bin();
}

const planes = new Float32Array(24);
function cameraPlanes(m) {
  for (let k = 0; k < 6; k++) {
    const row = k >> 1, sign = k & 1 ? -1 : 1;
    for (let c = 0; c < 4; c++) planes[4 * k + c] = m[4 * c + 3] + sign * m[4 * c + row];
    const long = Math.hypot(planes[4 * k], planes[4 * k + 1], planes[4 * k + 2]);
    for (let c = 0; c < 4; c++) planes[4 * k + c] /= long;
  }
}

function boxSeen(x0, y0, z0, x1, y1, z1) {
  for (let k = 0; k < 24; k += 4) {
    const a = planes[k], b = planes[k + 1], c = planes[k + 2];
    if (a * (a > 0 ? x1 : x0) + b * (b > 0 ? y1 : y0) + c * (c > 0 ? z1 : z0) + planes[k + 3] < 0) return false;
  }
  return true;
}

// Farthest distance of each tier, metres; the impostors' has no end.
function limitsOf() {
  const f = uniforms.focalPx.value, far = f * facts.switch.metres_per_focal_px;
  const limits = facts.tiers.map((tier, k) =>
    k + 1 < LEVELS ? (f * STATURE_M) / facts.tiers[k + 1].largest_px : far).map((d) => Math.min(d, far));
  if (state.mode === "levels") limits[LEVELS - 1] = Infinity;
  if (state.mode === "geometry") limits.fill(Infinity);
  if (state.mode === "impostors") limits.fill(0);
  return limits;
}

function choose() {
  const { x, y, z, tier, before, since, pairs, cells } = walkers, now = state.still ? state.still : performance.now() / 1000;
  const eye = uniforms.eye.value, limits = limitsOf(), far = limits[LEVELS - 1] * (1 + HYSTERESIS) + 2;
  const arrays = tiers.map((mesh) => mesh.geometry.attributes.instance.array), counts = new Uint32Array(LEVELS + 2);
  const shadows = LEVELS + 1;
  const away = (c) => ((c % cells.wide) * CELL_M + cells.x0 + CELL_M / 2 - eye.x) ** 2
    + (Math.floor(c / cells.wide) * CELL_M + cells.z0 + CELL_M / 2 - eye.z) ** 2;
  const put = (t, who, fade) => { const k = counts[t]++; arrays[t][2 * k] = who; arrays[t][2 * k + 1] = fade; };
  for (const c of cells.order.sort((a, b) => away(a) - away(b))) { // near ones first: what they hide is not shaded
    const from = cells.starts[c], to = cells.starts[c + 1];
    const cx = cells.x0 + (c % cells.wide) * CELL_M, cz = cells.z0 + Math.floor(c / cells.wide) * CELL_M;
    const x0 = cx - 1.5, x1 = cx + CELL_M + 1.5, z0 = cz - 1.5, z1 = cz + CELL_M + 1.5;
    if (!boxSeen(x0, cells.low[c] - 0.1, z0, x1, cells.high[c] + 2.2, z1)) continue;
    const dx = Math.max(x0 - eye.x, 0, eye.x - x1), dz = Math.max(z0 - eye.z, 0, eye.z - z1);
    const dy = Math.max(cells.low[c] - eye.y, 0, eye.y - cells.high[c] - 2);
    if (!live && dx * dx + dy * dy + dz * dz > far * far) {
      if (!state.whole) continue;
      arrays[IMPOSTOR].set(pairs.subarray(2 * from, 2 * to), 2 * counts[IMPOSTOR]);
      arrays[shadows].set(pairs.subarray(2 * from, 2 * to), 2 * counts[shadows]);
      counts[IMPOSTOR] += to - from;
      counts[shadows] += to - from;
      continue;
    }
    for (let k = from; k < to; k++) {
      const i = pairs[2 * k], ex = x[i] - eye.x, ey = y[i] + 0.9 - eye.y, ez = z[i] - eye.z;
      if (!boxSeen(x[i] - 1.2, y[i] - 0.1, z[i] - 1.2, x[i] + 1.2, y[i] + 2.1, z[i] + 1.2)) { tier[i] = HIDDEN; continue; }
      const d = Math.sqrt(ex * ex + ey * ey + ez * ez);
      let wanted = IMPOSTOR;
      for (let t = 0; t < LEVELS; t++)
        if (d < limits[t] * (1 + (tier[i] <= t ? HYSTERESIS : -HYSTERESIS))) { wanted = t; break; }
      if (wanted === IMPOSTOR && live && live.parts.has(i)) wanted = LEVELS - 1; // newcomers have no impostors
      if (wanted === IMPOSTOR && !state.whole) { tier[i] = HIDDEN; continue; }
      if (tier[i] === HIDDEN) { tier[i] = before[i] = wanted; since[i] = -9; }
      if (wanted !== tier[i]) { before[i] = tier[i]; tier[i] = wanted; since[i] = now; }
      const fade = (now - since[i]) / FADE_S;
      if (fade < 1 && fade >= 0 && !state.still) { put(tier[i], i, Math.max(fade, 1e-3)); put(before[i], i, -Math.max(fade, 1e-3)); }
      else put(tier[i], i, 1);
      put(shadows, i, 1);
    }
  }
  tiers.slice(0, LEVELS + 2).forEach((mesh, t) => {
    const attribute = mesh.geometry.attributes.instance;
    mesh.geometry.instanceCount = counts[t];
    mesh.visible = counts[t] > 0;
    attribute.clearUpdateRanges();
    attribute.addUpdateRange(0, 2 * counts[t]);
    attribute.needsUpdate = true;
  });
  state.stats.counts = [...counts].slice(0, LEVELS + 1);
}

// ---- frames ----------------------------------------------------------------------------------------------------------

let last = 0, shownAt = 0, frames = 0;
function frame(time) {
  const step = Math.min(time - last, 0.1);
  last = time;
  resize();
  if (live) live.frame();
  else if (minds && state.scene === ACTED) {
    minds.walk(state.camera === "walk along" ? [camera.position.x, camera.position.z, fly.yaw + Math.PI] : null);
    if (!state.paused) state.now = minds.go_on(state.now, step);
  } else if (!state.paused) state.now += step;
  steer(step);
  draw();
  frames++;
  if (state.shown) state.shown = state.shown();
  if (time - shownAt > 0.5) {
    state.stats.fps = frames / (time - shownAt);
    shownAt = time;
    frames = 0;
    const s = state.stats;
    document.querySelector("#stats").textContent =
      `${walkers.count} people · ${s.fps.toFixed(0)} frames/s · choice ${s.choice.toFixed(2)} ms · ${s.draws} draws · ` +
      `levels ${s.counts.slice(0, LEVELS).join(" / ")} · impostors ${s.counts[IMPOSTOR]} · ` +
      `${(s.triangles / 1000).toFixed(0)}k triangles`;
  }
}

function draw() {
  lens();
  uniforms.now.value = state.now;
  uniforms.debugView.value = state.debug;
  const begun = performance.now();
  keepCells();
  if (state.camera === "film") direct();
  cameraPlanes(uniforms.clipFromWorld.value.elements);
  choose();
  state.stats.choice = performance.now() - begun;
  if (room && uniforms.roomed.value) {
    const { elements } = camera.matrixWorld, axis = (k) => new THREE.Vector3(elements[4 * k], elements[4 * k + 1], elements[4 * k + 2]);
    const tall = Math.tan((camera.fov * Math.PI) / 360), ahead = axis(2).negate();
    room.see(uniforms.eye.value, ahead, axis(0).multiplyScalar(tall * camera.aspect), axis(1).multiplyScalar(tall), state.hour);
    if (room.sunny) passes.cast(renderer, camera, uniforms.eye.value, ahead, walkers);
  }
  if (sound && state.scene === ACTED) {
    const way = new THREE.Vector3();
    sound.hear(uniforms.eye.value, camera.getWorldDirection(way), walkers, acted);
    if (spoken) sound.speak(spoken.said, actedNow(), state.paused, walkers);
  }
  tiers.forEach((mesh, k) => { mesh.material.wireframe = Boolean(state.debug) && k < LEVELS; });
  renderer.info.reset();
  renderer.render(world, camera);
  state.stats.draws = renderer.info.render.calls;
  state.stats.triangles = tiers.reduce((sum, mesh) => sum + mesh.geometry.instanceCount * mesh.userData.triangles, 0);
}

function resize() {
  const ratio = Math.min(window.devicePixelRatio, 2), { clientWidth: wide, clientHeight: tall } = canvas;
  if (canvas.width === Math.floor(wide * ratio) && canvas.height === Math.floor(tall * ratio)) return;
  renderer.setPixelRatio(ratio);
  renderer.setSize(wide, tall, false);
  camera.aspect = wide / tall;
  camera.updateProjectionMatrix();
}

// The film's own camera, caption and curtain, now.
function direct() {
  const now = actedNow();
  const { place: at, target, fov } = staging.camera(walkers.rows, now);
  camera.fov = fov;
  camera.updateProjectionMatrix();
  look(at, target);
  lens();
  document.querySelector("#caption").textContent = staging.caption(now);
  document.querySelector("#curtain").style.opacity = 1 - staging.curtain(now);
}

// What the shaders know of the eye.
function lens() {
  camera.updateMatrixWorld();
  uniforms.clipFromWorld.value.multiplyMatrices(camera.projectionMatrix, camera.matrixWorldInverse);
  camera.getWorldPosition(uniforms.eye.value);
  uniforms.focalPx.value = renderer.domElement.height / 2 / Math.tan((camera.fov * Math.PI) / 360);
}

// ---- cameras ---------------------------------------------------------------------------------------------------------

const VIEWS = {
  overview: { plaza: [[0, 9, 34], [0, 1, 0]], walk: [[0, 6, 18], [0, 1, -6]], stadium: [[0, 9, 22], [0, 4, -30]] },
  near: { plaza: [[1.2, 1.7, 9.5], [0, 1.2, 5]], walk: [[0.4, 1.7, 6], [0, 1.2, -2]], stadium: [[0, 3, -17], [0, 2.2, -25]] },
  street: { plaza: [[0, 1.7, 26], [0, 1.4, 0]], walk: [[0, 1.7, 12], [0, 1.4, -10]], stadium: [[0, 1.7, 0], [0, 5, -30]] },
};

function view(name) {
  const [place, target] = state.scene === ACTED ? facts.acted.views[name] : VIEWS[name][state.scene];
  look(place, target);
}

function look(place, target) {
  camera.position.set(...place);
  controls.target.set(...target);
  camera.lookAt(controls.target);
  const way = controls.target.clone().sub(camera.position).normalize();
  fly = { yaw: Math.atan2(-way.x, -way.z), pitch: Math.asin(way.y) };
  controls.update();
}

function steer(step) {
  if (state.camera === "film" || state.camera === "live") return;
  if (state.camera === "orbit") { if (controls.enabled) controls.update(); return; }
  const inside = room && uniforms.roomed.value && state.camera === "walk along", { x: from_x, z: from_z } = camera.position;
  const fast = inside ? (keys.has("shift") ? 4 : 1.6) : keys.has("shift") ? 12 : 4, ahead = (keys.has("w") || keys.has("arrowup") ? 1 : 0) - (keys.has("s") || keys.has("arrowdown") ? 1 : 0);
  const aside = (keys.has("d") || keys.has("arrowright") ? 1 : 0) - (keys.has("a") || keys.has("arrowleft") ? 1 : 0);
  const up = (keys.has("e") ? 1 : 0) - (keys.has("q") ? 1 : 0), cp = state.camera === "fly" ? Math.cos(fly.pitch) : 1;
  camera.position.x += (-Math.sin(fly.yaw) * cp * ahead + Math.cos(fly.yaw) * aside) * fast * step;
  camera.position.z += (-Math.cos(fly.yaw) * cp * ahead - Math.sin(fly.yaw) * aside) * fast * step;
  camera.position.y += state.camera === "fly" ? (Math.sin(fly.pitch) * ahead + up) * fast * step : 1.65 - camera.position.y;
  if (inside) [camera.position.x, camera.position.z] = room.walk(from_x, from_z, ...besides(from_x, from_z));
  camera.rotation.set(fly.pitch, fly.yaw, 0, "YXZ");
}

// Where a walker wants to go, short of people who stand there: nobody walks through anybody.
function besides(from_x, from_z) {
  const { x, z, count, rows } = walkers, wanted = camera.position;
  for (let i = 0; i < count; i++) {
    if (rows[i * 4 * PERSON_TEXELS] >= GONE) continue;
    const dx = wanted.x - x[i], dz = wanted.z - z[i], far = Math.hypot(dx, dz);
    if (far >= ARM_M || far < 1e-3 || far >= Math.hypot(from_x - x[i], from_z - z[i])) continue;
    wanted.x = x[i] + (dx / far) * ARM_M;
    wanted.z = z[i] + (dz / far) * ARM_M;
  }
  return [wanted.x, wanted.z];
}

function setCamera(kind) {
  if (state.camera === "film" && kind !== "film") {
    camera.fov = 45;
    camera.updateProjectionMatrix();
    document.querySelector("#caption").textContent = "";
    document.querySelector("#curtain").style.opacity = 0;
  }
  state.camera = kind;
  controls.enabled = kind === "orbit";
  const way = new THREE.Vector3();
  camera.getWorldDirection(way);
  if (kind === "orbit") controls.target.copy(camera.position).addScaledVector(way, 10);
  else fly = { yaw: Math.atan2(-way.x, -way.z), pitch: Math.asin(way.y) };
}

// One finger or the mouse looks around; a second finger goes ahead.
const fingers = new Map();
canvas.addEventListener("pointerdown", (event) => fingers.set(event.pointerId, event));
for (const name of ["pointerup", "pointercancel", "pointerleave"])
  canvas.addEventListener(name, (event) => { fingers.delete(event.pointerId); if (fingers.size < 2) keys.delete("w"); });
canvas.addEventListener("pointermove", (event) => {
  const before = fingers.get(event.pointerId);
  if (!before || state.camera === "orbit") return;
  if (fingers.size > 1) keys.add("w");
  fly.yaw += (event.clientX - before.clientX) * 0.004;
  fly.pitch = Math.max(-1.5, Math.min(1.5, fly.pitch + (event.clientY - before.clientY) * 0.004));
  fingers.set(event.pointerId, event);
});
window.addEventListener("keydown", (event) => { if (event.target.tagName !== "INPUT") keys.add(event.key.toLowerCase()); });
window.addEventListener("keyup", (event) => keys.delete(event.key.toLowerCase()));
window.addEventListener("blur", () => keys.clear());

// ---- knobs -----------------------------------------------------------------------------------------------------------

function knob(text, act) {
  const made = document.createElement("button");
  made.textContent = text;
  made.addEventListener("click", () => act(made));
  document.querySelector("#knobs").append(made);
  return made;
}

function select(label, names, chosen, act) {
  const made = document.createElement("select");
  made.setAttribute("aria-label", label);
  for (const name of names) made.append(new Option(name, name, false, name === chosen));
  made.addEventListener("change", () => act(made.value));
  document.querySelector("#knobs").append(made);
}

// How much of the room's echo is heard at a place: all on its floor, less on others.
function echoHeard(x, z) {
  const [x0, z0, x1, z1] = facts.room.echo;
  return x >= x0 && x <= x1 && z >= z0 && z <= z1 ? 1 : 0.15;
}

// Whether the pack holds a film.
function directed() { return Boolean(staging && staging.film && state.scene === ACTED); }

function buildKnobs() {
  if (!live) select("scene", [...(acted ? [ACTED] : []), ...Object.keys(SCENES)], state.scene, (name) => { setScene(name, state.people); view("overview"); });
  select("camera", [...(directed() ? ["film"] : []), ...(live ? ["live"] : []), "orbit", "fly", "walk along"], state.camera, (kind) => setCamera(kind));
  for (const name of Object.keys(VIEWS)) knob(name, () => { if (["film", "live"].includes(state.camera)) setCamera("orbit"); view(name); });
  const slider = document.createElement("input");
  Object.assign(slider, { type: "range", min: 0, max: 100, step: 1 });
  slider.setAttribute("aria-label", "people");
  const whole = (value) => Math.round(10 ** (1 + (value / 100) * 3.78)); // 10 to 60,000
  slider.value = (100 * (Math.log10(state.people) - 1)) / 3.78;
  slider.addEventListener("input", () => setScene(state.scene, whole(Number(slider.value))));
  if (!live) document.querySelector("#knobs").append(slider);
  if (live) knob("order", () => { const order = window.prompt("Order, as in a scenario: school goes to door"); if (order) live.order(order); });
  if (!live) knob("pause", (made) => { state.paused = !state.paused; made.setAttribute("aria-pressed", state.paused); });
  for (const name of minds ? minds.events : []) knob(name, () => minds.happen(name));
  knob("tiers", (made) => { state.debug = 1 - state.debug; made.setAttribute("aria-pressed", Boolean(state.debug)); });
  if (acted) knob("sound", async (made) => {
    if (!sound) sound = await soundOf(echo, echoHeard, voices);
    else if (sound.context.state === "running") await sound.context.suspend();
    else await sound.context.resume();
    made.setAttribute("aria-pressed", sound.context.state !== "suspended");
  });
  knob("picture", () => {
    draw();
    canvas.toBlob((blob) => {
      const link = Object.assign(document.createElement("a"), { href: URL.createObjectURL(blob), download: "crowd.png" });
      link.click();
      setTimeout(() => URL.revokeObjectURL(link.href), 1000);
    });
  });
  knob("full screen", () => document.documentElement.requestFullscreen?.());
}

// For tests and measurements: everything stands still, and a frame's end is waited for.
window.crowd = {
  state, facts,
  set({ scene = state.scene, people = state.people, place: at, target, fov = 45, now, mode, debug } = {}) {
    renderer.setAnimationLoop(null);
    state.still = 1;
    if (now !== undefined) state.now = now;
    if (mode) state.mode = mode;
    if (debug !== undefined) state.debug = debug;
    setScene(scene, people);
    camera.fov = fov;
    resize();
    camera.updateProjectionMatrix();
    if (at) look(at, target);
    walkers.tier.fill(HIDDEN);
  },
  draw() { walkers.tier.fill(state.still ? HIDDEN : walkers.tier[0]); draw(); return state.stats; },
  time(times = 5) {
    const gl = renderer.getContext(), pixel = new Uint8Array(4), found = [];
    for (let k = 0; k < times; k++) {
      const begun = performance.now();
      draw();
      gl.readPixels(0, 0, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, pixel);
      found.push(performance.now() - begun);
    }
    return found;
  },
  choices(times = 60) {
    const found = [];
    for (let k = 0; k < times; k++) {
      const begun = performance.now();
      keepCells();
      choose();
      found.push(performance.now() - begun);
    }
    return found;
  },
  run() { state.still = 0; renderer.setAnimationLoop((time) => frame(time / 1000)); },
};
open();
