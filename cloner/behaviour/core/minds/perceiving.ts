// What each band perceives, through its leader's eyes, before anybody acts: behaviours read this, never new orders.
//
// Perception is the leader's; memory keeps what he perceived, as much as it holds; what is perceived becomes known.

import { f, facing, goal, i, is, people, place, places, present, setF, setI, setIs } from "../memory";
import { sees } from "../ground";
import {
  bandHome, bands, emotion, homeMemory, knows, leader, memoryCount, memoryName, memoryTime, placeMiddle, remembers,
  seenEmotion, seenGoal, seenThings, thingPlace, things,
} from "./state";

/** How far a leader sees a person or a thing; taste: across a room. */
const SIGHT_M: f64 = 15.0;
/** Nearer than this one notices what is behind one. */
const FEELS_M: f64 = 1.5;
/** A thing is seen although its own plinth stands there. */
const PLINTH_M: f64 = 1.0;
const LEARNS_EVERY: i32 = 20; // steps: a second
const LOOKED_AT: i32 = 8; // the nearest of many are looked at

const nearest = memory.data(LOOKED_AT * 4);
const squares = memory.data(LOOKED_AT * 8);

/** Let every band see, remember and learn. */
export function perceive(step: i32, now: f64): void {
  memory.copy(seenGoal, goal, <usize>people << 2);
  memory.copy(seenEmotion, emotion, <usize>people << 2);
  const count = bands();
  for (let one = 0; one < count; one++) {
    const eyes = i(leader, one);
    for (let k = 0; k < things; k++) {
      const seen = is(present, eyes) && seesPlace(eyes, f(thingPlace, 2 * k), f(thingPlace, 2 * k + 1));
      setIs(seenThings, one * things + k, seen);
      if (seen && !remembered(one, k)) remember(one, k, now);
    }
  }
  if (step % LEARNS_EVERY == 0) learn(count, now);
}

/** Whether somebody sees a place: before one, near enough, no wall between. */
export function seesPlace(one: i32, x: f64, y: f64): bool {
  const px = f(place, 2 * one), py = f(place, 2 * one + 1), dx = x - px, dy = y - py, far = sqrt(dx * dx + dy * dy);
  const before = dx * f(facing, 2 * one) + dy * f(facing, 2 * one + 1) > 0.0 || far < FEELS_M;
  if (!before || far >= SIGHT_M) return false;
  const share = max(far - PLINTH_M, 0.0) / max(far, 1e-9);
  return sees(px, py, px + share * dx, py + share * dy, 0.0);
}

/** Whether somebody sees one of those who are in a list of flags; the nearest eight are looked at. */
export function seesAnybody(eyes: i32, flags: usize): bool {
  let found = 0;
  for (let one = 0; one < people; one++) {
    if (!is(flags, one) || one == eyes) continue;
    const dx = f(place, 2 * one) - f(place, 2 * eyes), dy = f(place, 2 * one + 1) - f(place, 2 * eyes + 1);
    const square = dx * dx + dy * dy;
    if (square > SIGHT_M * SIGHT_M || (found == LOOKED_AT && square >= f(squares, LOOKED_AT - 1))) continue;
    let k = found < LOOKED_AT ? found++ : LOOKED_AT - 1;
    for (; k > 0 && f(squares, k - 1) > square; k--) {
      setF(squares, k, f(squares, k - 1));
      setI(nearest, k, i(nearest, k - 1));
    }
    setF(squares, k, square);
    setI(nearest, k, one);
  }
  for (let k = 0; k < found; k++) {
    const one = i(nearest, k);
    if (seesPlace(eyes, f(place, 2 * one), f(place, 2 * one + 1))) return true;
  }
  return false;
}

function remembered(one: i32, name: i32): bool {
  for (let k = 0; k < i(memoryCount, one); k++) {
    if (i(memoryName, one * remembers + k) == name) return true;
  }
  return false;
}

/** Keep what was perceived; the oldest is forgotten when there is no room. */
function remember(one: i32, name: i32, now: f64): void {
  const room = min(i(homeMemory, i(bandHome, one)), remembers), first = one * remembers;
  if (room == 0) return;
  let count = i(memoryCount, one);
  if (count == room) {
    for (let k = 1; k < count; k++) {
      setI(memoryName, first + k - 1, i(memoryName, first + k));
      setF(memoryTime, first + k - 1, f(memoryTime, first + k));
    }
    count--;
  }
  setI(memoryName, first + count, name);
  setF(memoryTime, first + count, now);
  setI(memoryCount, one, count + 1);
}

/** Let bands know the places their leaders see. */
function learn(count: i32, now: f64): void {
  for (let k = 0; k < places; k++) {
    for (let one = 0; one < count; one++) {
      if (is(knows, one * places + k)) continue;
      if (!seesPlace(i(leader, one), f(placeMiddle, 2 * k), f(placeMiddle, 2 * k + 1))) continue;
      setIs(knows, one * places + k, true);
      remember(one, things + k, now);
    }
  }
}
