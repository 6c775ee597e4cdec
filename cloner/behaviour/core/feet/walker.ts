// One person's way as footings: steps whose length and pace follow the track, turns, and acts between.
//
// A body gets where its track is by steps. So it runs ahead or behind by decimetres, and stays where it is while the track
// creeps by less than a step.

import { f, i, is, setF, setI, setIs } from "../memory";
import { LEFT, LIFT_PARTS, MIDDLE, RIGHT, endX, endZ, findEnd, touch } from "./parts";
import {
  CLIP, COLUMNS, FEELS, FIRST, FROM, HEADING, HEADING_LAST, LAST, OTHER, SHARE, SHARE_LAST, UNTIL, WALK_FRAMES, X, Z,
  bodyX, bodyZ, clip, clipCount, clips, clock, footNumbers, footings, footingsHeld, hasRow, heading, idleFrame, lookOf,
  onLeft, row, scale, share, startPhase, still, toldUntil,
} from "./state";
import { actAt, headingAt, locate, trackX, trackZ, walkAt } from "./track";

const IDLE: i32 = 1;
/** What people do who stand begins and ends in this time, s; taste. */
const BLEND_S: f64 = 0.4;
/** Who stands begins to walk when the track is so far away, m: the shortest two half steps make .3 m. */
const START_M: f64 = 0.25;
/** Where the track rests one stays if it is no farther than this, m: nobody turns about for half a step. */
const STAY_M: f64 = 0.45;
/** How far ahead the track is looked at for pace, and beyond a step's end for its direction, s; taste. */
const AHEAD_S: f64 = 0.9;
const BEYOND_S: f64 = 0.35;
/** Steps are not shorter than this share of the style's, nor is its pace slower or faster than these: a slower walk is
 *  half in length and half in pace (walkers, section 4: both by the square root). */
const SHORTEST: f64 = 0.5;
/** Steps of this share and more are whole ones: a whole walk is smooth between its frames, a blended one shows frame
 *  after frame. From .994 on ways that turn by .5 rad/s would count, whose feet twist between frames. */
const WHOLE: f64 = 0.998;
const SLOWEST: f64 = 0.6;
const FASTEST: f64 = 1.7;
/** Who ends walking takes no slower a half step than this; taste. */
const ENDS: f64 = 0.8;
/** So much faster than their walk people begin to run, and walk again; taste. */
const RUNS: f64 = 1.4;
const WALKS: f64 = 1.2;
/** Walkers turn by this at most, rad/s, so that they keep up with ways that turn by 1.5; who is more than the second off
 *  stops and turns first. */
const TURNS_RAD_S: f64 = 2.0;
const ABOUT_RAD: f64 = 1.6;
/** Who begins to walk turns first on the spot when off by more than this, rad: what a step turns. */
const BEGIN_RAD: f64 = 0.75;
/** Who stands turns when off by more than the first, rad, by the second at most in one turn of so many seconds. */
const OFF_RAD: f64 = 0.15;
const TURN_RAD: f64 = 1.7;
const TURN_S: f64 = 0.45;
/** Who stands looks again after this time, s: the track's own. */
const WAIT_S: f64 = 0.1;
/** The track has come to rest if it goes no farther than this in the second after the next half, m. */
const REST_M: f64 = 0.15;

/** Let somebody stand at a place from a time on, as who was not there before. */
export function enter(one: i32, when: f64): void {
  locate(one, when);
  setF(clock, one, when);
  setF(bodyX, one, trackX);
  setF(bodyZ, one, trackZ);
  setF(heading, one, headingAt(one, when));
  setF(share, one, 0.0);
  setI(clip, one, IDLE);
  setIs(onLeft, one, true);
  setIs(hasRow, one, false);
}

/** Add footings until a time; the track is one that reaches `SEEN_S` (`feet/watching.ts`) beyond, or all there is. */
export function goOn(one: i32, until: f64): void {
  if (!is(hasRow, one) && f(clock, one) < until) stand(one, IDLE, WAIT_S);
  while (f(clock, one) < until) {
    if (f(share, one) != 0.0) walk(one);
    else wait(one);
  }
}

/** Tell the last footing if it is new, or longer than it was told. */
export function tellRow(one: i32): void {
  if (!is(hasRow, one) || column(one, UNTIL) == f(toldUntil, one)) return;
  const count = i(footNumbers, 0);
  if (count >= footingsHeld) return; // it is told with the next
  const at = footings + <usize>(count * (1 + COLUMNS)) * 4;
  store<f32>(at, <f32>one);
  for (let k = 0; k < COLUMNS; k++) store<f32>(at + (<usize>(k + 1) << 2), <f32>column(one, k));
  setI(footNumbers, 0, count + 1);
  setF(toldUntil, one, column(one, UNTIL));
}

/** Let the last footing last until a time at least. */
export function lengthen(one: i32, until: f64): void {
  if (is(hasRow, one)) setColumn(one, UNTIL, max(column(one, UNTIL), until));
}

// @ts-ignore: decorator
@inline function column(one: i32, k: i32): f64 { return f(row, one * COLUMNS + k); }
// @ts-ignore: decorator
@inline function setColumn(one: i32, k: i32, value: f64): void { setF(row, one * COLUMNS + k, value); }
// @ts-ignore: decorator
@inline function length(x: f64, z: f64): f64 { return sqrt(x * x + z * z); }

/** An angle in -pi..pi. */
function wrapped(angle: f64): f64 { return angle - 2.0 * Math.PI * floor(angle / (2.0 * Math.PI) + 0.5); }

/** How far the track goes between two times, m. */
function goes(one: i32, from: f64, to: f64): f64 {
  locate(one, from);
  const x = trackX, z = trackZ;
  locate(one, to);
  return length(trackX - x, trackZ - z);
}

/** How far the track is from the body at a time, m. */
function apart(one: i32, when: f64): f64 {
  locate(one, when);
  return length(trackX - f(bodyX, one), trackZ - f(bodyZ, one));
}

/** The heading towards where the track is at a time. */
function towards(one: i32, when: f64): f64 {
  locate(one, when);
  return Math.atan2(trackX - f(bodyX, one), trackZ - f(bodyZ, one));
}

/** Go on from standing: begin to walk, turn, or do what is to be done. */
function wait(one: i32): void {
  const now = f(clock, one);
  const moves = goes(one, now, now + AHEAD_S) > REST_M;
  const near = min(apart(one, now + AHEAD_S / 2.0), apart(one, now + AHEAD_S));
  if (near > (moves ? START_M : STAY_M)) {
    const turn = wrapped(towards(one, now + AHEAD_S) - f(heading, one));
    if (i(clip, one) != IDLE) stand(one, IDLE, BLEND_S);
    else if (abs(turn) > BEGIN_RAD) turnAbout(one, turn);
    else begin(one, gait(one, walkAt(one, now)));
    return;
  }
  const turn = wrapped(headingAt(one, now + TURN_S) - f(heading, one));
  if (abs(turn) <= OFF_RAD) stand(one, actAt(one, now + BLEND_S), WAIT_S);
  else if (i(clip, one) != IDLE) stand(one, IDLE, BLEND_S);
  else turnAbout(one, turn);
}

/** Stand and act for some time; the same goes on in the same footing. */
function stand(one: i32, act: i32, least: f64): void {
  const now = f(clock, one), before = i(clip, one), feels = <f64>walkAt(one, now), over = is(hasRow, one);
  if (over && before == act && column(one, LAST) < 0.0 && column(one, FEELS) == feels) {
    setF(clock, one, now + least);
    setColumn(one, UNTIL, now + least);
    return;
  }
  const blends = over && before != act, seconds = blends ? max(least, BLEND_S) : least;
  const last = frameNow(one, before); // keeps the idle's phase too
  const first = !over ? f(startPhase, one) : act == IDLE ? f(still, one) : 0.0;
  beginRow(one, now, seconds, act);
  setColumn(one, OTHER, blends ? before : -1.0);
  setColumn(one, FIRST, first);
  setColumn(one, LAST, -1.0 - last);
  putBody(one, before, SHARE);
  putBody(one, act, X);
  setColumn(one, HEADING, f(heading, one));
  setColumn(one, HEADING_LAST, f(heading, one));
  setColumn(one, FEELS, feels);
  setF(clock, one, now + seconds);
  setI(clip, one, act);
}

/** Tell the last footing, and make it another. */
function beginRow(one: i32, now: f64, seconds: f64, clip: i32): void {
  tellRow(one);
  setIs(hasRow, one, true);
  setF(toldUntil, one, -1.0);
  setColumn(one, FROM, now);
  setColumn(one, UNTIL, now + seconds);
  setColumn(one, CLIP, clip);
}

/** Put into two columns where the body is in a clip that is done standing here; its feet are those of the idle. */
function putBody(one: i32, act: i32, at: i32): void {
  const look = i(lookOf, one), x = touch(look, act, 0, 0) * f(scale, one), z = touch(look, act, 0, 1) * f(scale, one);
  const c = Math.cos(f(heading, one)), s = Math.sin(f(heading, one));
  setColumn(one, at, f(bodyX, one) - (c * x + s * z));
  setColumn(one, at + 1, f(bodyZ, one) - (c * z - s * x));
}

// @ts-ignore: decorator
@inline function clipNumber(one: i32, clip: i32, k: i32): f64 {
  return load<f32>(clips + (<usize>((i(lookOf, one) * clipCount + clip) * 2 + k) << 2));
}

/** The frame that is shown now of what is done standing; keeps the idle's phase. */
function frameNow(one: i32, act: i32): f64 {
  if (!is(hasRow, one) || column(one, LAST) >= 0.0) return 0.0;
  const count = clipNumber(one, act, 0);
  const turns = column(one, FIRST) + (f(clock, one) - column(one, FROM)) / clipNumber(one, act, 1);
  const phase = turns - floor(turns);
  if (act == IDLE) setF(still, one, phase);
  return min(floor(phase * count), count - 1.0);
}

/** Turn on the spot, on the foot of the side to which it goes. */
function turnAbout(one: i32, turn: f64): void {
  const frame = (turn > 0.0 ? LEFT : RIGHT) + MIDDLE;
  go(one, walkAt(one, f(clock, one)), frame, frame, TURN_S, 0.0, 0.0, max(min(turn, TURN_RAD), -TURN_RAD), -1);
}

/** Make the half step that begins to walk. */
function begin(one: i32, walk: i32): void {
  const base = is(onLeft, one) ? LEFT : RIGHT, steps = RIGHT - LEFT - MIDDLE;
  findPace(one, walk);
  const seconds = secondsOf(one, walk, LIFT_PARTS + steps, paceRate), turn = stepTurn(one, steps, walk, paceRate);
  go(one, walk, base + MIDDLE, base + RIGHT - LEFT, seconds, 0.0, paceShare, turn, -1);
}

/** Make another step, or the half step that ends walking, whichever ends nearer to where the track rests. */
function walk(one: i32): void {
  const base = is(onLeft, one) ? LEFT : RIGHT, now = f(clock, one), own = i(clip, one), before = f(share, one);
  const walk = gait(one, walkAt(one, now));
  let stops = abs(wrapped(way(one, now + AHEAD_S) - f(heading, one))) > ABOUT_RAD;
  findPace(one, walk);
  const to = walk != own ? 1.0 : paceShare, rate = paceRate;
  const turn = stepTurn(one, RIGHT - LEFT, own, rate);
  if (!stops && goes(one, now + AHEAD_S, now + AHEAD_S + 1.0) < REST_M) {
    const restX = trackX, restZ = trackZ, other = is(onLeft, one) ? RIGHT : LEFT;
    halfEnd(one, base, base + MIDDLE, before, 0.0, 0.0);
    const halt = length(endX - restX, endZ - restZ);
    halfEnd(one, base, base + RIGHT - LEFT, before, SHORTEST, turn);
    const stepX = endX - f(bodyX, one), stepZ = endZ - f(bodyZ, one);
    halfEnd(one, other, other + MIDDLE, SHORTEST, 0.0, 0.0);
    stops = halt <= length(stepX + endX - restX, stepZ + endZ - restZ);
  }
  if (stops) {
    const seconds = secondsOf(one, own, MIDDLE + LIFT_PARTS, max(rate, ENDS));
    go(one, own, base, base + MIDDLE, seconds, before, 0.0, 0.0, -1);
    return;
  }
  const over = walk != own && before == 1.0; // one goes over to another walk in whole steps alone
  const seconds = secondsOf(one, own, RIGHT - LEFT, rate);
  go(one, over ? walk : own, base, base + RIGHT - LEFT, seconds, before, to, turn, over ? own : -1);
}

function halfEnd(one: i32, first: i32, last: i32, from: f64, to: f64, turn: f64): void {
  findEnd(one, i(clip, one), -1, first, last, from, to, f(bodyX, one), f(bodyZ, one), f(heading, one), turn);
}

/** The walk, or the run for whom it is too slow; who runs goes on until the walk is fast enough. */
function gait(one: i32, walk: i32): i32 {
  const run = i(footNumbers, 1), now = f(clock, one);
  if (run < 0) return walk;
  const faster = goes(one, now, now + AHEAD_S) / AHEAD_S / (speedOf(one, walk) * f(scale, one));
  return faster > (i(clip, one) == run ? WALKS : RUNS) ? run : walk;
}

/** Add a footing of walking or turning, going over from the walk `before` if any, and be at its end. */
function go(
  one: i32, walk: i32, first: i32, last: i32, seconds: f64, from: f64, to: f64, turn: f64, before: i32,
): void {
  const now = f(clock, one), x = f(bodyX, one), z = f(bodyZ, one), angle = f(heading, one);
  if (column(one, LAST) < 0.0) setF(idleFrame, one, frameNow(one, IDLE));
  beginRow(one, now, seconds, walk);
  setColumn(one, OTHER, before < 0 ? f(idleFrame, one) : -1.0 - <f64>before);
  setColumn(one, FIRST, first);
  setColumn(one, LAST, last);
  setColumn(one, SHARE, from);
  setColumn(one, SHARE_LAST, to);
  setColumn(one, X, x);
  setColumn(one, Z, z);
  setColumn(one, HEADING, angle);
  setColumn(one, HEADING_LAST, angle + turn);
  setColumn(one, FEELS, walkAt(one, now));
  // as whoever shows it, who has it in 32 bits
  const shown = <f64><f32>angle, turned = <f64><f32>(angle + turn) - shown;
  findEnd(one, walk, before, first, last, <f64><f32>from, <f64><f32>to, <f64><f32>x, <f64><f32>z, shown, turned);
  setF(bodyX, one, endX);
  setF(bodyZ, one, endZ);
  setF(clock, one, now + seconds);
  setF(heading, one, wrapped(angle + turn));
  setF(share, one, to);
  setI(clip, one, to != 0.0 ? walk : IDLE);
  if (last > first && last - first != MIDDLE) setIs(onLeft, one, !is(onLeft, one));
}

let paceShare: f64 = 0; // what `findPace` found
let paceRate: f64 = 0;

/** Find how long steps are, as a share of the walk's, and how fast they follow one another. */
function findPace(one: i32, walk: i32): void {
  const needed = apart(one, f(clock, one) + AHEAD_S) / AHEAD_S;
  const ratio = needed / (speedOf(one, walk) * f(scale, one));
  paceShare = max(min(sqrt(ratio), 1.0), SHORTEST);
  if (paceShare > WHOLE) paceShare = 1.0;
  paceRate = max(min(ratio / paceShare, FASTEST), SLOWEST);
}

/** The walk's own speed, m/s. */
function speedOf(one: i32, walk: i32): f64 {
  let total = 0.0;
  for (let k = 0; k < WALK_FRAMES; k++) total += touch(i(lookOf, one), walk, k, 1) - touch(i(lookOf, one), walk, k, 3);
  return total / clipNumber(one, walk, 1);
}

function secondsOf(one: i32, walk: i32, frames: i32, rate: f64): f64 {
  return clipNumber(one, walk, 1) * <f64>frames / <f64>WALK_FRAMES / rate;
}

/** The heading towards where the track is at a time; one's own when that is here. */
function way(one: i32, when: f64): f64 {
  return apart(one, when) > START_M / 2.0 ? towards(one, when) : f(heading, one);
}

/** By how much a step turns, rad. */
function stepTurn(one: i32, frames: i32, walk: i32, rate: f64): f64 {
  const seconds = secondsOf(one, walk, frames, rate), most = TURNS_RAD_S * seconds;
  const turn = wrapped(way(one, f(clock, one) + seconds + BEYOND_S) - f(heading, one));
  return max(min(turn, most), -most);
}
