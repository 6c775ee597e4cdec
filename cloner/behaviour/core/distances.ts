// How far each cell is from a place's region, round all obstacles: Dijkstra over sixteen neighbours.
//
// Seeded by the whole region: seeded by a point, ways funnel everybody into a line. A way near a wall costs more.

import { CELL_M, clear, cols, count, distance, f, i, is, regions, rows, setF, setI, take } from "./memory";
import { RAY_BODY_M } from "./ground";

/** A way closer to a wall than this costs up to twice as much: people keep half a metre off; taste. */
const SHY_M: f64 = 0.5;

let heap: usize = 0; // cells, the nearest first
let slot: usize = 0; // where in the heap a cell is, plus one; 0 if it is not
let held: i32 = 0;

/** Take what the search needs. */
export function arrangeSearch(): void {
  const bytes = <usize>count(1) * <usize>count(2) << 2;
  heap = take(bytes);
  slot = take(bytes);
}

// @ts-ignore: decorator
@inline function price(cell: i32): f64 {
  return 1.0 + max(min((SHY_M - f(clear, cell)) / (SHY_M - RAY_BODY_M), 1.0), 0.0);
}

// @ts-ignore: decorator
@inline export function stands(cell: i32): bool { return f(clear, cell) >= RAY_BODY_M; }

/** What it costs to go from a cell to the one so many rows and columns on, metres; negative if one cannot. */
export function cost(cell: i32, r: i32, c: i32): f64 {
  const far = r * r + c * c, row = cell / cols + r, column = cell % cols + c;
  if (far == 0 || far == 4 || far == 8) return -1.0; // itself, two straight on, two aslant
  if (row < 0 || row >= rows || column < 0 || column >= cols) return -1.0;
  const other = row * cols + column;
  if (!stands(other)) return -1.0;
  const length = CELL_M * sqrt(<f64>far);
  if (far > 1 && (f(clear, cell) + f(clear, other)) / 2.0 <= length / 2.0 * 0.3) return -1.0; // cuts a corner
  return length * (price(cell) + price(other)) / 2.0;
}

/** Fill `distance` for a place: metres, infinite where nobody gets there. */
export function findDistances(place: i32): void {
  const cells = rows * cols, region = regions + <usize>place * <usize>cells;
  held = 0;
  for (let cell = 0; cell < cells; cell++) {
    setF(distance, cell, is(region, cell) ? 0.0 : Infinity);
    setI(slot, cell, 0);
    if (is(region, cell)) rise(cell, held++);
  }
  while (held > 0) {
    const cell = nearest();
    if (!stands(cell)) continue;
    const far = f(distance, cell);
    for (let r = -2; r <= 2; r++) {
      for (let c = -2; c <= 2; c++) {
        const more = cost(cell, r, c);
        if (more < 0.0) continue;
        const other = cell + r * cols + c, total = far + more;
        if (total >= f(distance, other)) continue;
        setF(distance, other, total);
        rise(other, i(slot, other) > 0 ? i(slot, other) - 1 : held++);
      }
    }
  }
}

/** Put a cell at a place of the heap, and before all that are farther. */
function rise(cell: i32, from: i32): void {
  const far = f(distance, cell);
  let k = from;
  while (k > 0) {
    const above = i(heap, (k - 1) >> 1);
    if (f(distance, above) <= far) break;
    setI(heap, k, above);
    setI(slot, above, k + 1);
    k = (k - 1) >> 1;
  }
  setI(heap, k, cell);
  setI(slot, cell, k + 1);
}

/** Take the nearest cell from the heap. */
function nearest(): i32 {
  const found = i(heap, 0), last = i(heap, --held), far = f(distance, last);
  setI(slot, found, 0);
  let k = 0;
  while (2 * k + 1 < held) {
    let below = 2 * k + 1;
    if (below + 1 < held && f(distance, i(heap, below + 1)) < f(distance, i(heap, below))) below++;
    const child = i(heap, below);
    if (f(distance, child) >= far) break;
    setI(heap, k, child);
    setI(slot, child, k + 1);
    k = below;
  }
  if (held > 0) {
    setI(heap, k, last);
    setI(slot, last, k + 1);
  }
  return found;
}
