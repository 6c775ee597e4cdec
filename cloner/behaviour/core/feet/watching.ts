// Everybody's footings: what bodies do is watched ten times a second, and feet follow, some seconds later.

import { i, is, people, present, setIs } from "../memory";
import { lastSeen, there } from "./state";
import { keepFrame } from "./track";
import { enter, goOn, lengthen, tellRow } from "./walker";

const FRAME_S: f64 = 0.1;

/** Take a frame of what everybody does now; who comes stands there, and who has gone goes his last steps. */
export function watch(): void {
  const frame = keepFrame();
  for (let one = 0; one < people; one++) {
    const now = is(present, one);
    if (now && !is(there, one)) enter(one, <f64>frame * FRAME_S);
    if (!now && is(there, one)) finish(one);
    setIs(there, one, now);
  }
}

/** Add footings until a time, s, in which the last one of each may still become longer. */
export function stride(until: f64): void {
  for (let one = 0; one < people; one++) {
    if (!is(there, one)) continue;
    goOn(one, until);
    tellRow(one);
  }
}

/** Add all footings there are to be: nothing more is watched. */
export function halt(): void {
  for (let one = 0; one < people; one++) {
    if (is(there, one)) finish(one);
  }
}

function finish(one: i32): void {
  const end = <f64>i(lastSeen, one) * FRAME_S;
  goOn(one, end);
  lengthen(one, end);
  tellRow(one);
}
