// All that changes, as one piece of memory: a host copies it, and another one that has begun with the same counts goes on
// from there.

import { f, ground, i, is, people, place, places, setF, setI, setSteps, steps } from "./memory";
import { findWays } from "./fields";
import { frames, setFrames } from "./feet/state";
import { ordered, setOrdered } from "./minds/loop";
import { setSoonest, soonest } from "./minds/orders";
import { count, setCount } from "./minds/repulsion";
import { led } from "./minds/state";
import { known, setKnown } from "./walkers";

const COUNTS = memory.data(6 * 4);
const SOONEST = memory.data(8);

/** A number of all places to the last bit (FNV-1a of 32 bits), so that hosts see that they agree. */
export function sum(): u32 {
  let found: u32 = 0x811c9dc5;
  for (let k = 0, bytes = 16 * people; k < bytes; k++) found = (found ^ load<u8>(place + <usize>k)) * 0x01000193;
  return found;
}

/** Make the memory whole; return how many of its first bytes change. */
export function keep(): usize {
  setI(COUNTS, 0, steps);
  setI(COUNTS, 1, known);
  setI(COUNTS, 2, ordered);
  setI(COUNTS, 3, count);
  setI(COUNTS, 4, frames);
  setF(SOONEST, 0, soonest);
  return ground;
}

/** Go on from a memory that was kept elsewhere and copied here; the ground has been told already. */
export function resume(): void {
  setSteps(i(COUNTS, 0));
  setKnown(i(COUNTS, 1));
  setOrdered(i(COUNTS, 2));
  setCount(i(COUNTS, 3));
  setFrames(i(COUNTS, 4));
  setSoonest(f(SOONEST, 0));
  for (let k = 0; k < places; k++) {
    if (is(led, k)) findWays(k);
  }
}
