// What a host calls: position-based dynamics with small steps.
//
// A host writes at `counts()` how many there are of everything, calls `begin`, fills what `memory.ts` lends, calls
// `ready`, and then `frame` once it wrote where skin and held vertices are at a frame's beginning and end. f64 with
// + - * / and square roots only, which every engine of WebAssembly rounds alike: the same input gives the same bits.

import { blow } from "./air";
import { arrangeContact, findGuards, findPairs, keepApart } from "./contact";
import { arrangeGuards, keepGap, sortGuards } from "./guards";
import {
  arrange, before, f, free, held, heldEarly, heldLate, helds, i, leadEarly, leadLate, place, setF, thrust, velocity,
  vertices,
} from "./memory";
import { arrangeSkin, findPlanes, keepOut } from "./skin";
import { bend, draw, hang, limit } from "./threads";
import { move } from "./vectors";

export { blow } from "./air";
export { findGuards, findPairs, keepApart } from "./contact";
export { keepGap } from "./guards";
export { at, counts } from "./memory";
export { findPlanes, keepOut } from "./skin";
export { hang, limit } from "./threads";

/** Threads resist bending in one of so many small steps, and are kept from growing; what is pressed is guarded anew. */
const SELDOM: i32 = 4;
const OFTEN: i32 = 2;
const GUARDED: i32 = 4;
/** Times a frame that cloth looks for what it may meet. */
const SEARCHES: i32 = 4;

export function begin(): void {
  arrange();
  arrangeSkin();
  arrangeGuards();
  arrangeContact();
}

export function ready(): void { sortGuards(); }

/** Let a frame pass in small steps.
 *
 *  Cloth rests `thick` metres from the skin, and no skin farther than `reach` is met between two searches; no vertex moves
 *  `fastest` m/s, and no thread stays `longest` times as long as it is. `kept` is the share of its speed that cloth keeps
 *  a small step, `caught` that of the wind that it catches, `led` that of the way to where it is led. */
export function frame(
  seconds: f64, steps: i32, thick: f64, reach: f64, fastest: f64, longest: f64, friction: f64, kept: f64,
  windX: f64, windY: f64, windZ: f64, caught: f64, led: f64,
): void {
  const h = seconds / <f64>steps, searched = max(1, steps / SEARCHES), softer = 1.0 / (h * h), share = 1.0 / <f64>steps;
  for (let number = 0; number < steps; number++) {
    if (number % searched == 0) {
      findPlanes(<f64>number * share, reach);
      findPairs(<f64>searched * h);
      blow(windX, windY, windZ, caught);
    }
    if (number % GUARDED == 0) findGuards(<f64>GUARDED * h);
    const gone = <f64>(number + 1) * share;
    fly(h);
    carry(gone);
    if (led > 0.0) lead(led, gone, share);
    if (number % SELDOM == 0) bend(softer);
    hang();
    draw(softer);
    if (number % OFTEN == 0) limit(longest);
    keepApart();
    keepOut(thick, friction, gone, share);
    slow(fastest * h);
    keepGap();
    for (let k = 0; k < 3 * vertices; k++) setF(velocity, k, (f(place, k) - f(before, k)) * kept / h);
  }
}

function fly(h: f64): void {
  memory.copy(before, place, <usize>vertices * 24);
  for (let k = 0; k < 3 * vertices; k++) setF(place, k, f(place, k) + h * (f(velocity, k) + h * f(thrust, k)));
}

/** Let no free vertex go farther in a small step. */
function slow(farthest: f64): void {
  for (let k = 0; k < vertices; k++) {
    const a = 3 * k, x = f(place, a) - f(before, a), y = f(place, a + 1) - f(before, a + 1);
    const z = f(place, a + 2) - f(before, a + 2), square = x * x + y * y + z * z;
    if (square > farthest * farthest && f(free, k) > 0.0) move(k, farthest / sqrt(square) - 1.0, x, y, z);
  }
}

/** Put what is held where it is after a share of the frame. */
function carry(gone: f64): void {
  for (let k = 0; k < helds; k++) {
    for (let axis = 0; axis < 3; axis++) {
      const at = (1.0 - gone) * f(heldEarly, 3 * k + axis) + gone * f(heldLate, 3 * k + axis);
      setF(place, 3 * i(held, k) + axis, at);
    }
  }
}

/** Go a share of the way to where cloth is led, in place and speed. */
function lead(led: f64, gone: f64, share: f64): void {
  for (let k = 0; k < 3 * vertices; k++) {
    const way = f(leadLate, k) - f(leadEarly, k), to = f(leadEarly, k) + gone * way;
    setF(place, k, f(place, k) + led * (to - f(place, k)));
    setF(before, k, f(before, k) + led * (to - share * way - f(before, k)));
  }
}
