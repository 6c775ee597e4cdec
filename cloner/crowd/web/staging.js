"use strict";
// How a pack is staged: the same as cloner/crowd/staged/staging.py, number for number.

const UP = 18, STONE = 17, PART = 19, HEADLESS = 1, HEAD_ALONE = 2, HEAD_MIDDLE = 0.93, EYES = 0.93, LANTERN_M = 0.15;

// Values at a time of keys: rows of a time and values.
function easedKeys(keys, now) {
  let after = 0;
  while (after < keys.length && keys[after][0] <= now) after++;
  if (after === 0 || after === keys.length) return keys[Math.max(after - 1, 0)].slice(1);
  const first = keys[after - 1], last = keys[after], share = (now - first[0]) / (last[0] - first[0]);
  const eased = share * share * (3 - 2 * share);
  return first.slice(1).map((one, k) => one + (last[k + 1] - one) * eased);
}

// `statures` are the clones'; `rows` those of walkers.
function stagingOf(told, statures) {
  const wakes = new Map(told.wakes), hardens = new Map(told.hardens);
  const tall = (rows, i) => statures[Math.round(rows[i + 6])] * rows[i + 7];
  return {
    wakes,
    // When somebody is seen in what is acted: a statue not before it wakes.
    time(who, now) {
      const from = wakes.has(who) ? Math.max(now, wakes.get(who)) : now;
      return hardens.has(who) ? Math.min(from, hardens.get(who)) : from;
    },
    dress(rows, now) {
      for (const [name, column] of [["stone", STONE], ["up", UP]])
        for (const [who, keys] of told[name]) rows[who * 4 * PERSON_TEXELS + column] = easedKeys(keys, now)[0];
      for (const head of told.heads) {
        const body = head.of * 4 * PERSON_TEXELS, own = head.who * 4 * PERSON_TEXELS;
        rows[body + PART] = now >= head.until ? 0 : HEADLESS;
        if (now >= head.until) { rows[own] = GONE; continue; }
        const [x, y, z, heading, lean] = easedKeys(head.path, now);
        rows[own + 1] = x;
        rows[own + 2] = z;
        rows[own + 3] = heading;
        rows[own + UP] = y - HEAD_MIDDLE * tall(rows, own);
        rows[own + PART] = HEAD_ALONE + lean - Math.floor(lean);
        rows[own + STONE] = rows[body + STONE];
      }
    },
    hour(now) {
      const lantern = easedKeys(told.lantern, now), light = lantern.slice(3);
      return {
        daylight: easedKeys(told.light, now), stars: easedKeys(told.stars, now)[0], stops: easedKeys(told.stops, now)[0],
        lantern: [...lantern.slice(0, 3), light.some(Boolean) ? LANTERN_M : 0], lantern_light: light,
      };
    },
    camera(rows, now) {
      const shots = told.shots;
      let k = shots.length - 1;
      while (k > 0 && now < shots[k][0][0]) k--;
      const found = easedKeys(shots[k].map((key) => {
        const i = key[7] * 4 * PERSON_TEXELS;
        const look = key[7] < 0 ? key.slice(4, 7) : [rows[i + 1], rows[i + UP] + EYES * tall(rows, i), rows[i + 2]];
        return [...key.slice(0, 4), ...look, key[8]];
      }), now);
      return { place: found.slice(0, 3), target: found.slice(3, 6), fov: found[6] };
    },
    caption(now) {
      const found = told.captions.find(([first, last]) => first <= now && now < last);
      return found ? found[2] : "";
    },
    curtain(now) { return easedKeys(told.curtain, now)[0]; },
    film: told.film || null,
  };
}

const AWAKENS_S = 4, NEVER_S = 1e9; // a statue awakes in so long

// Statues of a scenario that goes on sleep until it is told that they awake; `told` is the pack's staging, or null.
function statuesOf(told, staging, acted) {
  const stone = told ? told.stone : [], start = stone.map(([who]) => acted.first(who));
  function put(k, at, keys) {
    staging.wakes.set(stone[k][0], at);
    stone[k][1] = keys;
  }
  return {
    who: new Set(stone.map(([who]) => who)),
    begin() {
      stone.forEach(([who], k) => {
        const still = new Float32Array(FOOTING);
        still.set(start[k]);
        still[UNTIL] = Infinity;
        acted.begin(who, still);
        put(k, NEVER_S, [[0, 1]]);
      });
    },
    awake(name, at) { if (told && told.things.includes(name)) put(told.things.indexOf(name), at, [[at, 1], [at + AWAKENS_S, 0]]); },
    sleep(name) { if (told && told.things.includes(name)) put(told.things.indexOf(name), NEVER_S, [[0, 1]]); },
  };
}
