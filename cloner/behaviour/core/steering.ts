// Which way and how fast to walk next: look along a fan of headings, take the one that leads nearest to the goal.
//
// The source's safe wandering made precise: where would the lines of my next places and the others' cross; turn away,
// and back when the way is free. The goal direction is always the fan's middle, so the previous heading returns by
// itself. Moussaid, Helbing, Theraulaz 2011, PNAS 108(17); Raupp Musse, Thalmann 2001 (ViCrowd), group behaviour 8.
// Measures in docs/behaviour_benchmark.md.

import {
  AHEAD_M, NEAREST, ahead, avoids, f, heading, i, is, looks, others, own, pace, period, place, radius, setF, velocity,
  way, wrapped,
} from "./memory";
import { cellOf, freeWay } from "./ground";

/** Headings on each side of the goal's, out to 75 degrees: the paper's field of vision, its steps halved. */
const SIDES: i32 = 12;
const TAN_HALF: f64 = 0.7673269879789604; // tan(37.5 degrees), so that the fan needs no sine
/** Seconds in which one could still stop: the paper has .5, .65 fits Weidmann better. */
const STOP_S: f64 = 0.65;
/** People are taken to walk half as they do and half as they want to: who stands but comes my way is avoided, who
 *  stands but goes my way is followed. Lanes form by it (two streams). */
const INTENT: f64 = 0.5;
/** Two who pass each other turn their shoulders; .8 of two radii is .32 m. */
const SHOULDERS: f64 = 0.8;
/** Nobody stands quite still before one who comes the other way, nearer than so: one edges past. m/s, m. */
const EDGING_M_S: f64 = 0.3;
const EDGING_M: f64 = 1.0;
/** Who stands steps aside, with this speed, m/s, for who comes nearer than so, m, and is in more of a hurry than one who
 *  arrives at a spot beside; taste. */
const ROOM_M: f64 = 0.7;
const HURRY_M_S: f64 = 0.5;
const STEPS_ASIDE_M_S: f64 = 0.5;
const HALF_ROOT: f64 = 0.7071067811865476;
/** Square of the cosine of 45 degrees: others further aside are beside one. At 60 degrees a .75 m door jams. */
const BESIDE: f64 = 0.5;

const cosines = memory.data((2 * SIDES + 1) * 8);
const sines = memory.data((2 * SIDES + 1) * 8);
// Of the others: relative place, expected velocity, square of the least distance; then of those who can be met.
const allX = memory.data(NEAREST * 8);
const allY = memory.data(NEAREST * 8);
const allReach = memory.data(NEAREST * 8);
const x = memory.data(NEAREST * 8);
const y = memory.data(NEAREST * 8);
const vx = memory.data(NEAREST * 8);
const vy = memory.data(NEAREST * 8);
const product = memory.data(NEAREST * 8); // of place and velocity
const square = memory.data(NEAREST * 8); // of both speeds
const room = memory.data(NEAREST * 8);

/** Cosine and sine of each heading: ahead, then right before left, growing. */
export function spreadFan(): void {
  setF(cosines, 0, 1.0);
  for (let k = 1; k <= SIDES; k++) {
    const t = <f64>k / <f64>SIDES * TAN_HALF;
    const cosine = (1.0 - t * t) / (1.0 + t * t), sine = 2.0 * t / (1.0 + t * t);
    setF(cosines, 2 * k - 1, cosine);
    setF(cosines, 2 * k, cosine);
    setF(sines, 2 * k - 1, -sine);
    setF(sines, 2 * k, sine);
  }
}

/** How near two come: the sum of their radii, less if they want to go opposite ways. */
// @ts-ignore: decorator
@inline export function least(one: i32, other: i32, opposite: bool): f64 {
  return (f(radius, other) + f(radius, one)) * (opposite ? SHOULDERS : 1.0);
}

/** Whether two want to go opposite ways; the wish of a person is way times own speed. */
// @ts-ignore: decorator
@inline export function passes(wishX: f64, wishY: f64, other: i32): bool {
  const speed = f(own, other);
  return f(way, 2 * other) * speed * wishX + f(way, 2 * other + 1) * speed * wishY < 0.0;
}

/** Let one person choose heading and pace. */
export function choose(one: i32): void {
  const wx = f(way, 2 * one), wy = f(way, 2 * one + 1);
  if (wx == 0.0 && wy == 0.0) {
    makeWay(one);
    return;
  }
  const px = f(place, 2 * one), py = f(place, 2 * one + 1), wanted = f(own, one), speed = max(wanted, 0.05);
  const wishX = wx * wanted, wishY = wy * wanted;
  const row = others + (<usize>one * <usize>NEAREST << 2);
  let all = 0, met = 0, edges = false;
  for (let k = 0; k < NEAREST && is(avoids, one); k++) {
    const other = i(row, k);
    if (other < 0) break;
    let dx = f(place, 2 * other) - px;
    const dy = f(place, 2 * other + 1) - py;
    if (period > 0.0) dx = wrapped(dx);
    const opposite = passes(wishX, wishY, other), reach = least(one, other, opposite);
    setF(allX, all, dx);
    setF(allY, all, dy);
    setF(allReach, all, reach);
    all++;
    if (dx * wx + dy * wy <= 0.0) continue; // behind: not seen
    const far = dx * dx + dy * dy;
    if (opposite && far < EDGING_M * EDGING_M) edges = true;
    let ux = f(velocity, 2 * other), uy = f(velocity, 2 * other + 1);
    ux += INTENT * (f(way, 2 * other) * f(own, other) - ux);
    uy += INTENT * (f(way, 2 * other + 1) * f(own, other) - uy);
    const quick = ux * ux + uy * uy;
    if (sqrt(far) - reach >= AHEAD_M + sqrt(quick) * (AHEAD_M / speed)) continue; // cannot be met in sight
    setF(x, met, dx);
    setF(y, met, dy);
    setF(vx, met, ux);
    setF(vy, met, uy);
    setF(product, met, dx * ux + dy * uy);
    setF(square, met, quick + speed * speed);
    setF(room, met, far - reach * reach);
    met++;
  }
  const cell = cellOf(px, py), sight = f(ahead, one);
  let best = Infinity, chosen = 0;
  for (let k = 0; k <= 2 * SIDES; k++) {
    const cosine = f(cosines, k), sine = f(sines, k);
    const ex = cosine * wx - sine * wy, ey = sine * wx + cosine * wy;
    const far = min(meeting(ex, ey, speed, met, min(freeWay(cell, ex, ey), sight)), sight);
    const away = sight * sight + far * far - 2.0 * cosine * sight * far;
    if (away < best) {
      best = away;
      chosen = k;
    }
    if ((k & 1) == 0 && k < 2 * SIDES) { // the best that any heading further out can give
      const next = f(sines, k + 1);
      if (best <= sight * sight * (next * next)) break;
    }
  }
  const hx = f(cosines, chosen) * wx - f(sines, chosen) * wy, hy = f(sines, chosen) * wx + f(cosines, chosen) * wy;
  const gap = min(freeWay(cell, hx, hy), standing(hx, hy, all));
  setF(heading, 2 * one, hx);
  setF(heading, 2 * one + 1, hy);
  setF(pace, one, min(wanted, max(gap / STOP_S, edges ? EDGING_M_S : 0.0)));
}

/** Let one who stands step out of the way of the nearest who wants to pass where he is: aside and along. Who
 *  looks at something stays. */
function makeWay(one: i32): void {
  setF(pace, one, 0.0);
  if (is(looks, one)) return;
  const row = others + (<usize>one * <usize>NEAREST << 2);
  for (let k = 0; k < NEAREST && is(avoids, one); k++) {
    const other = i(row, k);
    if (other < 0) return;
    const wx = f(way, 2 * other), wy = f(way, 2 * other + 1);
    let dx = f(place, 2 * one) - f(place, 2 * other);
    const dy = f(place, 2 * one + 1) - f(place, 2 * other + 1);
    if (period > 0.0) dx = wrapped(dx);
    if (dx * dx + dy * dy > ROOM_M * ROOM_M) return;
    const aside = wx * dy - wy * dx;
    if (f(own, other) < HURRY_M_S || dx * wx + dy * wy <= 0.0 || abs(aside) >= least(one, other, false)) continue;
    const side = aside >= 0.0 ? 1.0 : -1.0;
    setF(heading, 2 * one, (wx - side * wy) * HALF_ROOT);
    setF(heading, 2 * one + 1, (wy + side * wx) * HALF_ROOT);
    setF(pace, one, STEPS_ASIDE_M_S);
    return;
  }
}

/** How far one gets at one's own speed, at most `far`, before meeting anybody who walks on, metres. */
function meeting(ex: f64, ey: f64, speed: f64, met: i32, far: f64): f64 {
  const sx = speed * ex, sy = speed * ey;
  let soonest = Infinity;
  for (let k = 0; k < met; k++) {
    const b = sx * f(x, k) + sy * f(y, k) - f(product, k);
    if (b <= 0.0) continue;
    const a = f(square, k) - 2.0 * (sx * f(vx, k) + sy * f(vy, k));
    const root = b * b - a * f(room, k);
    if (root > 0.0) soonest = min(soonest, max(b - sqrt(root), 0.0) / max(a, 1e-9));
  }
  return min(soonest * speed, far);
}

/** How far one gets before touching anybody who would stand still, at most `AHEAD_M`, metres.
 *  Who is more beside than before one does not stop one: of two in a door the first goes. */
function standing(ex: f64, ey: f64, all: i32): f64 {
  let far = AHEAD_M;
  for (let k = 0; k < all; k++) {
    const dx = f(allX, k), dy = f(allY, k), reach = f(allReach, k), b = dx * ex + dy * ey;
    if (b <= 0.0) continue;
    const distance = dx * dx + dy * dy, root = b * b - distance + reach * reach;
    if (root > 0.0 && b * b > BESIDE * distance) far = min(far, max(b - sqrt(root), 0.0));
  }
  return far;
}
