// Gravity and air.

import { f, faces, free, i, place, setF, thrust, triangles, velocity, vertices } from "./memory";
import { away } from "./vectors";

const GRAVITY_M_S2: f64 = 9.81;
/** Density of air at 20 degrees, and the drag of a plate across the wind (textbook: 1.2 to 2). */
const AIR_KG_M3: f64 = 1.2;
const DRAG: f64 = 1.3;

/** Fill `thrust` with what pulls and blows at every vertex, m/s2: air acts on what meets a triangle straight on.
 *  `caught` is the share of it that the fabric catches. */
export function blow(windX: f64, windY: f64, windZ: f64, caught: f64): void {
  for (let k = 0; k < vertices; k++) {
    setF(thrust, 3 * k, 0.0);
    setF(thrust, 3 * k + 1, -GRAVITY_M_S2);
    setF(thrust, 3 * k + 2, 0.0);
  }
  for (let k = 0; k < triangles; k++) {
    const a = i(faces, 3 * k), b = i(faces, 3 * k + 1), c = i(faces, 3 * k + 2);
    const px = away(place, a, b, 0), py = away(place, a, b, 1), pz = away(place, a, b, 2);
    const qx = away(place, a, c, 0), qy = away(place, a, c, 1), qz = away(place, a, c, 2);
    const x = py * qz - pz * qy, y = pz * qx - px * qz, z = px * qy - py * qx;
    const length = max(sqrt(x * x + y * y + z * z), 1e-12);
    const against = ((windX - mean(a, b, c, 0)) * x + (windY - mean(a, b, c, 1)) * y + (windZ - mean(a, b, c, 2)) * z) / length;
    const size = 0.5 * AIR_KG_M3 * DRAG * caught * against * abs(against) / 6.0; // half the area, to each of three
    push(a, size, x, y, z);
    push(b, size, x, y, z);
    push(c, size, x, y, z);
  }
}

// @ts-ignore: decorator
@inline function mean(a: i32, b: i32, c: i32, axis: i32): f64 {
  return (f(velocity, 3 * a + axis) + f(velocity, 3 * b + axis) + f(velocity, 3 * c + axis)) / 3.0;
}

function push(vertex: i32, size: f64, x: f64, y: f64, z: f64): void {
  const light = size * f(free, vertex), at = 3 * vertex;
  setF(thrust, at, f(thrust, at) + light * x);
  setF(thrust, at + 1, f(thrust, at + 1) + light * y);
  setF(thrust, at + 2, f(thrust, at + 2) + light * z);
}
