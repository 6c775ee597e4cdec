// Group behaviour 1, flocking: the members walk at one speed, have one goal, take ways of their own, and wait.
//
// Four rules: same speed; same goals; paths made as for everybody; who arrived waits until all of the band are there.

import { f, i, is, people, present } from "../memory";
import { has } from "./members";
import { SCRIPT, SPEED, give } from "./orders";
import { DONE, FLOCKING, band, bands, emotion, numbers, phase, speed, value, vigour } from "./state";

/** Rule 1: let the members of each flocking band walk as fast as they do on average. */
export function oneSpeed(): void {
  for (let one = 0, count = bands(); one < count; one++) {
    if (!has(one, FLOCKING)) continue;
    let total = 0.0, members = 0;
    for (let k = 0; k < people; k++) {
      if (i(band, k) != one || !is(present, k)) continue;
      total += naturalSpeed(k);
      members++;
    }
    for (let k = 0; k < people; k++) {
      if (i(band, k) == one && is(present, k)) give(SCRIPT, SPEED, k, total / <f64>members);
    }
  }
}

/** How fast somebody walks by the emotion, its value and the own vigour, m/s. */
export function naturalSpeed(one: i32): f64 {
  const regular = f(speed, i(numbers, 2));
  return (regular + f(value, one) * (f(speed, i(emotion, one)) - regular)) * f(vigour, one);
}

/** Rule 4: whether all members of a band are done where they were sent; until then those who are there wait. */
export function allThere(one: i32): bool {
  for (let k = 0; k < people; k++) {
    if (i(band, k) == one && is(present, k) && i(phase, k) != DONE) return false;
  }
  return true;
}
