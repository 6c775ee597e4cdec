// The arrays of the core, one after the other in the module's memory. A host asks `at(kind)` where one lies.
//
// Metres, seconds, radians; f64 unless told; pairs are x, y. n people, c = rows x cols cells, p places.

export const NEAREST: i32 = 16;
export const DIRECTIONS: i32 = 64;
/** Side of a cell of the raster, `ground.CELL_M`; how far anybody looks: 6 m walks faster than 4 m at low density. */
export const CELL_M: f64 = 0.2;
export const AHEAD_M: f64 = 6.0;
export const STEP_S: f64 = 0.05;
/** Goals that are no place: none, and a way that the host gives. */
export const NOWHERE: i32 = -1;
export const GIVEN: i32 = -2;

export let people: i32 = 0;
export let rows: i32 = 0;
export let cols: i32 = 0;
export let reach: i32 = 0; // walls a cell's list holds
export let lowX: f64 = 0;
export let lowY: f64 = 0;
export let period: f64 = 0; // > 0: the world repeats along x
export let seed: u64 = 0;
export let steps: i32 = 0;

export let place: usize = 0; // n x 2
export let velocity: usize = 0; // n x 2
export let heading: usize = 0; // n x 2, chosen by steering
export let pace: usize = 0; // n, chosen by steering
export let way: usize = 0; // n x 2, unit direction to the goal
export let wants: usize = 0; // n, the speed each would like on a free way
export let own: usize = 0; // n, less of it before one's spot
export let ahead: usize = 0; // n
export let radius: usize = 0; // n
export let target: usize = 0; // n x 2, the spot
export let curve: usize = 0; // n x 4, start and control point of one's curve
export let facing: usize = 0; // n x 2
export let turn: usize = 0; // n, a wanderer's angular velocity
export let look: usize = 0; // n x 2, what is looked at
export let goal: usize = 0; // n, i32: a place, NOWHERE or GIVEN
export let slow: usize = 0; // n, i32: steps since one walked, near the spot
export let present: usize = 0; // n, u8 as all that follow
export let avoids: usize = 0;
export let spotted: usize = 0; // has a spot; else one walks into the region
export let settled: usize = 0;
export let direct: usize = 0;
export let wanders: usize = 0;
export let looks: usize = 0;
export let clear: usize = 0; // c, distance to the nearest wall
export let walls: usize = 0; // w x 4
export let near: usize = 0; // c x reach, i32: walls within touch of a cell, then -1
export let fields: usize = 0; // p x c x 2, direction to walk to a place
export let regions: usize = 0; // p x c, u8: cells of a place's region
export let free: usize = 0; // c x 64, f32: how far a body gets
export let moved: usize = 0; // n x 2, places before this step's bodies moved apart
export let distance: usize = 0; // c, to the place whose ways are looked for; written by the host
export let after: usize = 0; // c, i32: the next cell on the way there
export let spare: usize = 0; // c x 2
export let others: usize = 0; // n x 16, i32: the nearest, then -1
export let here: usize = 0; // n, i32: who is there

let top: usize = 0;

/** Take bytes of the memory; they are zero. */
export function take(bytes: usize): usize {
  if (top == 0) top = __heap_base;
  const found = (top + 15) & ~15;
  top = found + bytes;
  const more = <i32>((top + 0xffff) >>> 16) - memory.size();
  if (more > 0 && memory.grow(more) < 0) unreachable();
  return found;
}

/** Take all arrays. `wallCount` walls, at most `reachCount` near a cell, `placeCount` places. Called once. */
export function arrange(
  peopleCount: i32, rowCount: i32, colCount: i32, wallCount: i32, reachCount: i32, placeCount: i32,
  x: f64, y: f64, periodM: f64, number: u64,
): void {
  people = peopleCount; rows = rowCount; cols = colCount; reach = reachCount;
  lowX = x; lowY = y; period = periodM; seed = number;
  const n = <usize>people, c = <usize>rows * <usize>cols;
  place = take(n * 16); velocity = take(n * 16); heading = take(n * 16); pace = take(n * 8);
  way = take(n * 16); wants = take(n * 8); own = take(n * 8); ahead = take(n * 8); radius = take(n * 8);
  target = take(n * 16); curve = take(n * 32); facing = take(n * 16); turn = take(n * 8); look = take(n * 16);
  goal = take(n * 4); slow = take(n * 4);
  present = take(n); avoids = take(n); spotted = take(n); settled = take(n); direct = take(n);
  wanders = take(n); looks = take(n);
  clear = take(c * 8); walls = take(<usize>wallCount * 32); near = take(c * <usize>reach * 4);
  fields = take(<usize>placeCount * c * 16); regions = take(<usize>placeCount * c);
  free = take(c * 256);
  distance = take(c * 8); after = take(c * 4); spare = take(c * 16);
  moved = take(n * 16); others = take(n * <usize>NEAREST * 4); here = take(n * 4);
}

/** Count a step. */
export function tick(): void { steps++; }

/** Where an array lies, by its place in the hosts' lists. */
export function at(kind: i32): usize {
  switch (kind) {
    case 0: return place;
    case 1: return velocity;
    case 2: return way;
    case 3: return wants;
    case 4: return own;
    case 5: return radius;
    case 6: return target;
    case 7: return facing;
    case 8: return look;
    case 9: return goal;
    case 10: return present;
    case 11: return avoids;
    case 12: return spotted;
    case 13: return settled;
    case 14: return wanders;
    case 15: return looks;
    case 16: return clear;
    case 17: return walls;
    case 18: return near;
    case 19: return fields;
    case 20: return regions;
    case 21: return others;
    case 22: return direct;
    case 23: return slow;
    case 24: return distance;
    default: return 0;
  }
}

// One number of an array of f64, i32 or u8.
// @ts-ignore: decorator
@inline export function f(array: usize, k: i32): f64 { return load<f64>(array + (<usize>k << 3)); }
// @ts-ignore: decorator
@inline export function setF(array: usize, k: i32, value: f64): void { store<f64>(array + (<usize>k << 3), value); }
// @ts-ignore: decorator
@inline export function i(array: usize, k: i32): i32 { return load<i32>(array + (<usize>k << 2)); }
// @ts-ignore: decorator
@inline export function setI(array: usize, k: i32, value: i32): void { store<i32>(array + (<usize>k << 2), value); }
// @ts-ignore: decorator
@inline export function is(array: usize, k: i32): bool { return load<u8>(array + <usize>k) != 0; }
// @ts-ignore: decorator
@inline export function setIs(array: usize, k: i32, value: bool): void { store<u8>(array + <usize>k, value ? 1 : 0); }

/** A difference along x in a world that repeats, the shorter way round. */
// @ts-ignore: decorator
@inline export function wrapped(dx: f64): f64 { return dx - period * floor(dx / period + 0.5); }
