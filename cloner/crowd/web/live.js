"use strict";
// A page that is served: clones come and go while it is shown. The camera finds who has come and walks along; when
// nobody comes it shows the scene by turns; who touches the page looks around; all ends again when nobody does.

const FOLLOW_S = 45, SHOT_S = 14, IDLE_S = 30, LOST_S = 10, PULL = 1.6, TURN_RAD_S = 0.02, LOOK_M = 1.15, EYE_M = 1.6; // taste
const ASIDE = [0.5, -0.5, 1.1, -1.1, 1.8, -1.8, 2.6, -2.6], AWAY_M = [3.4, 2.6, 1.9], BESIDE_M = 0.55, NEAR_M = 1.2, LOOKS_S = 1.5; // taste

function liveOf() {
  const clock = () => performance.now() / 1000;
  const own = facts.people.length, slots = [], newcomers = new Map(), parts = new Set();
  const gone = new Set(), history = [], shots = Object.keys(VIEWS);
  let offset = -clock(), staff = false, touched = -IDLE_S, lost = null, line = Promise.resolve();
  let followed = null, until = 0, shot = -1, shotUntil = 0, aside = ASIDE[0], away = AWAY_M[0], looked = -1, eye = null, target = null, before = clock();
  async function read(key, name) {
    const answer = await fetch(`newcomers/${key}/${name}`);
    if (!answer.ok) throw new Error("gone");
    return new Uint8Array(await answer.arrayBuffer());
  }

  async function come(told) {
    const [numbers, ...pictures] = await Promise.all([
      read(told.key, "numbers.bin").then((bytes) => arraysOf(bytes, told.row.arrays)),
      ...["atlas", "codes", "shell"].map((name) => read(told.key, `${name}.webp`).then(pixelsIn))]);
    if (gone.has(told.key) || newcomers.has(told.key)) return;
    let slot = slots.indexOf(null);
    if (slot < 0) slot = slots.push(null) - 1;
    slots[slot] = told.key;
    const clone = own + slot, [atlas, codes, shell] = pictures;
    stage.people[clone] = { numbers, atlas, codes, shell };
    dressAgain();
    const own_part = JSON.parse(new TextDecoder().decode(await read(told.key, "part.json"))), { who } = own_part;
    const part = await arraysOf(Uint8Array.from(atob(own_part.data), (one) => one.charCodeAt(0)), own_part.arrays);
    const row = new Float32Array(4 * PERSON_TEXELS);
    row.set([0, 0, clone, 1, clone, clone, clone], 4); // its own size, its own clothes
    row.fill(-1, 12, 16);
    acted.dress(clone, part.touches, part.clips);
    acted.take(who, part.footings, row);
    walkers.rows.set(row, who * 4 * PERSON_TEXELS);
    parts.add(who);
    newcomers.set(told.key, { who, slot, told: clock(), from: null, step: null });
    history.push(newcomers.get(told.key));
    if (told.fresh) follow(who, clock() + FOLLOW_S, true);
  }

  function leave(key) {
    const one = newcomers.get(key);
    gone.add(key);
    if (!one) return;
    newcomers.delete(key);
    parts.delete(one.who);
    acted.give(one.who);
    walkers.rows.set(acted.people.subarray(one.who * 4 * PERSON_TEXELS, (one.who + 1) * 4 * PERSON_TEXELS), one.who * 4 * PERSON_TEXELS);
    slots[one.slot] = null;
    stage.people[own + one.slot] = stage.people[0]; // nothing of who has gone is kept
    dressAgain();
    if (followed === one.who) until = 0;
  }

  function dressAgain() {
    for (const [name, texture] of Object.entries(bodyTextures(stage.people))) {
      uniforms[name].value.dispose();
      uniforms[name].value = texture;
    }
  }

  // One after another: textures are made anew each time.
  const queue = (what) => { line = line.then(what).catch((error) => console.warn(String(error))); };

  function hello(told) {
    offset = told.now - clock();
    const there = new Set(told.newcomers.map((one) => one.key));
    for (const key of newcomers.keys()) if (!there.has(key)) queue(() => leave(key));
    for (const one of told.newcomers) queue(() => come(one));
  }

  function over(text) {
    renderer.setAnimationLoop(null);
    for (const key of [...newcomers.keys()]) leave(key);
    canvas.remove();
    say(text);
  }

  const stream = new EventSource("events");
  stream.onopen = () => { lost = null; };
  stream.onerror = () => { if (lost === null) lost = clock(); };
  stream.addEventListener("hello", (event) => hello(JSON.parse(event.data)));
  stream.addEventListener("come", (event) => { const told = JSON.parse(event.data); queue(() => come(told)); });
  stream.addEventListener("gone", (event) => { const { key } = JSON.parse(event.data); gone.add(key); queue(() => leave(key)); });
  stream.addEventListener("over", (event) => { stream.close(); over(JSON.parse(event.data).text); });

  // ---- camera ----

  function follow(who, end, fresh) {
    followed = who;
    until = end;
    looked = -1;
    document.querySelector("#caption").textContent = fresh ? `You are in the ${facts.room ? facts.room.name : "scene"}` : "";
    if (state.camera === "live" || (fresh && !staff)) setCamera("live");
  }

  const present = (who) => walkers.rows[who * 4 * PERSON_TEXELS] < GONE;
  const sees = (x, z, px, pz) => !room || room.open(x, z, px, pz);

  // Where the eye may stand to see somebody: nothing between, nobody in the way.
  function standing(who) {
    const x = walkers.x[who], z = walkers.z[who], heading = walkers.rows[who * 4 * PERSON_TEXELS + 3];
    let best = null, least = Infinity;
    for (const far of AWAY_M) for (const turn of ASIDE) {
      const dx = Math.sin(heading + turn), dz = Math.cos(heading + turn);
      if (!sees(x, z, x + far * dx, z + far * dz)) continue;
      let cost = Math.abs(turn) * 0.4 + (AWAY_M[0] - far) * 0.6 + (turn === aside && far === away ? -0.6 : 0);
      for (let i = 0; i < walkers.count; i++) {
        if (i === who || !present(i)) continue;
        const ox = walkers.x[i] - x, oz = walkers.z[i] - z, along = ox * dx + oz * dz;
        if (along > 0.3 && along < far + 0.5 && Math.abs(ox * dz - oz * dx) < BESIDE_M) cost += 0.7;
      }
      if (cost < least) { least = cost; best = [turn, far]; }
    }
    return best || [aside, AWAY_M[AWAY_M.length - 1]];
  }

  function somebody() {
    const choice = [...newcomers.values()].map((one) => one.who).filter(present);
    for (let k = 0; choice.length < 2 && k < walkers.count; k++) {
      const i = (k * 37 + Math.floor(clock())) % walkers.count;
      if (present(i) && acted.walks(i) && walkers.rows[i * 4 * PERSON_TEXELS + STONE] === 0) choice.push(i);
    }
    return choice.length ? choice[Math.floor(clock()) % choice.length] : null;
  }

  function next() {
    shot++;
    shotUntil = clock() + SHOT_S;
    const who = shot % 2 ? somebody() : null;
    followed = null;
    if (who === null) { view(shots[(shot >> 1) % shots.length]); eye = target = null; }
    else follow(who, shotUntil, false);
  }

  // Where the eye goes, a frame long.
  function direct(step) {
    if (followed !== null && (clock() > until || !present(followed))) { followed = null; document.querySelector("#caption").textContent = ""; shotUntil = 0; }
    if (followed === null && clock() > shotUntil) next();
    if (followed === null) {
      const turn = TURN_RAD_S * step, [px, pz] = [camera.position.x - controls.target.x, camera.position.z - controls.target.z];
      look([controls.target.x + px * Math.cos(turn) - pz * Math.sin(turn), camera.position.y,
            controls.target.z + px * Math.sin(turn) + pz * Math.cos(turn)], controls.target.toArray());
      return;
    }
    const x = walkers.x[followed], z = walkers.z[followed], high = walkers.y[followed];
    const heading = walkers.rows[followed * 4 * PERSON_TEXELS + 3];
    if (clock() > looked) { [aside, away] = standing(followed); looked = clock() + LOOKS_S; }
    const wanted = [x + away * Math.sin(heading + aside), high + EYE_M, z + away * Math.cos(heading + aside)];
    if (!eye || Math.hypot(eye[0] - x, eye[2] - z) < NEAR_M || !sees(eye[0], eye[2], wanted[0], wanted[2])) { eye = wanted.slice(); target = [x, high + LOOK_M, z]; }
    const pull = 1 - Math.exp(-PULL * step), at = [x, high + LOOK_M, z];
    for (let k = 0; k < 3; k++) { eye[k] += (wanted[k] - eye[k]) * pull; target[k] += (at[k] - target[k]) * Math.min(1, 2.5 * pull); }
    look(eye, target);
  }

  function frame() {
    const now = clock(), step = Math.min(now - before, 1);
    before = now;
    state.now = now + offset;
    if (lost !== null && now - lost > LOST_S) for (const key of [...newcomers.keys()]) leave(key); // nobody could tell that they are to go
    if (state.camera !== "live" && !keys.size && now - touched > IDLE_S) { shut(); setCamera("live"); eye = null; }
    if (state.camera === "live") direct(step);
    for (const one of newcomers.values()) {
      if (one.step !== null) continue;
      const at = [walkers.x[one.who], walkers.z[one.who]];
      one.from ||= at;
      if (acted.walks(one.who) && Math.hypot(at[0] - one.from[0], at[1] - one.from[1]) > 0.1) one.step = Date.now() / 1000;
    }
  }

  // ---- hands ----

  const knobs = document.querySelector("#knobs"), stats = document.querySelector("#stats");
  function shut() { staff = false; knobs.style.display = stats.style.display = "none"; }
  const hand = () => { touched = clock(); };
  for (const name of ["pointerdown", "pointermove", "wheel", "keydown"]) window.addEventListener(name, hand);
  canvas.addEventListener("pointerdown", () => {
    if (state.camera !== "live") return;
    const at = followed !== null ? target.slice() : null;
    setCamera("orbit");
    document.querySelector("#caption").textContent = "";
    if (at) controls.target.set(...at);
  });
  window.addEventListener("keydown", async (event) => {
    if (!(event.ctrlKey && event.shiftKey && event.key.toLowerCase() === "k")) return;
    event.preventDefault();
    keys.clear();
    if (staff) return shut();
    const number = window.prompt("Number of the operator") || "";
    hand();
    if (!number) return;
    const answer = await fetch("staff", { method: "POST", body: number });
    if (answer.ok) { staff = true; knobs.style.display = stats.style.display = ""; }
  });
  shut();
  state.camera = "live";
  return { frame, parts, newcomers, history, get followed() { return followed; }, get staff() { return staff; } };
}
