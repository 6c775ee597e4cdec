// Cloth that does not pass through itself: vertices keep apart unless they are neighbours in the cloth.
//
// No vertex gets through a triangle, and no edge through another, whose corners all stay farther off than a triangle's
// corners lie from its middle (.58 of an edge) and half the crossed diagonals of two edges (.71). Nothing is remembered,
// so what starts free stays free. What is pressed closer is guarded (`guards.ts`).

import { Cells } from "./cells";
import { areClose, clearGuards, guard } from "./guards";
import { extend, f, free, i, next, nextFirst, place, radius, setI, take, velocity, vertices } from "./memory";
import { apart2, away, move } from "./vectors";

/** Vertices farther off than this are not looked at until pairs are searched again, metres: layers that meet faster than
 *  2.4 m/s can pass. Nor are those whose speeds bring them no nearer than `SURE_M`. */
const REACH_M: f64 = 0.02;
const SURE_M: f64 = 0.004;
/** Farthest that one pair is moved apart in one small step, of its spacing: what was sewn too near unfolds step by step,
 *  and what is pushed faster flies. */
const AT_ONCE: f64 = 0.1;

let cells: Cells = changetype<Cells>(0);
let pairs: usize = 0; // i32, two a pair, the first ~ where they are only guarded, the second ~ where they are close;
                      // taken last, so that it can grow
let room: i32 = 0;
let found: i32 = 0;

/** Take what contact needs. Called last. */
export function arrangeContact(): void {
  cells = Cells.of(vertices);
  pairs = take(0);
}

/** Find the vertices that may meet within so many seconds. */
export function findPairs(seconds: f64): void {
  let widest = 0.0;
  for (let k = 0; k < vertices; k++) widest = max(widest, f(radius, k));
  const reach = 2.0 * widest + REACH_M;
  cells.sort(place, vertices, reach);
  found = 0;
  for (let one = 0; one < vertices; one++) {
    const column = cells.column(f(place, 3 * one)), row = cells.row(f(place, 3 * one + 1));
    const layer = cells.layer(f(place, 3 * one + 2)), left = max(column - 1, 0), right = min(column + 1, cells.wide - 1);
    for (let l = max(layer - 1, 0); l <= min(layer + 1, cells.deep - 1); l++) {
      for (let r = max(row - 1, 0); r <= min(row + 1, cells.high - 1); r++) {
        const end = i(cells.begin, cells.index(right, r, l) + 1);
        for (let k = i(cells.begin, cells.index(left, r, l)); k < end; k++) {
          const other = i(cells.listed, k);
          if (other > one && meetSoon(one, other, seconds, reach)) add(one, other);
        }
      }
    }
  }
}

// @ts-ignore: decorator
@inline function meetSoon(one: i32, other: i32, seconds: f64, reach: f64): bool {
  const square = apart2(place, one, other);
  if (square > reach * reach) return false;
  const soon = f(radius, one) + f(radius, other) + seconds * sqrt(apart2(velocity, one, other)) + SURE_M;
  if (square >= soon * soon) return false;
  return true;
}

function add(one: i32, other: i32): void {
  let near = false;
  for (let k = i(nextFirst, one); k < i(nextFirst, one + 1); k++) {
    if (i(next, k) == other) return;
    near = near || i(next, k) == ~other;
  }
  if (found == room) {
    room = max(2 * room, 1024);
    extend(pairs + (<usize>room << 3));
  }
  setI(pairs, 2 * found, near ? ~one : one);
  setI(pairs, 2 * found++ + 1, areClose(one, other) ? ~other : other);
}

/** Move vertices that are too near apart. */
export function keepApart(): void {
  for (let k = 0; k < found; k++) {
    const one = i(pairs, 2 * k);
    if (one < 0) continue;
    const second = i(pairs, 2 * k + 1), other = second < 0 ? ~second : second;
    const apart = f(radius, one) + f(radius, other);
    const x = away(place, one, other, 0), y = away(place, one, other, 1), z = away(place, one, other, 2);
    const square = x * x + y * y + z * z;
    if (square >= apart * apart) continue;
    const length = max(sqrt(square), 1e-9), light = f(free, one), otherLight = f(free, other);
    const share = min(apart - length, AT_ONCE * apart) / length / max(light + otherLight, 1e-12);
    move(one, -share * light, x, y, z);
    move(other, share * otherLight, x, y, z);
  }
}

/** Find what must be guarded until so many seconds later. */
export function findGuards(seconds: f64): void {
  clearGuards();
  for (let k = 0; k < found; k++) {
    const one = i(pairs, 2 * k), other = i(pairs, 2 * k + 1);
    guard(one < 0 ? ~one : one, other < 0 ? ~other : other, other < 0, seconds);
  }
}
