// The arrays of the core, one after the other in the module's memory.
//
// What a host counts: 0 people, 1 rows and 2 columns of cells, 3 walls, 4 walls a cell's list holds, 5 places; what
// follows is of `minds/state.ts` and `feet/state.ts`. `host.py` has the list of what is lent. Metres, seconds, radians;
// f64 unless told; pairs are x, y.
// n people, c = rows x cols cells, p places.

import { count, lend, take, taken } from "../../webassembly/arrays";
export { at, count, counts, f, i, is, lend, setF, setI, setIs, take } from "../../webassembly/arrays";

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
export let places: i32 = 0;
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
export let distance: usize = 0; // c, to the place whose ways are looked for
export let after: usize = 0; // c, i32: the next cell on the way there
export let spare: usize = 0; // c x 2
export let others: usize = 0; // n x 16, i32: the nearest, then -1
export let here: usize = 0; // n, i32: who is there

/** Take all arrays of bodies. Called once. */
export function arrange(x: f64, y: f64, periodM: f64, number: u64): void {
  people = count(0); rows = count(1); cols = count(2); reach = count(4); places = count(5);
  lowX = x; lowY = y; period = periodM; seed = number;
  const n = <usize>people;
  place = lend(n * 16); velocity = lend(n * 16); way = lend(n * 16); wants = lend(n * 8); own = lend(n * 8);
  radius = lend(n * 8); target = lend(n * 16); facing = lend(n * 16); look = lend(n * 16); goal = lend(n * 4);
  present = lend(n); avoids = lend(n); spotted = lend(n); settled = lend(n); direct = lend(n);
  wanders = lend(n); looks = lend(n); slow = lend(n * 4); others = lend(n * <usize>NEAREST * 4);
  heading = take(n * 16); pace = take(n * 8); ahead = take(n * 8); curve = take(n * 32); turn = take(n * 8);
  moved = take(n * 16); here = take(n * 4);
}

/** Take all arrays of the ground, which stays as it is. Called last: all that changes lies before it. */
export function arrangeGround(): void {
  const c = <usize>rows * <usize>cols, p = <usize>places;
  ground = taken();
  clear = lend(c * 8); distance = lend(c * 8); near = lend(c * <usize>reach * 4); walls = lend(<usize>count(3) * 32);
  fields = lend(p * c * 16); regions = lend(p * c);
  free = take(c * 256); after = take(c * 4); spare = take(c * 16);
}

/** Where the ground's arrays begin. */
export let ground: usize = 0;

/** Count a step, or go on from one. */
export function tick(): void { steps++; }
export function setSteps(count: i32): void { steps = count; }

/** A difference along x in a world that repeats, the shorter way round. */
// @ts-ignore: decorator
@inline export function wrapped(dx: f64): f64 { return dx - period * floor(dx / period + 0.5); }
