"use strict";
// A scenario that goes on in the page itself. What was baked is its beginning; the engine takes over before that ends, or
// as soon as somebody walks along or lets an event happen, and does the same steps up to there. Like a served scene's
// minds (cloner/scenes/served/minds.py) it is a little ahead of what is shown; when all have left, or nobody has walked for a minute, it begins anew.

const SEEN_S = 2, AHEAD_S = 3, ENGINE_STEP_S = 0.05, FRAME_STEPS = 2; // feet want SEEN_S, the longest footing .8
const SPARE_S = 0.5, SPEND_MS = 6, EMPTY_S = 5, STILL_S = 60, WALKS = [1, 2]; // taste: how far behind it may fall, a frame's time, how long nobody is there or walks
const TOLD = { awakens: 0, sleeps: 1 }, EVENT = 15; // as core/minds/told.ts, rules.ts

// An engine that goes on step by step, and what is new of it.
function runnerOf({ core, rows }) {
  let steps = 0;
  return {
    core, rows,
    get steps() { return steps; },
    get time() { return steps * ENGINE_STEP_S; },
    step() {
      if (!steps) core.watch();
      core.live();
      if (++steps % FRAME_STEPS === 0) core.watch();
    },
    // Go on from what another host kept after so many steps.
    resume(bytes, count) {
      new Uint8Array(core.memory.buffer).set(bytes);
      core.resume();
      steps = count;
    },
    // New footings: who, and the numbers of one.
    *footings() {
      core.stride(this.time - SEEN_S);
      for (let k = 0; k < rows.foot_numbers[0]; k++) {
        yield [rows.footings[k * (FOOTING + 1)], rows.footings.subarray(k * (FOOTING + 1) + 1, (k + 1) * (FOOTING + 1))];
      }
      rows.foot_numbers[0] = 0;
    },
    // What has happened: when, what, and which thing, event, point or group.
    *told() {
      for (let k = 0; k < rows.numbers[0]; k++) yield rows.told.subarray(4 * k, 4 * k + 3);
      rows.numbers[0] = 0;
    },
  };
}

// Each person's new footings in line; one that is told again is longer now.
function gathered(footings, ways = new Map()) {
  for (const [who, row] of footings) {
    if (!ways.has(who)) ways.set(who, []);
    const list = ways.get(who), last = list.length - FOOTING;
    if (last >= 0 && list[last + FROM] === row[FROM]) list.length = last;
    list.push(...row);
  }
  return ways;
}

// `told` is the scenario in crowd.json; `statues` lets its things sleep and awake.
function mindsOf(module, told, tables, acted, statues) {
  const people = told.begun.counts[0], seconds = facts.acted.seconds;
  const made = async (round) => runnerOf(await engineOf(module, { ...told.begun, seed: String(BigInt(told.begun.seed) + BigInt(round)) }, tables));
  let engine = null, prepared = null, round = 0, begun = false, caught = false, next = null, empty = 0, still = 0;
  let visitor = null, part = -1, leaves = 0, orders = [], early = new Map(); // `part` is the visitor's, until it `leaves`

  // What is new: kept until the engine has come to what is shown, then told.
  function tell(now) {
    gathered(engine.footings(), early);
    for (const [when, what, which] of engine.told()) {
      if (what === TOLD.awakens) statues.awake(told.things[which], when);
      if (what === TOLD.sleeps) statues.sleep(told.things[which]);
    }
    if (!caught) return;
    for (const [who, list] of early) acted.go_on(who, new Float32Array(list), now);
    early = new Map();
  }

  function begin() {
    if (begun) return;
    begun = true;
    statues.begin();
    prepare();
  }

  // Make the engine, before it is wanted.
  function prepare() { prepared ||= made(0).then((made) => { engine = made; }); }

  // What was wished since the last frame: events, and where the visitor is.
  function hear() {
    const { core } = engine;
    for (const name of orders.splice(0)) core.guide(EVENT, 0, -1, told.events.indexOf(name), 0, 0);
    if (visitor) {
      if (leaves < Infinity) part = core.freeGuest();
      leaves = Infinity;
      if (part >= 0) core.come(part, visitor[0], -visitor[1], Math.sin(visitor[2]), -Math.cos(visitor[2]));
    } else if (part >= 0 && leaves === Infinity) {
      core.depart(part);
      leaves = engine.time;
    }
  }

  // All are as at the beginning, but for chance: other ways, other choices.
  function anew() {
    if (next) return;
    next = made(++round).then((made) => {
      engine = made;
      part = -1;
      empty = still = leaves = 0;
      caught = true;
      for (let who = 0; who < people; who++) acted.begin(who, new Float32Array(0));
      statues.begin();
      state.now = 0;
      next = null;
    });
  }

  return {
    events: told.events,
    prepare,
    get begun() { return begun; },
    get own() { return state.now < leaves + SPARE_S ? part : -1; }, // nobody sees the own body
    get ahead() { return engine ? engine.time : 0; },
    // Let time pass by a frame that lasts so long; return what is shown then.
    go_on(now, step) {
      if (now + step > seconds - AHEAD_S - 2 || orders.length || visitor) begin();
      if (!begun || !engine) return now + step; // what was baked goes on meanwhile
      if (next) return now;
      const until = performance.now() + SPEND_MS, before = engine.steps;
      caught = caught || engine.time >= now + AHEAD_S;
      if (caught) hear();
      while (engine.time < now + step + AHEAD_S && performance.now() < until) engine.step();
      if (engine.steps > before) tell(now);
      const { present, posture } = engine.rows, others = (who) => present[who] && (who !== part || leaves < Infinity);
      empty = present.some((_, who) => others(who)) ? 0 : empty + step;
      still = present.some((_, who) => others(who) && WALKS.includes(posture[who])) ? 0 : still + step;
      if (empty > EMPTY_S || (still > STILL_S && !visitor)) anew();
      return caught ? Math.max(now, Math.min(now + step, engine.time - AHEAD_S + SPARE_S)) : now + step;
    },
    happen(name) { orders.push(name); },
    // Who walks along is a guest whom people see and go round; `at` is x, z and heading, or null.
    walk(at) { visitor = at; },
  };
}
