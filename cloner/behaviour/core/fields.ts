// The directions to a place, of the distances over the raster: from each cell as far along the shortest way as is seen.

import { CELL_M, after, cols, distance, f, fields, i, lowX, lowY, rows, setF, setI, spare } from "./memory";
import { cost, findDistances, stands } from "./distances";
import { sees } from "./ground";

const BODY_M: f64 = 0.2;
/** How far along the shortest way one looks while it stays in sight, in steps. */
const LOOK = memory.data<i32>([1, 2, 3, 4, 6, 8, 12, 16, 24]);
const LOOKS: i32 = 9;

/** Find the cell after each one on its shortest way, itself where there is none: sixteen neighbours. */
function findNext(): void {
  for (let row = 0; row < rows; row++) {
    for (let column = 0; column < cols; column++) {
      const cell = row * cols + column;
      let best = Infinity, to = cell;
      if (stands(cell) && f(distance, cell) > 0.0) {
        for (let r = -2; r <= 2; r++) {
          for (let c = -2; c <= 2; c++) {
            const more = cost(cell, r, c);
            if (more < 0.0) continue;
            const other = cell + r * cols + c, total = f(distance, other) + more;
            if (total < best) {
              best = total;
              to = other;
            }
          }
        }
      }
      setI(after, cell, to);
    }
  }
}

// @ts-ignore: decorator
@inline function middleX(cell: i32): f64 { return lowX + (<f64>(cell % cols) + 0.5) * CELL_M; }
// @ts-ignore: decorator
@inline function middleY(cell: i32): f64 { return lowY + (<f64>(cell / cols) + 0.5) * CELL_M; }

/** Find the directions to a place, whose `regions` the host has filled. */
export function findWays(place: i32): void {
  const count = rows * cols, field = fields + ((<usize>place * <usize>count) << 4);
  findDistances(place);
  findNext();
  for (let cell = 0; cell < count; cell++) {
    setF(field, 2 * cell, 0.0);
    setF(field, 2 * cell + 1, 0.0);
    const far = f(distance, cell);
    if (!(far > 0.0 && far < Infinity)) continue;
    const x = middleX(cell), y = middleY(cell);
    let at = cell, aim = cell, step = 0;
    for (let look = 0; look < LOOKS; look++) {
      for (const until = i(LOOK, look); step < until; step++) at = i(after, at);
      if (look > 0 && !sees(x, y, middleX(at), middleY(at), BODY_M)) break;
      aim = at;
    }
    const dx = middleX(aim) - x, dy = middleY(aim) - y, length = max(sqrt(dx * dx + dy * dy), 1e-9);
    setF(field, 2 * cell, dx / length);
    setF(field, 2 * cell + 1, dy / length);
  }
  for (let round = 0; round < 2; round++) carryOut(field);
}

/** Give cells at walls, where nobody can stand but a body may be pushed, the direction of a neighbour. */
function carryOut(field: usize): void {
  memory.copy(spare, field, <usize>(rows * cols) << 4);
  for (let row = 0; row < rows; row++) {
    for (let column = 0; column < cols; column++) {
      const cell = row * cols + column;
      if (f(spare, 2 * cell) != 0.0 || f(spare, 2 * cell + 1) != 0.0 || f(distance, cell) == 0.0) continue;
      if (column + 1 < cols && take(field, cell, cell + 1)) continue;
      if (row + 1 < rows && take(field, cell, cell + cols)) continue;
      if (column > 0 && take(field, cell, cell - 1)) continue;
      if (row > 0) take(field, cell, cell - cols);
    }
  }
}

/** Take a neighbour's direction, if it has one. */
function take(field: usize, cell: i32, other: i32): bool {
  const x = f(spare, 2 * other), y = f(spare, 2 * other + 1);
  setF(field, 2 * cell, x);
  setF(field, 2 * cell + 1, y);
  return x != 0.0 || y != 0.0;
}
