// Who has the last word on a person: guided before reaction before script before innate, for each channel alone.
//
// An order on one channel switches nothing off on another: who is sent to the door still avoids others, until somebody
// with more say orders otherwise on the channel "avoidance".

import { f, people, setF } from "../memory";
import { ends, orders } from "./state";

export const INNATE: i32 = 0, SCRIPT: i32 = 1, REACTION: i32 = 2, GUIDED: i32 = 3;
export const LEVELS: i32 = 4;
/** A place, m/s, an act, a thing, 0 or 1. */
export const GOAL: i32 = 0, SPEED: i32 = 1, POSTURE: i32 = 2, GAZE: i32 = 3, AVOIDANCE: i32 = 4;
export const CHANNELS: i32 = 5;
/** The value of no order. */
export const NONE: f64 = -1.0;

/** The first moment at which an order ends, s. */
export let soonest: f64 = Infinity;
export function setSoonest(end: f64): void { soonest = end; }

// @ts-ignore: decorator
@inline function row(level: i32, channel: i32, one: i32): i32 { return (channel * LEVELS + level) * people + one; }

/** Order somebody something until a time; an earlier order of the same level is forgotten. */
export function give(level: i32, channel: i32, one: i32, what: f64, end: f64 = Infinity): void {
  const at = row(level, channel, one);
  setF(orders, at, what);
  setF(ends, at, end);
  soonest = min(soonest, end);
}

/** Take back what a level ordered somebody on a channel; what is innate stays. */
export function withdraw(level: i32, channel: i32, one: i32): void {
  give(level, channel, one, level == INNATE && channel == AVOIDANCE ? 1.0 : NONE);
}

/** Take back what a script said about what one does at a place, or all but avoidance. */
export function forgetActs(one: i32): void {
  withdraw(SCRIPT, POSTURE, one);
  withdraw(SCRIPT, GAZE, one);
}

export function forgetScript(one: i32): void {
  forgetActs(one);
  withdraw(SCRIPT, GOAL, one);
  withdraw(SCRIPT, SPEED, one);
}

/** What one level orders, -1 for nothing. */
// @ts-ignore: decorator
@inline export function ordered(level: i32, channel: i32, one: i32): f64 { return f(orders, row(level, channel, one)); }

/** What holds: the order of the highest level that gave one. */
export function chosen(channel: i32, one: i32): f64 {
  for (let level = LEVELS - 1; level > INNATE; level--) {
    const what = ordered(level, channel, one);
    if (what != NONE) return what;
  }
  return ordered(INNATE, channel, one);
}

/** Withdraw the orders whose time is over. */
export function endOrders(now: f64): void {
  if (soonest > now) return;
  soonest = Infinity;
  for (let level = SCRIPT; level < LEVELS; level++) {
    for (let channel = 0; channel < CHANNELS; channel++) {
      for (let one = 0; one < people; one++) {
        const end = f(ends, row(level, channel, one));
        if (end <= now) withdraw(level, channel, one);
        else soonest = min(soonest, end);
      }
    }
  }
}
