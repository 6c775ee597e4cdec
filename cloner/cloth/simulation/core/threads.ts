// Threads drawn to their lengths one after the other.

import {
  anchor, bendEnds, bendGives, bendRest, bends, f, free, i, leash, place, stretchEnds, stretchGives, stretchRest,
  stretches, vertices,
} from "./memory";
import { apart2, away, move } from "./vectors";

/** Cloth may hang this much longer than it is. */
const LEASH: f64 = 1.01;

/** Let threads give as their fabric does; `softer` is one over the square of a small step's seconds. */
export function draw(softer: f64): void {
  for (let k = 0; k < stretches; k++) {
    pull(i(stretchEnds, 2 * k), i(stretchEnds, 2 * k + 1), f(stretchRest, k), softer * f(stretchGives, k));
  }
}

/** Let skip threads resist bending. */
export function bend(softer: f64): void {
  for (let k = 0; k < bends; k++) pull(i(bendEnds, 2 * k), i(bendEnds, 2 * k + 1), f(bendRest, k), softer * f(bendGives, k));
}

/** Draw back what is longer than its limit (Provot 1995); what is short folds as it likes. */
export function limit(longest: f64): void {
  for (let k = 0; k < stretches; k++) {
    const one = i(stretchEnds, 2 * k), other = i(stretchEnds, 2 * k + 1), most = longest * f(stretchRest, k);
    if (apart2(place, one, other) > most * most) pull(one, other, most, 0.0);
  }
}

// @ts-ignore: decorator
@inline function pull(one: i32, other: i32, rest: f64, soft: f64): void {
  const x = away(place, one, other, 0), y = away(place, one, other, 1), z = away(place, one, other, 2);
  const first = f(free, one), second = f(free, other), length = max(sqrt(x * x + y * y + z * z), 1e-9);
  const share = (1.0 - rest / length) / (first + second + soft + 1e-12);
  move(one, share * first, x, y, z);
  move(other, -share * second, x, y, z);
}

/** Draw back what went farther from what is held than its cloth is long (Kim, Chentanez, Mueller 2012). */
export function hang(): void {
  for (let k = 0; k < vertices; k++) {
    const to = i(anchor, k);
    if (to < 0) continue;
    const square = apart2(place, to, k), longest = LEASH * f(leash, k);
    if (square <= longest * longest) continue;
    move(k, longest / sqrt(square) - 1.0, away(place, to, k, 0), away(place, to, k, 1), away(place, to, k, 2));
  }
}
