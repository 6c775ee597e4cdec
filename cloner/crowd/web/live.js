"use strict";
// A page that is served: the scene goes on, and clones come and go while it is shown. Its steps are the page's own: the
// engine hears what came from outside, before the same step as everywhere. The camera finds who has come and walks along; when nobody comes it shows the scene by turns; who touches the page looks around; all ends again when
// nobody does. A lost link is taken up again, and then everything is told anew.

const FOLLOW_S = 45, SHOT_S = 14, IDLE_S = 30, LOST_S = 10, AGAIN_S = 0.5, PULL = 1.6, TURN_RAD_S = 0.02, LOOK_M = 1.15, EYE_M = 1.6; // taste
const ASIDE = [0.5, -0.5, 1.1, -1.1, 1.8, -1.8, 2.6, -2.6], AWAY_M = [3.4, 2.6, 1.9], BESIDE_M = 0.55, NEAR_M = 1.2, LOOKS_S = 1.5, WALK_EVERY_S = 0.5; // taste
const OFF_S = 0.25, SLICE_MS = 8, LATE_MS = 3000; // a clock so far off is put right; steps at a time, and how long a newcomer's feet are waited for: taste

// `module` is the engine, `tables` the scenario's numbers.
function liveOf(statues, module, tables) {
  const clock = () => performance.now() / 1000;
  const own = facts.people.length, slots = [], newcomers = new Map(), parts = new Set(), turns = [];
  const before = acted.people.slice(), gone = new Set(), history = [], shots = Object.keys(VIEWS);
  let offset = -clock(), staff = false, touched = -IDLE_S, lost = clock(), line = Promise.resolve(), link = null, ended = false, rejoined = null;
  let followed = null, until = 0, shot = -1, shotUntil = 0, aside = ASIDE[0], away = AWAY_M[0], looked = -1, eye = null, target = null, drawn = clock();
  async function read(key, name) {
    const answer = await fetch(`newcomers/${key}/${name}`);
    if (!answer.ok) throw new Error("gone");
    return new Uint8Array(await answer.arrayBuffer());
  }

  // ---- people ----

  const rowOf = (who) => before.slice(who * 4 * PERSON_TEXELS, (who + 1) * 4 * PERSON_TEXELS);
  function turn(who, row) {
    acted.turn(who, row);
    walkers.rows.set(row, who * 4 * PERSON_TEXELS);
  }

  // A newcomer's numbers, asked for as soon as it is told of: the engine wants them when its part begins.
  const feet = new Map();
  function ask({ key, row }) {
    if (!feet.has(key)) feet.set(key, read(key, "numbers.bin").then((bytes) => arraysOf(bytes, row.arrays)).catch(() => null));
  }

  async function come(told) {
    if (newcomers.has(told.key)) return play(told);
    const [numbers, ...pictures] = await Promise.all([
      feet.get(told.key),
      ...["atlas", "codes", "shell"].map((name) => read(told.key, `${name}.webp`).then(pixelsIn))]);
    if (gone.has(told.key) || !numbers) return;
    let slot = slots.indexOf(null);
    if (slot < 0) slot = slots.push(null) - 1;
    slots[slot] = told.key;
    const clone = own + slot;
    stage.people[clone] = { row: told.row, numbers, face: numbers.moves, ...looksOf(...pictures) };
    dressAgain();
    acted.dress(clone, numbers.touches, numbers.clips);
    const one = { who: -1, clone, slot, told: clock(), from: null, step: null };
    newcomers.set(told.key, one);
    history.push(one);
    play(told);
  }

  // A newcomer plays somebody's part from a time on.
  function play({ key, who, at, fresh }) {
    const one = newcomers.get(key);
    if (!one || one.who === who) return;
    if (one.who >= 0) giveBack(one);
    one.who = who;
    const row = rowOf(who);
    row.set([0, 0, one.clone, 1, one.clone, one.clone, one.clone], 4); // its own size, its own clothes
    row.fill(-1, 12, 16);
    parts.add(who);
    turns.push({ who, row, at, fresh });
  }

  function giveBack(one) {
    for (let k = turns.length - 1; k >= 0; k--) if (turns[k].who === one.who) turns.splice(k, 1);
    parts.delete(one.who);
    turn(one.who, rowOf(one.who));
    if (followed === one.who) until = 0;
  }

  function leave(key) {
    const one = newcomers.get(key);
    gone.add(key);
    feet.delete(key);
    if (!one) return;
    newcomers.delete(key);
    giveBack(one);
    slots[one.slot] = null;
    stage.people[one.clone] = stage.people[0]; // nothing of who has gone is kept
    dressAgain();
  }

  function dressAgain() {
    if (facts.faces) dressFaces(uniforms, stage.body, stage.people);
    for (const [name, texture] of Object.entries(bodyTextures(stage.people))) {
      uniforms[name].value.dispose();
      uniforms[name].value = texture;
    }
  }

  // ---- what is told ----

  // One after another: textures are made anew each time.
  const queue = (what) => { line = line.then(what).catch((error) => console.warn(String(error))); };

  function waysIn(told) {
    const all = new Float32Array(Uint8Array.from(atob(told.data), (one) => one.charCodeAt(0)).buffer);
    let at = 0;
    for (const [who, many] of told.of) {
      acted.begin(who, all.slice(at * FOOTING, (at + many) * FOOTING));
      at += many;
    }
  }

  function keepTime(now) { if (Math.abs(now - clock() - offset) > OFF_S) offset = now - clock(); }

  // ---- steps ----

  let runner = null, running = Promise.resolve();
  const after = (what) => { running = running.then(what).catch((error) => { console.warn(String(error)); link.close(); }); };

  async function resume(told) {
    const bytes = Uint8Array.from(atob(told.state), (one) => one.charCodeAt(0));
    const plain = new Response(new Blob([bytes]).stream().pipeThrough(new DecompressionStream("deflate")));
    runner = runnerOf(await engineOf(module, told.begun, tables));
    runner.resume(new Uint8Array(await plain.arrayBuffer()), told.until);
  }

  // Go on to a step; `log` is what came from outside before which one, `sum` what places add up to then.
  async function goOn({ now, until, log, sum }) {
    let rest = performance.now() + SLICE_MS;
    for (const [step, name, ...values] of [...log, [until]]) {
      while (runner.steps < step) {
        runner.step();
        if (performance.now() < rest) continue;
        await new Promise((again) => setTimeout(again));
        rest = performance.now() + SLICE_MS;
      }
      if (name === "dress") await dressFeet(...values);
      else if (name) runner.core[name](...values);
    }
    if (runner.core.sum() >>> 0 !== sum) throw new Error("other steps than elsewhere"); // the link is taken up again
    for (const [who, list] of gathered(runner.footings())) acted.go_on(who, new Float32Array(list), now);
    for (const _ of runner.told()); // the server tells who awakes
  }

  // Feet of a newcomer, as the key tells, or one's own again.
  async function dressFeet(who, look, scale, key) {
    const { rows } = runner, kinds = facts.people[0].clips.length;
    const put = (number, touches, clips) => {
      rows.touches.set(touches, number * kinds * WALK_FRAMES * TOUCH);
      rows.clips.set(clips, number * kinds * 2);
    };
    const own = key && (await Promise.race([feet.get(key), new Promise((late) => setTimeout(late, LATE_MS))]));
    if (own) put(look, own.touches, own.clips);
    if (!key) put(rows.look_of[who], new Float32Array(kinds * WALK_FRAMES * TOUCH), new Float32Array(kinds * 2)); // nothing is kept
    rows.look_of[who] = look;
    rows.scale[who] = scale;
  }

  const heard = {
    hello(told) {
      for (let who = 0; who < acted.count; who++) if (!statues.who.has(who)) acted.begin(who, new Float32Array(0));
      waysIn(told);
      keepTime(told.now);
      after(() => resume(told));
      statues.begin();
      for (const one of told.awake) heard.awakes(one);
      const there = new Set(told.newcomers.map((one) => one.key));
      for (const key of newcomers.keys()) if (!there.has(key)) queue(() => leave(key));
      for (const one of told.newcomers) { gone.delete(one.key); ask(one); queue(() => come(one)); }
      if (lost !== null) rejoined = clock() - lost;
      lost = null;
    },
    steps(told) { keepTime(told.now); after(() => goOn(told)); },
    come(told) { ask(told); queue(() => come(told)); },
    plays: (told) => queue(() => play(told)),
    gone({ key }) { gone.add(key); queue(() => leave(key)); },
    awakes: ({ name, at }) => statues.awake(name, at),
    answer(told) {
      if (told.staff) { staff = true; knobs.style.display = stats.style.display = ""; }
      if (told.error) window.alert(told.error);
      if (told.who !== undefined && walked > 0) own_part = told.who;
    },
    over({ text }) {
      ended = true;
      renderer.setAnimationLoop(null);
      for (const key of [...newcomers.keys()]) leave(key);
      canvas.remove();
      say(text);
    },
  };

  function join() {
    link = new WebSocket(`${location.href.replace("http", "ws")}live`);
    link.onmessage = (event) => { const told = JSON.parse(event.data); heard[told.kind](told); };
    link.onclose = () => { if (ended) return; lost ??= clock(); setTimeout(join, AGAIN_S * 1000); };
  }
  // Who walks along is a guest whom the scenario's people see; the own double is not shown here.
  let own_part = -1, walked = -1e9;
  function stroll(now) {
    const inside = state.camera === "walk along";
    if (inside ? now - walked < WALK_EVERY_S : walked < 0) return;
    walked = inside ? now : -1e9;
    if (!inside) own_part = -1;
    const { x, z } = camera.position;
    tell({ walk: inside ? `${x.toFixed(3)} ${z.toFixed(3)} ${wrapped(fly.yaw + Math.PI).toFixed(3)}` : "" });
  }
  const wrapped = (angle) => angle - 2 * Math.PI * Math.round(angle / (2 * Math.PI));
  const tell = (what) => { if (link.readyState === WebSocket.OPEN) link.send(JSON.stringify(what)); };

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
    const now = clock(), step = Math.min(now - drawn, 1);
    drawn = now;
    state.now = now + offset;
    if (lost !== null && now - lost > LOST_S) for (const key of [...newcomers.keys()]) leave(key); // nobody could tell that they are to go
    if (state.camera !== "live" && !keys.size && now - touched > IDLE_S) { shut(); setCamera("live"); eye = null; }
    for (const one of turns.filter((each) => each.at <= state.now)) {
      turns.splice(turns.indexOf(one), 1);
      turn(one.who, one.row);
      if (one.fresh) follow(one.who, clock() + FOLLOW_S, true);
    }
    if (state.camera === "live") direct(step);
    stroll(now);
    for (const one of newcomers.values()) {
      if (one.step !== null || turns.some((each) => each.who === one.who)) continue;
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
  window.addEventListener("keydown", (event) => {
    if (room && event.key.startsWith("Arrow") && ["live", "orbit"].includes(state.camera)) setCamera("walk along");
    if (!(event.ctrlKey && event.shiftKey && event.key.toLowerCase() === "k")) return;
    event.preventDefault();
    keys.clear();
    if (staff) return shut();
    const number = window.prompt("Number of the operator") || "";
    hand();
    if (number) tell({ number });
  });
  shut();
  state.camera = "live";
  join();
  return { order: (order) => tell({ order }), get rejoined() { return rejoined; }, get runner() { return runner; }, cut: () => { rejoined = null; link.close(); }, get settled() { return !turns.length; }, frame, parts, newcomers, history, get own() { return own_part; }, get followed() { return followed; }, get staff() { return staff; } };
}
