// One step of everybody: goals become ways, ways headings and speeds, and bodies come apart from each other and walls.
//
// Fixed steps of .05 s; half of the people choose anew in each: nobody mirrors the one who comes towards them. f64 with
// + - * / and square roots only, which every engine of WebAssembly rounds alike: the same input gives the same bits.

import {
  NEAREST, STEP_S, f, heading, here, i, is, moved, others, own, pace, people, period, place, present, setF,
  setI, steps, tick, velocity, way, wrapped,
} from "./memory";
import { offWalls } from "./ground";
import { findNearest } from "./nearby";
import { choose, least, passes } from "./steering";
import { takeWays, turnBodies } from "./goals";

/** Time in which a person comes to the speed that was chosen; Helbing, Molnar 1995 have .5 s. */
const RELAX_S: f64 = 0.5;
/** The table of neighbours is kept so many steps, in which two people come .55 m nearer at most. */
const NEIGHBOURS_KEPT: i32 = 4;
/** Share of an overlap that both bodies make good in a step; less than half each keeps a jam from trembling. */
const APART: f64 = 0.4;
/** Two who touch also slide past each other, both to their right: by so much of the push, times one less the cosine
 *  between their ways. Pushed straight apart alone, crowds that cross before a door or meet in a corridor lock for ever
 *  (two of 40 seeds of two streams, none so). */
const ASIDE: f64 = 0.5;
const TOUCHING: i32 = 8; // neighbours that can touch a body of .2 m at once

/** How many people the table of neighbours is of. */
export let known: i32 = -1;
export function setKnown(count: i32): void { known = count; }

/** Let .05 s pass. */
export function step(): void {
  takeWays();
  let count = 0;
  for (let one = 0; one < people; one++) {
    if (is(present, one)) setI(here, count++, one);
  }
  if (steps % NEIGHBOURS_KEPT == 0 || known != count) {
    findNearest(count);
    known = count;
  }
  for (let k = 0; k < count; k++) {
    const one = i(here, k);
    if (((one + steps) & 1) == 0) choose(one);
  }
  for (let k = 0; k < count; k++) {
    const one = i(here, k), speed = f(pace, one);
    for (let axis = 0; axis < 2; axis++) {
      const now = f(velocity, 2 * one + axis);
      const next = now + (f(heading, 2 * one + axis) * speed - now) * (STEP_S / RELAX_S);
      setF(velocity, 2 * one + axis, next);
      setF(moved, 2 * one + axis, f(place, 2 * one + axis) + next * STEP_S);
    }
  }
  for (let k = 0; k < count; k++) settle(i(here, k));
  tick();
  turnBodies();
}

/** Move one body apart from others where all of them went, off the walls, and keep what velocity was left of it.
 *  Everybody's push is of the same moment: `moved` stays, `place` is written. */
function settle(one: i32): void {
  const oldX = f(place, 2 * one), oldY = f(place, 2 * one + 1), x = f(moved, 2 * one), y = f(moved, 2 * one + 1);
  const wishX = f(way, 2 * one) * f(own, one), wishY = f(way, 2 * one + 1) * f(own, one);
  const row = others + (<usize>one * <usize>NEAREST << 2);
  let pushX = 0.0, pushY = 0.0;
  for (let k = 0; k < TOUCHING; k++) {
    const other = i(row, k);
    if (other < 0) break;
    let dx = x - f(moved, 2 * other);
    const dy = y - f(moved, 2 * other + 1);
    if (period > 0.0) dx = wrapped(dx);
    const away = sqrt(dx * dx + dy * dy);
    const over = least(one, other, passes(wishX, wishY, other)) - away;
    if (over <= 0.0) continue;
    const alike = f(way, 2 * one) * f(way, 2 * other) + f(way, 2 * one + 1) * f(way, 2 * other + 1);
    const share = APART * over / max(away, 1e-6), aside = ASIDE * (1.0 - alike) * share;
    pushX += share * dx - aside * dy;
    pushY += share * dy + aside * dx;
  }
  setF(place, 2 * one, x + pushX);
  setF(place, 2 * one + 1, y + pushY);
  offWalls(one, place);
  const vx = f(velocity, 2 * one), vy = f(velocity, 2 * one + 1);
  const wentX = (f(place, 2 * one) - oldX) / STEP_S, wentY = (f(place, 2 * one + 1) - oldY) / STEP_S;
  const share = max(min((wentX * vx + wentY * vy) / max(vx * vx + vy * vy, 1e-9), 1.0), 0.0);
  setF(velocity, 2 * one, vx * share);
  setF(velocity, 2 * one + 1, vy * share);
  if (period > 0.0) setF(place, 2 * one, f(place, 2 * one) - period * floor(f(place, 2 * one) / period));
}
