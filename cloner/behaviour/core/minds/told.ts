// What happened, as rows of numbers that a host puts into words.

import { i, setF, setI } from "../memory";
import { numbers, told, toldHeld } from "./state";

/** What is told; `which` is a thing, event, place or home, `many` people. A part follows the split it is of. */
export const AWAKENS: i32 = 0, SLEEPS: i32 = 1, HAPPENS: i32 = 2, FREE: i32 = 3, JOINED: i32 = 4, LED: i32 = 5,
  SPLITS: i32 = 6, PART: i32 = 7;

/** Tell it; what no host takes in time is lost. */
export function tell(now: f64, what: i32, which: i32, many: i32 = 0): void {
  const row = i(numbers, 0);
  if (row >= toldHeld) return;
  setF(told, 4 * row, now);
  setF(told, 4 * row + 1, what);
  setF(told, 4 * row + 2, which);
  setF(told, 4 * row + 3, many);
  setI(numbers, 0, row + 1);
}
