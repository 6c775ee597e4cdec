// People from outside, as who walks along in a page: seen, avoided and reacted to, but moved by nobody here.

import { STEP_S, f, facing, i, is, people, place, present, setF, setIs, velocity } from "../memory";
import { stands } from "../distances";
import { cellOf } from "../ground";
import { GUIDED, POSTURE, give } from "./orders";
import { OUTSIDE, guestAt, guestFacing, guestWanted, home, homeFlags, isGuest, leaving } from "./state";

/** A guest whose page tells places twice a second walks between them, no faster than so, m/s: a run; taste. Who is
 *  farther away than this, m, is there at once. */
const FASTEST_M_S: f64 = 4.0;
const JUMPS_M: f64 = 4.0;
const STAND: f64 = 0.0; // the first act of all scenarios

/** Whose place somebody from outside may take, -1 where all are taken. */
export function freeGuest(): i32 {
  for (let one = 0; one < people; one++) {
    if ((i(homeFlags, i(home, one)) & OUTSIDE) != 0 && !is(isGuest, one)) return one;
  }
  return -1;
}

/** Let a guest come, or go on, to a place on the floor, and look somewhere; who stands in a wall is not heard. */
export function come(one: i32, x: f64, y: f64, lookX: f64, lookY: f64): void {
  if (!stands(cellOf(x, y))) return;
  if (!is(isGuest, one)) {
    setIs(isGuest, one, true);
    give(GUIDED, POSTURE, one, STAND);
    setF(place, 2 * one, x);
    setF(place, 2 * one + 1, y);
    setF(guestAt, 2 * one, x);
    setF(guestAt, 2 * one + 1, y);
    setIs(present, one, true);
  }
  setF(guestWanted, 2 * one, x);
  setF(guestWanted, 2 * one + 1, y);
  setF(guestFacing, 2 * one, lookX);
  setF(guestFacing, 2 * one + 1, lookY);
}

/** Let a guest be gone. */
export function depart(one: i32): void {
  if (!is(isGuest, one)) return;
  setIs(isGuest, one, false);
  setIs(present, one, false);
}

/** Move guests by a step to where they are to be: nobody pushes them, and no order of the scenario moves them. */
export function keepGuests(): void {
  for (let one = 0; one < people; one++) {
    if (!is(isGuest, one)) continue;
    const x = f(guestWanted, 2 * one) - f(guestAt, 2 * one), y = f(guestWanted, 2 * one + 1) - f(guestAt, 2 * one + 1);
    const far = sqrt(x * x + y * y);
    const share = far > 0.0 && far < JUMPS_M ? min(FASTEST_M_S * STEP_S / far, 1.0) : 1.0;
    setF(guestAt, 2 * one, f(guestAt, 2 * one) + x * share);
    setF(guestAt, 2 * one + 1, f(guestAt, 2 * one + 1) + y * share);
    setF(velocity, 2 * one, far < JUMPS_M ? x * share / STEP_S : 0.0);
    setF(velocity, 2 * one + 1, far < JUMPS_M ? y * share / STEP_S : 0.0);
    for (let axis = 2 * one; axis < 2 * one + 2; axis++) {
      setF(place, axis, f(guestAt, axis));
      setF(facing, axis, f(guestFacing, axis));
    }
    setIs(present, one, true);
    setIs(leaving, one, false);
  }
}
