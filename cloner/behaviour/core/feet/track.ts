// What a body did in the last seconds, ten times a second: feet follow it.

import { f, facing, i, is, people, place, present, setF, setI } from "../memory";
import { emotion, posture } from "../minds/state";
import {
  actClip, acts, countFrame, frameAct, frameHeading, frameWalk, frameX, frameZ, frames, kept, lastSeen, walkClip,
} from "./state";

const RATE_HZ: f64 = 10.0;
const IDLE: i32 = 1;

export let trackX: f64 = 0; // what `locate` found
export let trackZ: f64 = 0;

/** Keep what everybody does now. */
export function keepFrame(): i32 {
  const frame = countFrame(), first = (frame % kept) * people;
  for (let one = 0; one < people; one++) {
    const act = i(posture, one);
    setF(frameX, first + one, f(place, 2 * one));
    setF(frameZ, first + one, -f(place, 2 * one + 1)); // y of the plan is -z
    setF(frameHeading, first + one, Math.atan2(f(facing, 2 * one), -f(facing, 2 * one + 1)));
    setI(frameAct, first + one, act < acts ? i(actClip, act) : IDLE);
    setI(frameWalk, first + one, i(walkClip, i(emotion, one)));
    if (is(present, one)) setI(lastSeen, one, frame);
  }
  return frame;
}

/** The number in a frame's arrays of somebody, in the nearest frame that is known of him. */
// @ts-ignore: decorator
@inline function slot(one: i32, frame: i32): i32 {
  const known = max(min(frame, i(lastSeen, one)), max(frames - kept, 0));
  return (known % kept) * people + one;
}

/** Find where somebody's body is at a time, s. */
export function locate(one: i32, when: f64): void {
  const at = max(when * RATE_HZ, 0.0), frame = <i32>at, part = at - <f64>frame;
  const before = slot(one, frame), after = slot(one, frame + 1);
  trackX = f(frameX, before) + (f(frameX, after) - f(frameX, before)) * part;
  trackZ = f(frameZ, before) + (f(frameZ, after) - f(frameZ, before)) * part;
}

/** The slot of the last frame that is not later. */
// @ts-ignore: decorator
@inline function slotAt(one: i32, when: f64): i32 { return slot(one, <i32>max(when * RATE_HZ + 1e-8, 0.0)); }

export function headingAt(one: i32, when: f64): f64 { return f(frameHeading, slotAt(one, when)); }
export function actAt(one: i32, when: f64): i32 { return i(frameAct, slotAt(one, when)); }
export function walkAt(one: i32, when: f64): i32 { return i(frameWalk, slotAt(one, when)); }
