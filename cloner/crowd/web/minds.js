"use strict";
// A scenario that goes on in the page itself. What was baked is its beginning; the engine takes over before that ends, or
// as soon as somebody walks along or lets an event happen, and does the same steps up to there. Like a served scene's
// minds (cloner/scenes/served/minds.py) it is a little ahead of what is shown; when all have left it begins anew.

const SEEN_S = 2, AHEAD_S = 3, ENGINE_STEP_S = 0.05, FRAME_STEPS = 2; // feet want SEEN_S, the longest footing .8
const SPARE_S = 0.5, SPEND_MS = 6, EMPTY_S = 5; // taste: how far behind it may fall, a frame's time, how long nobody is there
const TOLD = { awakens: 0, sleeps: 1 }, EVENT = 15; // as core/minds/told.ts, rules.ts

// `told` is the scenario in crowd.json; `statues` lets its things sleep and awake.
async function mindsOf(module, told, tables, acted, statues) {
  const people = told.begun.counts[0], seconds = facts.acted.seconds;
  const made = (round) => engineOf(module, { ...told.begun, seed: String(BigInt(told.begun.seed) + BigInt(round)) }, tables);
  let engine = await made(0), steps = 0, round = 0, begun = false, caught = false, next = null, empty = 0;
  let visitor = null, part = -1, leaves = 0, orders = [], early = new Map(); // `part` is the visitor's, until it `leaves`
  const welcome = engine.core.freeGuest() >= 0, time = () => steps * ENGINE_STEP_S;

  function live() {
    const { core } = engine;
    if (!steps) core.watch();
    core.live();
    steps++;
    if (steps % FRAME_STEPS === 0) core.watch();
  }

  // New footings, each person's one after another: kept until the engine has come to what is shown, then told.
  function tell(now) {
    const { core, rows } = engine;
    core.stride(time() - SEEN_S);
    for (let k = 0; k < rows.foot_numbers[0]; k++) {
      const who = rows.footings[k * (FOOTING + 1)], row = rows.footings.subarray(k * (FOOTING + 1) + 1, (k + 1) * (FOOTING + 1));
      if (!early.has(who)) early.set(who, []);
      const list = early.get(who), last = list.length - FOOTING;
      if (last >= 0 && list[last + FROM] === row[FROM]) list.length = last; // it has become longer
      if (row[UNTIL] > now) list.push(...row);
    }
    rows.foot_numbers[0] = 0;
    if (caught) {
      for (const [who, list] of early) if (list.length) acted.go_on(who, new Float32Array(list), now);
      early = new Map();
    }
    for (let k = 0; k < rows.numbers[0]; k++) {
      const [when, what, which] = rows.told.subarray(4 * k, 4 * k + 3);
      if (what === TOLD.awakens) statues.awake(told.things[which], when);
      if (what === TOLD.sleeps) statues.sleep(told.things[which]);
    }
    rows.numbers[0] = 0;
  }

  function begin() {
    if (begun) return;
    begun = true;
    statues.begin();
  }

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
      leaves = time();
    }
  }

  // All are as at the beginning, but for chance: other ways, other choices.
  function anew() {
    if (next) return;
    next = made(++round).then((made) => {
      engine = made;
      steps = empty = 0;
      part = -1;
      leaves = 0;
      caught = true;
      for (let who = 0; who < people; who++) acted.begin(who, new Float32Array(0));
      statues.begin();
      state.now = 0;
      next = null;
    });
  }

  return {
    events: told.events,
    get begun() { return begun; },
    get own() { return state.now < leaves + SPARE_S ? part : -1; }, // nobody sees the own body
    get ahead() { return time(); },
    // Let time pass by a frame that lasts so long; return what is shown then.
    go_on(now, step) {
      if (now + step > seconds - AHEAD_S - 2 || orders.length || (visitor && welcome)) begin();
      if (!begun) return now + step;
      if (next) return now;
      const until = performance.now() + SPEND_MS, before = steps;
      caught = caught || time() >= now + AHEAD_S;
      if (caught) hear();
      while (time() < now + step + AHEAD_S && performance.now() < until) live();
      if (steps > before) tell(now);
      const there = engine.rows.present.some((one, who) => one && (who !== part || leaves < Infinity));
      empty = there ? 0 : empty + step;
      if (empty > EMPTY_S) anew();
      return caught ? Math.max(now, Math.min(now + step, time() - AHEAD_S + SPARE_S)) : now + step;
    },
    happen(name) { orders.push(name); },
    // Who walks along is a guest whom people see and go round; `at` is x, z and heading, or null.
    walk(at) { visitor = at; },
  };
}
