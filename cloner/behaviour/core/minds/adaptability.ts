// Group behaviour 7, space adaptability: a band that adapts uses the whole region, in as many parts as it has people.
//
// Without it only a small part near the goal is used. Everybody gets a spot, so no two ways end the same.

import { f, goal, i, is, people, present, setF, setI, setIs, target } from "../memory";
import { CROWDED, SPOT, WHOSE, uniform } from "../dice";
import { has, mix } from "./members";
import {
  ADAPTS, away, band, blocked, lattice, latticeFirst, latticeLow, latticeWide, more, own, part, some, spotFirst, spots,
  spotsNearest,
} from "./state";

/** Two spots are no nearer than this, m; hosts lay them out so. */
const APART_M: f64 = 0.6;

/** Give those of one band in `some` a spot each in a place's region. */
export function giveSpots(many: i32, place: i32): void {
  const first = i(spotFirst, place), count = i(spotFirst, place + 1) - first;
  block(many, place, first, count);
  let found = has(i(band, i(some, 0)), ADAPTS) ? spread(many, place, first, count) : gather(many, first, count);
  for (; found < many; found++) { // more people than spots: they stand as near as they can
    setI(more, found, <i32>(uniform(CROWDED, place, i(some, found)) * <f64>count));
  }
  for (let k = 0; k < many; k++) setI(part, k, k);
  mix(part, many, WHOSE, place);
  for (let k = 0; k < many; k++) {
    const spot = first + i(more, i(part, k)), one = i(some, k);
    setF(target, 2 * one, f(spots, 2 * spot));
    setF(target, 2 * one + 1, f(spots, 2 * spot + 1));
  }
}

/** Write the free spots nearest to the middle into `more`, so many at most; return how many. */
function gather(many: i32, first: i32, count: i32): i32 {
  let found = 0;
  for (let k = 0; k < count && found < many; k++) {
    const spot = i(spotsNearest, first + k);
    if (!is(blocked, spot)) setI(more, found++, spot);
  }
  return found;
}

/** Write free spots all over a region into `more`: one at random, then always the farthest from those taken. */
function spread(many: i32, place: i32, first: i32, count: i32): i32 {
  let free = 0, at = 0;
  for (let k = 0; k < count; k++) free += is(blocked, k) ? 0 : 1;
  if (free == 0) return 0;
  let left = <i32>(uniform(SPOT, place, i(some, 0)) * <f64>free);
  while (is(blocked, at) || left-- > 0) at++;
  for (let k = 0; k < count; k++) setF(away, k, is(blocked, k) ? -1.0 : Infinity);
  let found = 0;
  for (; found < many && found < free; found++) {
    setI(more, found, at);
    const x = f(spots, 2 * (first + at)), y = f(spots, 2 * (first + at) + 1);
    let best = -1.0;
    for (let k = 0; k < count; k++) {
      if (is(blocked, k)) continue;
      const dx = f(spots, 2 * (first + k)) - x, dy = f(spots, 2 * (first + k) + 1) - y;
      const square = min(f(away, k), dx * dx + dy * dy);
      setF(away, k, square);
      if (square > best) {
        best = square;
        at = k;
      }
    }
  }
  return found;
}

/** Mark the spots of a place within half of `APART_M` of where anybody but those in `some` goes. */
function block(many: i32, place: i32, first: i32, count: i32): void {
  memory.fill(blocked, 0, <usize>count);
  for (let k = 0; k < many; k++) setIs(own, i(some, k), true);
  const wide = i(latticeWide, place), begin = i(latticeFirst, place);
  const deep = (i(latticeFirst, place + 1) - begin) / wide;
  for (let one = 0; one < people; one++) {
    if (i(goal, one) != place || !is(present, one) || is(own, one)) continue;
    const x = f(target, 2 * one), y = f(target, 2 * one + 1);
    const column = <i32>floor((x - f(latticeLow, 2 * place)) / APART_M);
    const row = <i32>floor((y - f(latticeLow, 2 * place + 1)) / APART_M);
    for (let r = row; r <= row + 1; r++) {
      for (let c = column; c <= column + 1; c++) {
        if (c < 0 || r < 0 || c >= wide || r >= deep) continue;
        const spot = i(lattice, begin + r * wide + c);
        if (spot < 0) continue;
        const dx = f(spots, 2 * (first + spot)) - x, dy = f(spots, 2 * (first + spot) + 1) - y;
        if (dx * dx + dy * dy <= 0.25 * APART_M * APART_M) setIs(blocked, spot, true);
      }
    }
  }
  for (let k = 0; k < many; k++) setIs(own, i(some, k), false);
}
