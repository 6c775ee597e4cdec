"use strict";
// Who stands, walks and sits where, in which look: the same rules as cloner/crowd/staged/scene.py, number for number.

const LANE_M = 0.85, ALONG_M = 1.8, RING_FROM_M = 6, RING_M = 0.95, SEAT_M = 0.56, ROW_M = 0.85, ROW_UP_M = 0.42;
const STAND_FROM_M = 24, AISLE_M = 2.6, CLASSES = 3, ENOUGH = 9, MIXED = 5, PERSON_TEXELS = 5, WALK = 0, IDLE = 1, SIT = 2;

class Dice {
  constructor(seed) { this.state = seed >>> 0; }
  roll() {
    this.state = (this.state + 0x6d2b79f5) >>> 0;
    let t = this.state;
    t = Math.imul(t ^ (t >>> 15), 1 | t) >>> 0;
    t = ((t + Math.imul(t ^ (t >>> 7), 61 | t)) ^ t) >>> 0;
    return ((t ^ (t >>> 14)) >>> 0) / 4294967296;
  }
  pick(count) { return Math.min(Math.floor(this.roll() * count), count - 1); }
}

function orderOf(line, casting, dice) {
  const own = [];
  for (let c = 0; c < casting.clones; c++)
    if (casting.clones < ENOUGH || c % CLASSES === line % CLASSES) own.push(c);
  for (let k = own.length - 1; k > 0; k--) {
    const other = dice.pick(k + 1);
    [own[k], own[other]] = [own[other], own[k]];
  }
  return own;
}

function mixed(order, k, dice) {
  if (!k || k % order.length || order.length < MIXED) return;
  for (let j = (k / order.length) % 2; j < order.length - 1; j += 2)
    if (dice.roll() < 0.5) [order[j], order[j + 1]] = [order[j + 1], order[j]];
}

function lookOf(clone, casting, dice) {
  const donors = [clone, clone, clone], dyes = [-1, -1, -1, -1], kind = dice.roll();
  ["top", "bottom", "shoes"].forEach((garment, k) => {
    const first = dice.roll(), second = dice.roll();
    const palette = casting.palettes[garment] || [], others = (casting.wardrobe[garment] || [])[clone] || [];
    if (kind >= casting.own_share && kind < casting.own_share + casting.dyed_share) {
      if (palette.length && (k === 0 || first < 0.6))
        dyes[k] = palette[Math.min(Math.floor(second * palette.length), palette.length - 1)];
    } else if (kind >= casting.own_share && others.length && (k === 0 || first < 0.5)) {
      donors[k] = others[Math.min(Math.floor(second * others.length), others.length - 1)];
    }
  });
  const first = dice.roll(), second = dice.roll(), hair = casting.palettes.hair || [];
  if (hair.length && first < 0.5) dyes[3] = hair[Math.min(Math.floor(second * hair.length), hair.length - 1)];
  return [donors, dyes];
}

function addTo(rows, path, speed, clone, clip, up, casting, dice) {
  const scale = 0.96 + 0.08 * dice.roll(), phase = dice.roll();
  const [donors, dyes] = lookOf(clone, casting, dice);
  rows.push(...path, speed, phase, clone, scale, ...donors, clip, ...dyes, up, 0, 0, 0);
}

const counted = (rows) => rows.length / (4 * PERSON_TEXELS);

const SCENES = {
  walk(people, casting, dice) {
    const lane = Math.max(40, Math.ceil(Math.sqrt(people * LANE_M * ALONG_M) * 1.2));
    const each = Math.floor(lane / ALONG_M), lanes = Math.ceil(people / each), rows = [];
    for (let j = 0; j < lanes; j++) {
      const order = orderOf(j, casting, dice), speed = 1.15 + 0.35 * dice.roll();
      const way = Math.floor(j / 3) % 2 === 0 ? 1 : -1, shift = dice.roll() * lane;
      const count = Math.min(each, people - counted(rows));
      for (let k = 0; k < count; k++) {
        const start = shift + (k * lane) / each + (dice.roll() - 0.5) * 0.5;
        const x = (j - (lanes - 1) / 2) * LANE_M + (dice.roll() - 0.5) * 0.1;
        addTo(rows, [1, x, start, way], speed, order[k % order.length], WALK, 0, casting, dice);
      }
    }
    return { rows, lane };
  },
  plaza(people, casting, dice) {
    const rows = [];
    for (let ring = 0; counted(rows) < people; ring++) {
      const radius = RING_FROM_M + RING_M * ring, order = orderOf(ring, casting, dice);
      const speed = 1.15 + 0.35 * dice.roll(), way = Math.floor(ring / 2) % 2 === 0 ? 1 : -1, stands = ring % 4 === 3;
      const fit = Math.floor((2 * Math.PI * radius) / ALONG_M), each = fit - (fit >= order.length ? fit % order.length : 0);
      const count = Math.min(each, people - counted(rows));
      for (let k = 0; k < count; k++) {
        const angle = ((k + (dice.roll() - 0.5) * 0.3) * 2 * Math.PI) / each, clone = order[k % order.length];
        if (stands) {
          const heading = dice.roll() * 2 * Math.PI;
          addTo(rows, [0, radius * Math.sin(angle), radius * Math.cos(angle), heading], 0, clone, IDLE, 0, casting, dice);
        } else addTo(rows, [2, radius, angle, way], speed, clone, WALK, 0, casting, dice);
      }
    }
    return { rows, lane: 100 };
  },
  stadium(people, casting, dice) {
    const rows = [], rises = Math.max(8, Math.ceil(Math.sqrt(people) / 4));
    for (let row = 0; counted(rows) < people; row++) {
      const tier = Math.floor(row / rises), level = row % rises, radius = STAND_FROM_M + ROW_M * level;
      const order = orderOf(level, casting, dice), arc = (2 * Math.PI) / 3 - AISLE_M / radius;
      const each = Math.floor((arc * radius) / SEAT_M);
      const count = Math.min(each, people - counted(rows));
      for (let k = 0; k < count; k++) {
        mixed(order, k, dice);
        const angle = Math.PI - arc / 2 + ((k + 0.5) * arc) / each + (tier * 2 * Math.PI) / 3;
        const heading = angle + Math.PI + (dice.roll() - 0.5) * 0.3;
        const clip = dice.roll() < 0.15 ? IDLE : SIT, clone = order[k % order.length];
        addTo(rows, [0, radius * Math.sin(angle), radius * Math.cos(angle), heading], 0, clone, clip, ROW_UP_M * level,
              casting, dice);
      }
    }
    return { rows, lane: 100 };
  },
};

function sceneOf(name, people, casting, seed = 1) {
  const { rows, lane } = SCENES[name](people, casting, new Dice(seed));
  return { rows: new Float32Array(rows), lane, count: rows.length / (4 * PERSON_TEXELS) };
}
