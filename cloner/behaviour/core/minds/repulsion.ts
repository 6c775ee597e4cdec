// Group behaviour 5, repulsion: while a region is cleared, goals in it become goals outside; then all are free.

import { f, i, is, people, place, places, present, setF, setI } from "../memory";
import { AWAY, uniform } from "../dice";
import { GOAL, REACTION, chosen, give, ordered, withdraw } from "./orders";
import { goals, placeHigh, placeLow } from "./state";
import { FREE, tell } from "./told";

const MOST: i32 = 64; // regions that are cleared at once
const cleared = memory.data(MOST * 4);
const until = memory.data(MOST * 8);
export let count: i32 = 0;
export function setCount(regions: i32): void { count = regions; }

/** Clear a region until a time. */
export function keepClear(region: i32, end: f64): void {
  let k = 0;
  while (k < count && i(cleared, k) != region) k++;
  if (k == MOST) return;
  setI(cleared, k, region);
  setF(until, k, end);
  count = max(count, k + 1);
}

/** Send whoever is in a cleared region, or goes there, to a point outside it that was chosen at random. */
export function repel(now: f64): void {
  let left = 0;
  for (let k = 0; k < count; k++) {
    const region = i(cleared, k), end = f(until, k);
    if (end <= now) {
      letBack();
      tell(now, FREE, region);
      continue;
    }
    setI(cleared, left, region);
    setF(until, left++, end);
  }
  count = left;
  for (let k = 0; k < count; k++) sendAway(i(cleared, k));
}

function sendAway(region: i32): void {
  let outside = 0;
  for (let k = 0; k < places; k++) {
    if (apart(k, region)) setI(goals, outside++, k);
  }
  if (outside == 0) return;
  for (let one = 0; one < people; one++) {
    if (!is(present, one)) continue;
    const to = <i32>chosen(GOAL, one);
    const leads = to >= 0 && apart(to, region);
    if (leads || (to < 0 && !inside(f(place, 2 * one), f(place, 2 * one + 1), region))) continue;
    give(REACTION, GOAL, one, i(goals, <i32>(uniform(AWAY, region, one) * <f64>outside)));
  }
}

/** Whether the regions of two places do not meet. */
function apart(one: i32, other: i32): bool {
  for (let axis = 0; axis < 2; axis++) {
    if (f(placeHigh, 2 * one + axis) < f(placeLow, 2 * other + axis)) return true;
    if (f(placeLow, 2 * one + axis) > f(placeHigh, 2 * other + axis)) return true;
  }
  return false;
}

/** Whether a place lies in a region. */
export function inside(x: f64, y: f64, region: i32): bool {
  return x >= f(placeLow, 2 * region) && x < f(placeHigh, 2 * region)
    && y >= f(placeLow, 2 * region + 1) && y < f(placeHigh, 2 * region + 1);
}

function letBack(): void {
  for (let one = 0; one < people; one++) {
    if (ordered(REACTION, GOAL, one) >= 0.0) withdraw(REACTION, GOAL, one);
  }
}
