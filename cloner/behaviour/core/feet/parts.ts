// Where a body is at the end of a footing: in equal parts, the point of the sole that touches keeps its place in each.
// The same as `crowd/staged/footing.py` and `crowd/web/footing.js`, which show people in between.

import { lookOf, scale, touches, clipCount, WALK_FRAMES } from "./state";
import { f, i } from "../memory";

/** Frames of a walk: from where on the left and the right foot carry, both together, and when one stands flat below. */
export const LEFT: i32 = 3, RIGHT: i32 = 27, ALONE: i32 = 2, SHARED: i32 = 21, MIDDLE: i32 = 11;
/** A foot is lifted or put down in so many parts; a turn has so many in all. */
export const LIFT_PARTS: i32 = 8, TURN_PARTS: i32 = 28;
const TOUCH: i32 = 6;

export let endX: f64 = 0; // what `findEnd` found
export let endZ: f64 = 0;

function smooth(share: f64): f64 {
  const s = max(min(share, 1.0), 0.0);
  return s * s * (3.0 - 2.0 * s);
}

// @ts-ignore: decorator
@inline function up(k: i32): f64 { return smooth(<f64>k / <f64>LIFT_PARTS); }

/** One number of a clone's touches. */
// @ts-ignore: decorator
@inline export function touch(look: i32, clip: i32, frame: i32, column: i32): f64 {
  return load<f32>(touches + (<usize>(((look * clipCount + clip) * WALK_FRAMES + frame) * TOUCH + column) << 2));
}

/** Find where a footing leads that is no standing; `before` is the walk it goes over from, or -1. */
export function findEnd(
  one: i32, clip: i32, before: i32, first: i32, last: i32, from: f64, to: f64, x: f64, z: f64, heading: f64, turn: f64,
): void {
  const look = i(lookOf, one), size = f(scale, one), turns = first == last, base = first < RIGHT ? LEFT : RIGHT;
  const begins = !turns && from == 0.0, ends = !turns && !begins && to == 0.0, steps = last - first;
  const count = turns ? TURN_PARTS : steps + (begins || ends ? LIFT_PARTS : 0);
  const low = max(first, base + ALONE), high = min(last, base + SHARED);
  let sumX = 0.0, sumZ = 0.0, share = 0.0, angle = 0.0, frame = 0;
  for (let k = 0; k <= count; k++) {
    const shareBefore = share, angleBefore = angle, frameBefore = frame;
    let turned = 0.0;
    if (turns) {
      frame = first;
      share = min(up(k), up(count - k));
      turned = smooth(<f64>(k - LIFT_PARTS) / <f64>(TURN_PARTS - 2 * LIFT_PARTS));
    } else {
      frame = first + min(begins ? max(k - LIFT_PARTS, 0) : k, steps);
      turned = smooth(<f64>(frame - low) / <f64>(high - low));
      if (begins) share = to * up(min(k, LIFT_PARTS));
      else if (ends) share = from * up(min(count - k, LIFT_PARTS));
      else share = before >= 0 ? turned : from + (to - from) * turned;
    }
    angle = heading + turn * turned;
    if (k == 0) continue;
    const at = frameBefore % WALK_FRAMES, on = frame > frameBefore ? 2 : 0;
    const x0 = mixed(look, clip, before, at, 0, shareBefore) * size, z0 = mixed(look, clip, before, at, 1, shareBefore) * size;
    const x1 = mixed(look, clip, before, at, on, share) * size, z1 = mixed(look, clip, before, at, on + 1, share) * size;
    const c0 = Math.cos(angleBefore), s0 = Math.sin(angleBefore), c1 = Math.cos(angle), s1 = Math.sin(angle);
    sumX += c0 * x0 + s0 * z0 - (c1 * x1 + s1 * z1);
    sumZ += c0 * z0 - s0 * x0 - (c1 * z1 - s1 * x1);
  }
  endX = x + sumX;
  endZ = z + sumZ;
}

/** A touch of a walk blended with the idle's, or with that of the walk before. */
function mixed(look: i32, clip: i32, before: i32, frame: i32, column: i32, share: f64): f64 {
  const rest = before >= 0 ? touch(look, before, frame, column) : touch(look, clip, frame, 4 + (column & 1));
  return rest + (touch(look, clip, frame, column) - rest) * share;
}
