// Skin that cloth meets: a tangent plane under every vertex, that of the nearest points of skin, blended.

import { Cells } from "./cells";
import {
  before, f, i, is, near, place, planeEarly, planeLate, planeNormal, setF, setI, setIs, skinEarly, skinLate, skinNormal,
  skins, take, vertices,
} from "./memory";
import { move } from "./vectors";

/** Points of skin that are blended into a plane. */
const NEAREST: i32 = 4;
/** Side of a cell, metres: skin's triangles are 1 to 2 cm wide. */
const CELL_M: f64 = 0.03;
const best = memory.data(NEAREST * 4);
const bestSquare = memory.data(NEAREST * 8);

let cells: Cells = changetype<Cells>(0);
let skinNow: usize = 0; // m x 3

export function arrangeSkin(): void {
  skinNow = take(<usize>skins * 24);
  cells = Cells.of(skins);
}

/** Find the planes under all vertices that have skin within `reach` metres, as it is after a share of the frame.
 *
 *  As it is then, not in the middle of the frame: a foot swings 13 cm a frame, and cloth before it would be behind it. */
export function findPlanes(share: f64, reach: f64): void {
  if (skins == 0) return;
  for (let k = 0; k < 3 * skins; k++) setF(skinNow, k, f(skinEarly, k) + share * (f(skinLate, k) - f(skinEarly, k)));
  cells.sort(skinNow, skins, CELL_M);
  for (let k = 0; k < vertices; k++) {
    const found = nearest(f(place, 3 * k), f(place, 3 * k + 1), f(place, 3 * k + 2), reach);
    setIs(near, k, found > 0);
    if (found > 0) blend(3 * k, alike(found));
  }
}

/** Fill `best` with the nearest points of skin; how many there are, none if the nearest is out of reach. */
function nearest(x: f64, y: f64, z: f64, reach: f64): i32 {
  const column = cells.column(x), row = cells.row(y), layer = cells.layer(z), side = cells.side;
  const rings = <i32>(reach / side) + 1;
  let found = 0;
  for (let ring = 0; ring <= rings; ring++) {
    const least = <f64>(ring - 1) * side; // what lies in a ring is at least so far off
    if (ring > 0 && (found == 0 ? least > reach : found == NEAREST && f(bestSquare, NEAREST - 1) <= least * least)) break;
    for (let l = max(layer - ring, 0); l <= min(layer + ring, cells.deep - 1); l++) {
      for (let r = max(row - ring, 0); r <= min(row + ring, cells.high - 1); r++) {
        const whole = abs(l - layer) == ring || abs(r - row) == ring;
        for (let c = column - ring; c <= column + ring; c += whole ? 1 : 2 * ring) {
          if (c >= 0 && c < cells.wide) found = takeNearer(cells.index(c, r, l), x, y, z, found);
        }
      }
    }
  }
  return found > 0 && f(bestSquare, 0) < reach * reach ? found : 0;
}

/** Put a cell's points into `best`, of which `found` are filled; how many are then. */
// @ts-ignore: decorator
@inline function takeNearer(cell: i32, x: f64, y: f64, z: f64, found: i32): i32 {
  const end = i(cells.begin, cell + 1);
  for (let k = i(cells.begin, cell); k < end; k++) {
    const one = i(cells.listed, k);
    const dx = f(skinNow, 3 * one) - x, dy = f(skinNow, 3 * one + 1) - y, dz = f(skinNow, 3 * one + 2) - z;
    const square = dx * dx + dy * dy + dz * dz;
    if (found < NEAREST) found++;
    else if (square >= f(bestSquare, NEAREST - 1)) continue;
    let to = found - 1;
    while (to > 0 && f(bestSquare, to - 1) > square) {
      setF(bestSquare, to, f(bestSquare, to - 1));
      setI(best, to, i(best, to - 1));
      to--;
    }
    setF(bestSquare, to, square);
    setI(best, to, one);
  }
  return found;
}

/** Keep those of the nearest that face as the very nearest does: between arm and chest, or two thighs, a mean of both
 *  sides faces anywhere. How many are left. */
function alike(found: i32): i32 {
  const first = 3 * i(best, 0);
  let kept = 0;
  for (let k = 0; k < found; k++) {
    const one = 3 * i(best, k);
    let cosine = 0.0;
    for (let axis = 0; axis < 3; axis++) cosine += f(skinNormal, one + axis) * f(skinNormal, first + axis);
    if (cosine <= 0.0) continue;
    setI(best, kept, i(best, k));
    setF(bestSquare, kept++, f(bestSquare, k));
  }
  return kept;
}

function blend(to: i32, found: i32): void {
  let total = 0.0, square = 0.0;
  for (let k = 0; k < found; k++) total += 1.0 / (f(bestSquare, k) + 1e-6);
  for (let axis = 0; axis < 3; axis++) {
    let early = 0.0, late = 0.0, normal = 0.0;
    for (let k = 0; k < found; k++) {
      const weight = 1.0 / (f(bestSquare, k) + 1e-6) / total, from = 3 * i(best, k) + axis;
      early += weight * f(skinEarly, from);
      late += weight * f(skinLate, from);
      normal += weight * f(skinNormal, from);
    }
    setF(planeEarly, to + axis, early);
    setF(planeLate, to + axis, late);
    setF(planeNormal, to + axis, normal);
    square += normal * normal;
  }
  const length = max(sqrt(square), 1e-12);
  for (let axis = 0; axis < 3; axis++) setF(planeNormal, to + axis, f(planeNormal, to + axis) / length);
}

/** Push vertices `clear` metres out of the skin as it is after a `share` of the frame; what slides is held by as much as
 *  it was pushed, times the friction. `step` is the share of the frame since `before`. */
export function keepOut(clear: f64, friction: f64, share: f64, step: f64): void {
  for (let k = 0; k < vertices; k++) {
    if (!is(near, k)) continue;
    const a = 3 * k, nx = f(planeNormal, a), ny = f(planeNormal, a + 1), nz = f(planeNormal, a + 2);
    const ex = f(planeLate, a) - f(planeEarly, a), ey = f(planeLate, a + 1) - f(planeEarly, a + 1);
    const ez = f(planeLate, a + 2) - f(planeEarly, a + 2);
    const deep = clear - (f(place, a) - f(planeEarly, a) - share * ex) * nx
      - (f(place, a + 1) - f(planeEarly, a + 1) - share * ey) * ny - (f(place, a + 2) - f(planeEarly, a + 2) - share * ez) * nz;
    if (deep <= 0.0) continue;
    let x = f(place, a) - f(before, a) - step * ex, y = f(place, a + 1) - f(before, a + 1) - step * ey;
    let z = f(place, a + 2) - f(before, a + 2) - step * ez;
    const along = x * nx + y * ny + z * nz;
    x -= along * nx; y -= along * ny; z -= along * nz;
    const far = max(sqrt(x * x + y * y + z * z), 1e-12);
    move(k, deep, nx, ny, nz);
    move(k, -min(1.0, friction * deep / far), x, y, z);
  }
}
