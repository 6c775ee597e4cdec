// What lies so near itself that edges could pass through edges, or corners through triangles: kept apart one by one.
//
// Where skin presses layers of cloth together, vertices come nearer than cloth keeps apart. What lies near such vertices
// is guarded for a few small steps: its gap, and the side on which it was when they began.

import {
  f, faces, free, i, place, radius, setF, setI, stretchEnds, stretches, take, triangles, velocity, vertices,
} from "./memory";
import { apart2, away, move } from "./vectors";

/** Least gap between edges, and between a corner and a triangle, of the distance that their vertices keep. */
const GAP: f64 = 0.18;
/** Two edges; a vertex and a triangle. */
const EDGES: i32 = 0;
const CORNER: i32 = 1;
/** Shares below this are an end: there the way to what is near turns freely, and tells no side. */
const END: f64 = 1e-3;

let edgeFirst: usize = 0; // n + 1, i32: where each vertex' edges begin in `edgeOther`
let edgeOther: usize = 0; // i32, the other end
let faceFirst: usize = 0; // n + 1, i32
let faceOf: usize = 0; // i32, triangles of each vertex
let longest: usize = 0; // n, square of each vertex' longest edge
let guards: usize = 0; // five i32 a guard: what it is, and its four vertices
let sides: usize = 0; // three f64 a guard: the way between its nearest points when they were inside both, else 0
let room: i32 = 0;
let found: i32 = 0;

export function arrangeGuards(): void {
  const n = <usize>vertices;
  edgeFirst = take((n + 1) * 4); edgeOther = take(<usize>stretches * 8);
  faceFirst = take((n + 1) * 4); faceOf = take(<usize>triangles * 12);
  longest = take(n * 8);
  room = 16 * vertices + 1024;
  guards = take(<usize>room * 20);
  sides = take(<usize>room * 24);
}

/** Sort edges and triangles by their vertices. */
export function sortGuards(): void {
  sort(stretchEnds, 2 * stretches, edgeFirst, edgeOther);
  for (let k = 0; k < 2 * stretches; k++) {
    const at = i(edgeOther, k);
    setI(edgeOther, k, i(stretchEnds, at ^ 1));
  }
  sort(faces, 3 * triangles, faceFirst, faceOf);
  for (let k = 0; k < 3 * triangles; k++) setI(faceOf, k, i(faceOf, k) / 3);
}

/** Where each vertex stands among `total` entries. */
function sort(entries: usize, total: i32, first: usize, listed: usize): void {
  memory.fill(first, 0, (<usize>vertices + 1) << 2);
  for (let k = 0; k < total; k++) setI(first, i(entries, k), i(first, i(entries, k)) + 1);
  for (let k = 1; k <= vertices; k++) setI(first, k, i(first, k) + i(first, k - 1));
  for (let k = total - 1; k >= 0; k--) {
    const to = i(first, i(entries, k)) - 1;
    setI(first, i(entries, k), to);
    setI(listed, to, k);
  }
}

/** Forget all guards. */
export function clearGuards(): void {
  found = 0;
  for (let one = 0; one < vertices; one++) {
    let most = 0.0;
    for (let k = i(edgeFirst, one); k < i(edgeFirst, one + 1); k++) most = max(most, apart2(place, one, i(edgeOther, k)));
    setF(longest, one, most);
  }
}

/** Guard what lies round two vertices that are near each other, if it may meet within so many seconds.
 *
 *  Edges that meet have ends half of their squares apart, or, where those are joined and no pair, others all of them. That
 *  can be where both vertices have a neighbour in common: they are `close`. */
export function guard(one: i32, other: i32, close: bool, seconds: f64): void {
  const square = apart2(place, one, other);
  const reach = GAP * (f(radius, one) + f(radius, other)) + seconds * sqrt(apart2(velocity, one, other));
  const meet = (f(longest, one) + f(longest, other)) / 4.0, wide = square > reach * reach + meet;
  if (wide && (!close || square > reach * reach + 2.0 * meet)) return;
  const begin = i(edgeFirst, other);
  let beside: i32 = 0; // which of the other's edges end at a neighbour of the first
  for (let l = begin; wide && l < i(edgeFirst, other + 1); l++) if (joined(one, i(edgeOther, l))) beside |= 1 << (l - begin);
  for (let k = i(edgeFirst, one); k < i(edgeFirst, one + 1); k++) {
    const two = i(edgeOther, k);
    if (two == other) continue;
    const near = wide && joined(two, other);
    for (let l = begin; l < i(edgeFirst, other + 1); l++) {
      const three = i(edgeOther, l);
      if (three == one || three == two) continue;
      if (wide && !near && !((beside >> (l - begin)) & 1)) continue;
      // each pair of edges once: where its nearest ends are found
      if (nearest(square, one, other, one, three) && nearest(square, one, other, two, other)
        && nearest(square, one, other, two, three)) add(EDGES, one, two, other, three);
    }
  }
  if (wide) return;
  corner(one, other, square);
  corner(other, one, square);
}

/** Whether two other ends of edges are farther apart, or joined by an edge: those are no pair. */
// @ts-ignore: decorator
@inline function nearest(square: f64, one: i32, other: i32, p: i32, q: i32): bool {
  const far = apart2(place, p, q);
  return far > square || (far == square && (one < p || (one == p && other <= q))) || joined(p, q);
}

function joined(one: i32, other: i32): bool {
  for (let k = i(edgeFirst, one); k < i(edgeFirst, one + 1); k++) if (i(edgeOther, k) == other) return true;
  return false;
}

/** Whether two vertices have a neighbour in common. */
export function areClose(one: i32, other: i32): bool {
  for (let k = i(edgeFirst, one); k < i(edgeFirst, one + 1); k++) if (joined(i(edgeOther, k), other)) return true;
  return false;
}

/** Guard a vertex against the triangles of another that is their nearest corner. */
function corner(one: i32, other: i32, square: f64): void {
  for (let k = i(faceFirst, other); k < i(faceFirst, other + 1); k++) {
    const t = 3 * i(faceOf, k), p = i(faces, t), q = i(faces, t + 1), r = i(faces, t + 2);
    if (p == one || q == one || r == one) continue;
    if (!nearest(square, one, other, one, p) || !nearest(square, one, other, one, q) || !nearest(square, one, other, one, r)) continue;
    add(CORNER, one, p, q, r);
  }
}

function add(kind: i32, p: i32, q: i32, r: i32, s: i32): void {
  if (found == room) return; // more than are ever pressed at once
  const at = 5 * found;
  setI(guards, at, kind); setI(guards, at + 1, p); setI(guards, at + 2, q); setI(guards, at + 3, r); setI(guards, at + 4, s);
  approach(found);
  memory.fill(sides + <usize>found * 24, 0, 24);
  if (inside()) keepSide(found);
  found++;
}

// The nearest points of what is guarded: shares of its four vertices, less than 0 in the second point, and the way from
// the first to the second.
let w0: f64 = 0;
let w1: f64 = 0;
let w2: f64 = 0;
let w3: f64 = 0;
let dx: f64 = 0;
let dy: f64 = 0;
let dz: f64 = 0;

/** Keep what is guarded a gap apart, on the side on which it was. */
export function keepGap(): void {
  for (let k = 0; k < found; k++) {
    const at = 5 * k, p = i(guards, at + 1), q = i(guards, at + 2), r = i(guards, at + 3), s = i(guards, at + 4);
    const gap = GAP * (f(radius, p) + f(radius, r));
    approach(k);
    const square = dx * dx + dy * dy + dz * dz;
    if (square < 1e-18) continue;
    let passed = false;
    if (inside()) {
      passed = dx * f(sides, 3 * k) + dy * f(sides, 3 * k + 1) + dz * f(sides, 3 * k + 2) < 0.0;
      if (!passed) keepSide(k);
    }
    if (square >= gap * gap && !passed) continue;
    const far = sqrt(square);
    const first = w0 * f(free, p), second = w1 * f(free, q), third = w2 * f(free, r), fourth = w3 * f(free, s);
    // where only a far end is free it goes no farther than what is lacking
    const most = max(max(abs(first), abs(second)), max(abs(third), abs(fourth)));
    const light = max(w0 * first + w1 * second + w2 * third + w3 * fourth, most);
    if (light == 0.0) continue;
    const share = (passed ? far + gap : far - gap) / far / light;
    move(p, share * first, dx, dy, dz);
    move(q, share * second, dx, dy, dz);
    move(r, share * third, dx, dy, dz);
    move(s, share * fourth, dx, dy, dz);
  }
}

/** Find the nearest points of a guard. */
// @ts-ignore: decorator
@inline function approach(k: i32): void {
  const at = 5 * k, p = i(guards, at + 1), q = i(guards, at + 2), r = i(guards, at + 3), s = i(guards, at + 4);
  if (i(guards, at) == EDGES) edges(p, q, r, s);
  else triangle(p, q, r, s);
}

function keepSide(k: i32): void {
  setF(sides, 3 * k, dx);
  setF(sides, 3 * k + 1, dy);
  setF(sides, 3 * k + 2, dz);
}

/** Whether both nearest points lie inside what is guarded, not at its ends. */
// @ts-ignore: decorator
@inline function inside(): bool {
  return abs(w0) > END && abs(w1) > END && abs(w2) > END && abs(w3) > END;
}

/** Find the nearest points of two edges p q and r s (Ericson, Real-Time Collision Detection 2005, 5.1.9). */
function edges(p: i32, q: i32, r: i32, s: i32): void {
  const ux = away(place, p, q, 0), uy = away(place, p, q, 1), uz = away(place, p, q, 2);
  const vx = away(place, r, s, 0), vy = away(place, r, s, 1), vz = away(place, r, s, 2);
  const x = away(place, r, p, 0), y = away(place, r, p, 1), z = away(place, r, p, 2);
  const a = max(ux * ux + uy * uy + uz * uz, 1e-18), e = max(vx * vx + vy * vy + vz * vz, 1e-18);
  const b = ux * vx + uy * vy + uz * vz, c = ux * x + uy * y + uz * z, g = vx * x + vy * y + vz * z, d = a * e - b * b;
  let first = d > 1e-18 ? min(max((b * g - c * e) / d, 0.0), 1.0) : 0.5, second = (b * first + g) / e;
  if (second < 0.0) {
    second = 0.0;
    first = min(max(-c / a, 0.0), 1.0);
  } else if (second > 1.0) {
    second = 1.0;
    first = min(max((b - c) / a, 0.0), 1.0);
  }
  w0 = 1.0 - first; w1 = first; w2 = second - 1.0; w3 = -second;
  dx = second * vx - first * ux - x; dy = second * vy - first * uy - y; dz = second * vz - first * uz - z;
}

/** Find the point of a triangle q r s nearest to p (Ericson 2005, 5.1.5). */
function triangle(p: i32, q: i32, r: i32, s: i32): void {
  const ax = away(place, q, r, 0), ay = away(place, q, r, 1), az = away(place, q, r, 2);
  const bx = away(place, q, s, 0), by = away(place, q, s, 1), bz = away(place, q, s, 2);
  const x = away(place, q, p, 0), y = away(place, q, p, 1), z = away(place, q, p, 2);
  const aa = ax * ax + ay * ay + az * az, ab = ax * bx + ay * by + az * bz, bb = bx * bx + by * by + bz * bz;
  const d1 = ax * x + ay * y + az * z, d2 = bx * x + by * y + bz * z;
  const d3 = d1 - aa, d4 = d2 - ab, d5 = d1 - ab, d6 = d2 - bb;
  const va = d3 * d6 - d5 * d4, vb = d5 * d2 - d1 * d6, vc = d1 * d4 - d3 * d2;
  let one = 0.0, two = 0.0; // shares of r and s
  if (d1 > 0.0 || d2 > 0.0) {
    if (d3 >= 0.0 && d4 <= d3) one = 1.0;
    else if (vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0) one = d1 / (d1 - d3);
    else if (d6 >= 0.0 && d5 <= d6) two = 1.0;
    else if (vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0) two = d2 / (d2 - d6);
    else if (va <= 0.0 && d4 >= d3 && d5 >= d6) {
      two = (d4 - d3) / (d4 - d3 + d5 - d6);
      one = 1.0 - two;
    } else {
      one = vb / (va + vb + vc);
      two = vc / (va + vb + vc);
    }
  }
  w0 = 1.0; w1 = one + two - 1.0; w2 = -one; w3 = -two;
  dx = one * ax + two * bx - x; dy = one * ay + two * by - y; dz = one * az + two * bz - z;
}
