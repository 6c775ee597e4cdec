// Everybody's feet: what is known of clones' walks, the last seconds of what bodies did, and each person's last footing.
//
// Frame: x and z of a page, metres; headings from z to x, radians. n people, l looks (clones and their sizes aside).

import { count, lend, people, take } from "../memory";

export const WALK_FRAMES: i32 = 48;
export const COLUMNS: i32 = 13;
/** Columns of a footing; `crowd/staged/footing.py` tells what they mean. */
export const FROM: i32 = 0, UNTIL: i32 = 1, CLIP: i32 = 2, OTHER: i32 = 3, FIRST: i32 = 4, LAST: i32 = 5, SHARE: i32 = 6,
  SHARE_LAST: i32 = 7, X: i32 = 8, Z: i32 = 9, HEADING: i32 = 10, HEADING_LAST: i32 = 11, FEELS: i32 = 12;

export let clipCount: i32 = 0;
export let kept: i32 = 0; // frames of the past, ten a second
export let acts: i32 = 0;
export let footingsHeld: i32 = 0;

export let touches: usize = 0; // l x clips x 48 x 6, f32: see `crowd/staged/footing.py`
export let clips: usize = 0; // l x clips x 2, f32: frames and seconds
export let lookOf: usize = 0; // n, i32
export let scale: usize = 0; // n
export let startPhase: usize = 0; // n, of the idle at first, 0..1
export let actClip: usize = 0; // i32: the clip of each act while standing
export let walkClip: usize = 0; // i32: the walk of each emotion
export let footings: usize = 0; // f32, rows of 1 + COLUMNS: who, and the footing
export let footNumbers: usize = 0; // i32: how many rows of `footings` are new, the clip of running or -1

export let frames: i32 = 0; // how many there were
export let frameX: usize = 0; // kept x n, as all of frames
export let frameZ: usize = 0;
export let frameHeading: usize = 0;
export let frameAct: usize = 0; // i32: a clip
export let frameWalk: usize = 0; // i32: a clip
export let there: usize = 0; // n, u8
export let lastSeen: usize = 0; // n, i32: the last frame in which one was there

export let clock: usize = 0; // n, s: until when one has gone
export let bodyX: usize = 0; // n: the body, or, while one stands, where the idle has it
export let bodyZ: usize = 0;
export let heading: usize = 0;
export let share: usize = 0; // of a whole step
export let still: usize = 0; // phase of the idle
export let idleFrame: usize = 0;
export let clip: usize = 0; // i32
export let onLeft: usize = 0; // u8
export let row: usize = 0; // n x COLUMNS
export let hasRow: usize = 0; // u8
export let toldUntil: usize = 0; // n: the row's end as it was told

/** Take all arrays. */
export function arrangeFeet(): void {
  const looks = <usize>count(19), n = looks > 0 ? <usize>people : 0;
  clipCount = count(20); kept = count(21); acts = count(22);
  footingsHeld = looks > 0 ? 32 * people + 1024 : 0;
  const k = <usize>clipCount, past = n * <usize>kept;
  touches = lend(looks * k * 1152); clips = lend(looks * k * 8); lookOf = lend(n * 4); scale = lend(n * 8);
  startPhase = lend(n * 8); actClip = lend(<usize>acts * 4); walkClip = lend(<usize>count(11) * 4);
  footings = lend(<usize>footingsHeld * 56); footNumbers = lend(8); lastSeen = lend(n * 4); clock = lend(n * 8);
  frameX = take(past * 8); frameZ = take(past * 8); frameHeading = take(past * 8);
  frameAct = take(past * 4); frameWalk = take(past * 4); there = take(n);
  bodyX = take(n * 8); bodyZ = take(n * 8); heading = take(n * 8); share = take(n * 8);
  still = take(n * 8); idleFrame = take(n * 8); clip = take(n * 4); onLeft = take(n); row = take(n * 104);
  hasRow = take(n); toldUntil = take(n * 8);
}

/** Count a frame, or go on from one. */
export function countFrame(): i32 { return frames++; }
export function setFrames(count: i32): void { frames = count; }
