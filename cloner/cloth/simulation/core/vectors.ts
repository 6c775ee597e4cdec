// Points of space, three numbers of an array each.

import { f, place, setF } from "./memory";

/** Move a vertex by a share of a way. */
// @ts-ignore: decorator
@inline export function move(vertex: i32, share: f64, x: f64, y: f64, z: f64): void {
  setF(place, 3 * vertex, f(place, 3 * vertex) + share * x);
  setF(place, 3 * vertex + 1, f(place, 3 * vertex + 1) + share * y);
  setF(place, 3 * vertex + 2, f(place, 3 * vertex + 2) + share * z);
}

/** How far two rows of an array are apart along an axis: how the second lies from the first. */
// @ts-ignore: decorator
@inline export function away(array: usize, one: i32, other: i32, axis: i32): f64 {
  return f(array, 3 * other + axis) - f(array, 3 * one + axis);
}

/** The squared distance of two rows of an array. */
// @ts-ignore: decorator
@inline export function apart2(array: usize, one: i32, other: i32): f64 {
  const x = away(array, one, other, 0), y = away(array, one, other, 1), z = away(array, one, other, 2);
  return x * x + y * y + z * z;
}
