// Who is near whom: a grid of cells, and of each person the sixteen nearest.
//
// Sixteen of the nearest, not the first found: a cap on those first found makes people blind to near ones. Nearest to
// where one will be in a second: who walks looks further ahead than back; without it two streams of 1 /m2 keep .1-.7
// m/s instead of .95. Equally near ones by their number.

import {
  AHEAD_M, CELL_M, NEAREST, cols, f, here, i, lowX, lowY, others, people, period, place, rows, setF, setI, take,
  velocity, wrapped,
} from "./memory";

/** Seconds ahead from which the nearest are counted. */
const SOON_S: f64 = 1.0;

let across: i32 = 0; // cells of the grid along x and y
let along: i32 = 0;
let side: f64 = 0; // of a cell along x, metres
let begin: usize = 0; // where each cell's people begin in `listed`
let listed: usize = 0;
let cell: usize = 0; // of each person
const bestLater = memory.data(NEAREST * 8);
const bestSquare = memory.data(NEAREST * 8);
const best = memory.data(NEAREST * 4);

/** Take what the grid needs. */
export function arrangeGrid(): void {
  across = max(period > 0.0 ? <i32>(period / AHEAD_M) : <i32>(<f64>cols * CELL_M / AHEAD_M) + 1, 1);
  side = period > 0.0 ? period / <f64>across : AHEAD_M;
  along = <i32>(<f64>rows * CELL_M / AHEAD_M) + 1;
  begin = take((<usize>across * <usize>along + 1) << 2);
  listed = take(<usize>people << 2);
  cell = take(<usize>people << 2);
}

/** Fill `others` of the first `count` in `here`. */
export function findNearest(count: i32): void {
  const cells = across * along, left = period > 0.0 ? 0.0 : lowX;
  memory.fill(begin, 0, (<usize>cells + 1) << 2);
  for (let k = 0; k < count; k++) {
    const one = i(here, k);
    const column = max(min(<i32>floor((f(place, 2 * one) - left) / side), across - 1), 0);
    const row = max(min(<i32>floor((f(place, 2 * one + 1) - lowY) / AHEAD_M), along - 1), 0);
    setI(cell, one, row * across + column);
    setI(begin, row * across + column, i(begin, row * across + column) + 1);
  }
  for (let k = 1; k <= cells; k++) setI(begin, k, i(begin, k) + i(begin, k - 1));
  for (let k = count - 1; k >= 0; k--) {
    const one = i(here, k), its = i(cell, one), to = i(begin, its) - 1;
    setI(begin, its, to);
    setI(listed, to, one);
  }
  for (let k = 0; k < count; k++) nearestOf(i(here, k));
}

function nearestOf(one: i32): void {
  const x = f(place, 2 * one), y = f(place, 2 * one + 1);
  const soonX = SOON_S * f(velocity, 2 * one), soonY = SOON_S * f(velocity, 2 * one + 1);
  const row = i(cell, one) / across, column = i(cell, one) % across;
  let found = 0;
  for (let r = row - 1; r <= row + 1; r++) {
    if (r < 0 || r >= along) continue;
    for (let step = -1; step <= 1; step++) {
      let c = column + step;
      if (period > 0.0) {
        if (across < 3 && step >= across - 1) continue;
        c = (c + across) % across;
      } else if (c < 0 || c >= across) continue;
      const end = i(begin, r * across + c + 1);
      for (let k = i(begin, r * across + c); k < end; k++) {
        const other = i(listed, k);
        let dx = f(place, 2 * other) - x;
        const dy = f(place, 2 * other + 1) - y;
        if (period > 0.0) dx = wrapped(dx);
        const square = dx * dx + dy * dy;
        if (square > AHEAD_M * AHEAD_M || other == one) continue;
        const lx = dx - soonX, ly = dy - soonY, later = lx * lx + ly * ly;
        if (found == NEAREST) {
          const last = f(bestLater, NEAREST - 1);
          if (later > last || (later == last && other > i(best, NEAREST - 1))) continue;
        } else found++;
        insert(found - 1, bestLater, later, square, other);
      }
    }
  }
  order(found);
  const row16 = others + (<usize>one * <usize>NEAREST << 2);
  for (let k = 0; k < NEAREST; k++) setI(row16, k, k < found ? i(best, k) : -1);
}

/** Put somebody before those who are nearer later, the last of them being at `k`. */
// @ts-ignore: decorator
@inline function insert(k: i32, by: usize, later: f64, square: f64, other: i32): void {
  while (k > 0 && (f(by, k - 1) > later || (f(by, k - 1) == later && i(best, k - 1) > other))) {
    setF(bestLater, k, f(bestLater, k - 1));
    setF(bestSquare, k, f(bestSquare, k - 1));
    setI(best, k, i(best, k - 1));
    k--;
  }
  setF(bestLater, k, later);
  setF(bestSquare, k, square);
  setI(best, k, other);
}

/** Order those found by their distance now. */
function order(found: i32): void {
  for (let end = 1; end < found; end++) {
    const square = f(bestSquare, end), other = i(best, end);
    let k = end;
    while (k > 0 && (f(bestSquare, k - 1) > square || (f(bestSquare, k - 1) == square && i(best, k - 1) > other))) {
      setF(bestSquare, k, f(bestSquare, k - 1));
      setI(best, k, i(best, k - 1));
      k--;
    }
    setF(bestSquare, k, square);
    setI(best, k, other);
  }
}
