// What a host calls. The same module is run by Python (`host.py`) and by pages.
//
// A host writes at `counts()` how many there are of everything, calls `begin`, fills `clear`, `walls`, `near`, `regions`,
// calls `ready`, and sets people's rows. Bodies without minds go on by `step`, after `lead` for each place; a scenario,
// whose tables a host fills too (`tables.py`), goes on by `live`. f64 with + - * / and square roots only, which every
// engine of WebAssembly rounds alike, and random numbers of its own: the same input gives the same bits.

import { arrangeFeet } from "./feet/state";
import { arrange, arrangeGround } from "./memory";
import { arrangeSearch } from "./distances";
import { findWays } from "./fields";
import { castRays } from "./ground";
import { arrangeGrid } from "./nearby";
import { spreadFan } from "./steering";
import { arrangeSorting } from "./minds/members";
import { arrangeMinds } from "./minds/state";

export { at, counts } from "./memory";
export { keep, resume, sum } from "./snapshot";
export { step } from "./walkers";
export { halt, stride, watch } from "./feet/watching";
export { come, depart, freeGuest } from "./minds/guests";
export { guide, live } from "./minds/loop";

export function begin(x: f64, y: f64, periodM: f64, seed: u64): void {
  arrange(x, y, periodM, seed);
  arrangeGrid();
  arrangeMinds();
  arrangeSorting();
  arrangeFeet();
  arrangeGround();
  arrangeSearch();
  spreadFan();
}

export function ready(): void { castRays(); }

/** Find the ways to a place before anybody goes there; `distance` holds how far it is then. */
export function lead(place: i32): void { findWays(place); }
