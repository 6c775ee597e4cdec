// Group behaviour 4, attraction: people gather in a region, spread by density, and look where they are told to look.

import { goal, i, setI, setIs, settled } from "../memory";
import { GAZE, GOAL, give } from "./orders";
import { placeLook } from "./state";

/** Send somebody to a region, facing what its point says, until a time. */
export function attract(level: i32, one: i32, place: i32, end: f64): void {
  give(level, GOAL, one, place, end);
  if (i(placeLook, place) >= 0) give(level, GAZE, one, i(placeLook, place), end);
  setIs(settled, one, false);
  setI(goal, one, -1); // the spot is chosen anew: all over the region
}
