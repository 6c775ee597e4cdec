// From goals to ways: who has arrived, a curve of one's own to a spot in sight, the field to one that is not, wandering;
// and bodies that turn to where they walk or look.

import {
  AHEAD_M, GIVEN, NOWHERE, STEP_S, ahead, clear, cols, curve, direct, f, facing, fields, goal, i, is, look, looks, own, people,
  place, present, regions, rows, setF, setI, setIs, settled, slow, spotted, steps, target, turn, velocity, wanders,
  wants, way,
} from "./memory";
import { CURVE, TURN, uniform } from "./dice";
import { RAY_BODY_M, cellOf, freeWay, sees } from "./ground";

/** Who is so near to the own spot has arrived; who was pushed further goes back, metres. */
const THERE_M: f64 = 0.12;
const AWAY_M: f64 = 0.5;
/** One slows down when the spot is nearer than one walks in this time: three times the time in which one comes to a
 *  speed stops without overshoot. */
const SLOWING_S: f64 = 1.5;
/** Who stands in a crowd within the region for so many steps (2 s), and has his spot so near, has arrived too. Without
 *  the second people stop where a region begins and shut the door before it (museum, 3 seeds of 20). */
const STUCK_STEPS: i32 = 40;
const CLOSE_M: f64 = 1.5;
const STILL_M_S: f64 = 0.1;
/** How far one sees a spot to walk straight to it, and how often one looks, in steps. */
const STRAIGHT_M: f64 = 12.0;
const LOOKS_EVERY: i32 = 10;
/** The control point of a curve lies aside of the middle by up to this share of the way; a tenth bends a way by a
 *  twentieth; taste. How strongly one comes back to the curve, 1/m; from where on one walks straight to the spot. */
const ASIDE: f64 = 0.2;
const BACK: f64 = 0.5;
const END_M: f64 = 1.0;
/** Largest angular velocity of a wanderer, rad/s, and how long one is kept; taste. */
const TURN_RAD_S: f64 = 0.4;
const KEPT_S: f64 = 4.0;
/** A wall so near is turned away from, with this angular velocity, as seen so far to both sides. */
const WALL_M: f64 = 1.6;
const WALL_RAD_S: f64 = 1.5;
const GLANCE_RAD: f64 = 0.8;
/** Angular velocity of a body that walks or stands, rad/s: half a turn in a second; below this it stands. */
const TURNS_RAD_S: f64 = 3.2;
const WALKS_M_S: f64 = 0.2;

let turnedX: f64 = 0; // what `rotate` found
let turnedY: f64 = 0;

/** Turn a unit direction by a small angle without a sine: by half its tangent. */
function rotate(x: f64, y: f64, angle: f64): void {
  const half = angle / 2.0, square = half * half;
  const cosine = (1.0 - square) / (1.0 + square), sine = 2.0 * half / (1.0 + square);
  const tx = cosine * x - sine * y, ty = sine * x + cosine * y, length = max(sqrt(tx * tx + ty * ty), 1e-9);
  turnedX = tx / length;
  turnedY = ty / length;
}

/** Let those who reached their spot, or cannot get nearer, stand; and those who were pushed away walk again. */
function arrive(one: i32): void {
  if (i(goal, one) < 0 || !is(present, one) || !is(spotted, one)) {
    setI(slow, one, 0);
    return;
  }
  const x = f(target, 2 * one) - f(place, 2 * one), y = f(target, 2 * one + 1) - f(place, 2 * one + 1);
  const square = x * x + y * y;
  if (square < THERE_M * THERE_M) setIs(settled, one, true);
  if (square > AWAY_M * AWAY_M) setIs(settled, one, false);
  const vx = f(velocity, 2 * one), vy = f(velocity, 2 * one + 1);
  const stuck = !is(settled, one) && vx * vx + vy * vy < STILL_M_S * STILL_M_S && square < CLOSE_M * CLOSE_M;
  setI(slow, one, stuck ? i(slow, one) + 1 : 0);
  if (i(slow, one) > STUCK_STEPS && is(regions + <usize>i(goal, one) * <usize>(rows * cols), cellHere(one))) {
    setF(target, 2 * one, f(place, 2 * one));
    setF(target, 2 * one + 1, f(place, 2 * one + 1));
    setIs(settled, one, true);
  }
}

// @ts-ignore: decorator
@inline function cellHere(one: i32): i32 { return cellOf(f(place, 2 * one), f(place, 2 * one + 1)); }

/** Set way, speed and look-ahead of everybody. */
export function takeWays(): void {
  const dealt = steps % <i32>(KEPT_S / STEP_S + 0.5) == 0 || !anyTurn();
  for (let one = 0; one < people; one++) {
    arrive(one);
    const to = i(goal, one), given = to == GIVEN;
    setF(own, one, f(wants, one));
    setF(ahead, one, AHEAD_M);
    if (given) continue;
    setF(way, 2 * one, 0.0);
    setF(way, 2 * one + 1, 0.0);
    if (to >= 0) {
      if (!is(spotted, one)) alongField(one, to);
      else if (!is(settled, one)) toSpot(one, to);
    } else if (is(wanders, one) && is(present, one)) wander(one, dealt);
  }
}

function toSpot(one: i32, to: i32): void {
  const x = f(target, 2 * one) - f(place, 2 * one), y = f(target, 2 * one + 1) - f(place, 2 * one + 1);
  const far = sqrt(x * x + y * y);
  setF(own, one, min(f(wants, one), max(far / SLOWING_S, 0.2)));
  if ((one + steps) % LOOKS_EVERY == 0) {
    const before = is(direct, one);
    const now = far < STRAIGHT_M
      && sees(f(place, 2 * one), f(place, 2 * one + 1), f(target, 2 * one), f(target, 2 * one + 1), RAY_BODY_M);
    setIs(direct, one, now);
    if (now && !before) beginCurve(one, x, y);
  }
  if (is(direct, one)) {
    alongCurve(one, x, y, far);
    setF(ahead, one, max(min(far, AHEAD_M), 0.5));
    return;
  }
  alongField(one, to);
  if (f(way, 2 * one) == 0.0 && f(way, 2 * one + 1) == 0.0) { // in the region already: the spot is straight ahead
    setF(way, 2 * one, x / max(far, 1e-9));
    setF(way, 2 * one + 1, y / max(far, 1e-9));
  }
}

function alongField(one: i32, to: i32): void {
  const field = fields + ((<usize>to * <usize>(rows * cols) + <usize>cellHere(one)) << 4);
  setF(way, 2 * one, f(field, 0));
  setF(way, 2 * one + 1, f(field, 1));
}

/** Give somebody a curve to the spot: bent to a side of one's own where there is room for it. */
function beginCurve(one: i32, x: f64, y: f64): void {
  const ax = f(place, 2 * one), ay = f(place, 2 * one + 1), bx = f(target, 2 * one), by = f(target, 2 * one + 1);
  const share = (2.0 * uniform(CURVE, steps, one) - 1.0) * ASIDE;
  const mx = (ax + bx) / 2.0, my = (ay + by) / 2.0, cx = mx + share * -y, cy = my + share * x;
  const room = f(clear, cellOf(cx, cy)) >= RAY_BODY_M && sees(ax, ay, cx, cy, RAY_BODY_M)
    && sees(cx, cy, bx, by, RAY_BODY_M);
  setF(curve, 4 * one, ax);
  setF(curve, 4 * one + 1, ay);
  setF(curve, 4 * one + 2, room ? cx : mx);
  setF(curve, 4 * one + 3, room ? cy : my);
}

/** Set the direction on somebody's own curve; x, y and far are what is left. */
function alongCurve(one: i32, x: f64, y: f64, far: f64): void {
  const ax = f(curve, 4 * one), ay = f(curve, 4 * one + 1), cx = f(curve, 4 * one + 2), cy = f(curve, 4 * one + 3);
  const bx = f(target, 2 * one), by = f(target, 2 * one + 1);
  const length = sqrt((bx - ax) * (bx - ax) + (by - ay) * (by - ay));
  let wx = x, wy = y;
  if (far >= END_M && far <= length) {
    const u = max(min(1.0 - far / max(length, 1e-9), 1.0), 0.0), v = 1.0 - u;
    const tx = v * (cx - ax) + u * (bx - cx), ty = v * (cy - ay) + u * (by - cy);
    const size = max(sqrt(tx * tx + ty * ty), 1e-9);
    wx = tx / size + BACK * (v * v * ax + 2.0 * u * v * cx + u * u * bx - f(place, 2 * one));
    wy = ty / size + BACK * (v * v * ay + 2.0 * u * v * cy + u * u * by - f(place, 2 * one + 1));
  }
  const size = max(sqrt(wx * wx + wy * wy), 1e-9);
  setF(way, 2 * one, wx / size);
  setF(way, 2 * one + 1, wy / size);
}

function anyTurn(): bool {
  for (let one = 0; one < people; one++) {
    if (f(turn, one) != 0.0 && is(wanders, one) && is(present, one) && i(goal, one) == NOWHERE) return true;
  }
  return false;
}

/** Set a wanderer's direction: as before, by the own angular velocity, or away from a wall. */
function wander(one: i32, dealt: bool): void {
  const x = f(facing, 2 * one), y = f(facing, 2 * one + 1), cell = cellHere(one);
  if (dealt) {
    const time = <i32>(<f64>steps * STEP_S / KEPT_S);
    setF(turn, one, (2.0 * uniform(TURN, time, one) - 1.0) * TURN_RAD_S);
  }
  let speed = f(turn, one);
  if (freeWay(cell, x, y) < WALL_M) {
    rotate(x, y, GLANCE_RAD);
    const left = freeWay(cell, turnedX, turnedY);
    rotate(x, y, -GLANCE_RAD);
    speed = left >= freeWay(cell, turnedX, turnedY) ? WALL_RAD_S : -WALL_RAD_S;
  }
  rotate(x, y, speed * STEP_S);
  setF(way, 2 * one, turnedX);
  setF(way, 2 * one + 1, turnedY);
}

/** Turn bodies into the direction they walk, or, while they stand, to what they look at. */
export function turnBodies(): void {
  for (let one = 0; one < people; one++) {
    let x = f(velocity, 2 * one), y = f(velocity, 2 * one + 1);
    const stands = f(way, 2 * one) == 0.0 && f(way, 2 * one + 1) == 0.0; // even if pushed, or stepping aside
    if (stands || sqrt(x * x + y * y) <= WALKS_M_S) {
      if (!is(looks, one)) continue;
      x = f(look, 2 * one) - f(place, 2 * one);
      y = f(look, 2 * one + 1) - f(place, 2 * one + 1);
    }
    const length = sqrt(x * x + y * y);
    if (length == 0.0) continue;
    x /= length;
    y /= length;
    const fx = f(facing, 2 * one), fy = f(facing, 2 * one + 1), step = TURNS_RAD_S * STEP_S;
    const cross = fx * y - fy * x, dot = fx * x + fy * y;
    if (dot > 0.0 && abs(cross) < step) {
      turnedX = x;
      turnedY = y;
    } else rotate(fx, fy, cross >= 0.0 ? step : -step);
    setF(facing, 2 * one, turnedX);
    setF(facing, 2 * one + 1, turnedY);
  }
}
