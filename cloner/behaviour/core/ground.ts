// The raster: cells, directions, free distances, sight, and walls that push bodies off.

import {
  AHEAD_M, CELL_M, DIRECTIONS, clear, cols, f, free, i, lowX, lowY, near, radius, reach, rows, setF, walls,
} from "./memory";

/** Rays are cast by a slim disc: shoulders turn in a door. */
export const RAY_BODY_M: f64 = 0.15;

/** The number of a place's cell, clipped to the raster. */
// @ts-ignore: decorator
@inline export function cellOf(x: f64, y: f64): i32 {
  const column = <i32>((x - lowX) / CELL_M), row = <i32>((y - lowY) / CELL_M);
  return max(min(row, rows - 1), 0) * cols + max(min(column, cols - 1), 0);
}

/** Which of the 64 a direction is: the turn by |x| + |y| = 1 instead of by the circle. */
// @ts-ignore: decorator
@inline export function bin(x: f64, y: f64): i32 {
  const share = y / max(abs(x) + abs(y), 1e-12);
  const turn = x >= 0.0 ? (y >= 0.0 ? share : 4.0 + share) : 2.0 - share;
  return <i32>(turn * 16.0 + 0.5) & (DIRECTIONS - 1);
}

/** How far a body gets from a cell in a direction, at most `AHEAD_M`. */
// @ts-ignore: decorator
@inline export function freeWay(cell: i32, x: f64, y: f64): f64 {
  return <f64>load<f32>(free + ((<usize>cell * 64 + <usize>bin(x, y)) << 2));
}

/** Find the free distances of all cells in all directions; from beside a wall, away from it. */
export function castRays(): void {
  for (let k = 0; k < DIRECTIONS; k++) {
    const turn = <f64>k * (4.0 / <f64>DIRECTIONS);
    const share = turn <= 1.0 ? turn : turn <= 3.0 ? 2.0 - turn : turn - 4.0;
    let x = 1.0 - abs(share);
    if (turn > 1.0 && turn < 3.0) x = -x;
    const length = sqrt(x * x + share * share);
    const dx = x / length / CELL_M, dy = share / length / CELL_M;
    for (let row = 0; row < rows; row++) {
      for (let column = 0; column < cols; column++) {
        const cell = row * cols + column, room = f(clear, cell);
        if (room <= 0.0) continue;
        const start = min(room, RAY_BODY_M);
        let far = 0.0, now = start;
        while (true) {
          const trial = far + max(now - RAY_BODY_M, CELL_M / 2.0);
          const r = <i32>floor(<f64>row + 0.5 + trial * dy), c = <i32>floor(<f64>column + 0.5 + trial * dx);
          now = f(clear, max(min(r, rows - 1), 0) * cols + max(min(c, cols - 1), 0));
          if (now < start) break;
          far = min(trial, AHEAD_M);
          if (trial >= AHEAD_M) break;
        }
        store<f32>(free + ((<usize>cell * 64 + <usize>k) << 2), <f32>far);
      }
    }
  }
}

/** Whether a body gets straight from one place to another. */
export function sees(ax: f64, ay: f64, bx: f64, by: f64, body: f64): bool {
  const x = bx - ax, y = by - ay, length = max(sqrt(x * x + y * y), CELL_M);
  let share = CELL_M / length;
  for (let k = 2; share < 1.0; k++) {
    if (f(clear, cellOf(ax + share * x, ay + share * y)) < body) return false;
    share = <f64>k * CELL_M / length;
  }
  return true;
}

/** Move the body at a place off the walls it touches, wall after wall. */
export function offWalls(one: i32, place: usize): void {
  const body = f(radius, one);
  let px = f(place, 2 * one), py = f(place, 2 * one + 1);
  const list = near + (<usize>cellOf(px, py) * <usize>reach << 2);
  for (let k = 0; k < reach; k++) {
    const wall = i(list, k);
    if (wall < 0) break;
    const ax = f(walls, 4 * wall), ay = f(walls, 4 * wall + 1);
    const ux = f(walls, 4 * wall + 2) - ax, uy = f(walls, 4 * wall + 3) - ay;
    let dx = px - ax, dy = py - ay;
    const share = max(min((dx * ux + dy * uy) / (ux * ux + uy * uy), 1.0), 0.0);
    dx -= share * ux;
    dy -= share * uy;
    const away = sqrt(dx * dx + dy * dy);
    const over = max(body - away, 0.0) / max(away, 1e-6);
    px += over * dx;
    py += over * dy;
  }
  setF(place, 2 * one, px);
  setF(place, 2 * one + 1, py);
}
