// The script of each person's visits: walk there, wait for a turn, act, be done, go on; or to known places at random.
//
// A band's goals are shared by its members; at a place that holds so many, as many act at a time; if no intentions are
// given, the band's knowledge generates them at random. A place that is not known cannot be gone to.

import { f, goal, i, is, people, places, present, setF, setI, setIs, settled, target } from "../memory";
import { VISIT, uniform } from "../dice";
import { allThere } from "./flocking";
import { isFollowing } from "./following";
import { has } from "./members";
import { GAZE, GOAL, POSTURE, SCRIPT, forgetActs, give, ordered } from "./orders";
import {
  ACTING, AGAIN, CALLED, DONE, FLOCKING, OUTSIDE, WAITING, WALKING, WANDERS, band, bands, knows, leader, longest, phase,
  placeAct, placeCounter, placeHolds, placeLook, placeSeconds, they, until, visitCount, visited, visits,
} from "./state";

/** Carry on the visits of everybody whose band follows nobody. */
export function visit(now: f64): void {
  const own = they; // bands that go their own ways
  for (let one = 0, count = bands(); one < count; one++) setIs(own, one, !isFollowing(one, now));
  for (let one = 0; one < people; one++) {
    if (!is(present, one) || !is(own, i(band, one)) || isThere(one)) continue;
    if (i(phase, one) != WALKING && i(phase, one) != DONE) letGo(one); // called away: begins anew later
  }
  for (let one = 0; one < people; one++) {
    if (!is(present, one) || !is(own, i(band, one)) || i(phase, one) == DONE) continue;
    if (is(settled, one) && isThere(one) && i(goal, one) >= 0) carryOn(one, now);
  }
  for (let one = 0, count = bands(); one < count; one++) {
    const stays = has(one, OUTSIDE) || (has(one, WANDERS) && i(visitCount, one) == 0);
    if (stays || (has(one, FLOCKING) && !allThere(one))) setIs(own, one, false);
  }
  for (let one = 0; one < people; one++) {
    if (is(present, one) && is(own, i(band, one)) && i(phase, one) == DONE) goOn(one);
  }
}

/** Whether somebody goes, or is, where the script sent him. */
function isThere(one: i32): bool { return <f64>i(goal, one) == ordered(SCRIPT, GOAL, one); }

/** Take the next step of somebody who stands where the script sent him. */
function carryOn(one: i32, now: f64): void {
  const place = i(goal, one), holds = i(placeHolds, place);
  if (i(phase, one) == WALKING) {
    if (i(placeAct, place) < 0) setI(phase, one, DONE);
    else if (holds == 0) begin(one, place, now);
    else {
      setI(phase, one, WAITING);
      setF(until, one, now);
    }
  } else if (i(phase, one) == WAITING) {
    if (users(place) >= holds || !isNext(one, place)) return;
    setI(phase, one, CALLED);
    if (holds > 1) return;
    setF(target, 2 * one, f(placeCounter, 2 * place)); // served at the point itself
    setF(target, 2 * one + 1, f(placeCounter, 2 * place + 1));
    setIs(settled, one, false);
  } else if (i(phase, one) == CALLED) begin(one, place, now);
  else if (i(phase, one) == ACTING && now >= f(until, one)) {
    letGo(one);
    setI(phase, one, DONE);
  }
}

/** How many are served at a place, or were called to be. */
function users(place: i32): i32 {
  let found = 0;
  for (let one = 0; one < people; one++) {
    const served = i(phase, one) == ACTING || i(phase, one) == CALLED;
    if (served && is(present, one) && ordered(SCRIPT, GOAL, one) == <f64>place) found++;
  }
  return found;
}

/** Whether nobody has waited longer. */
function isNext(one: i32, place: i32): bool {
  for (let other = 0; other < people; other++) {
    if (i(phase, other) != WAITING || i(goal, other) != place || !is(present, other)) continue;
    if (f(until, other) < f(until, one) || (f(until, other) == f(until, one) && other < one)) return false;
  }
  return true;
}

function begin(one: i32, place: i32, now: f64): void {
  setI(phase, one, ACTING);
  setF(until, one, now + f(placeSeconds, place));
  give(SCRIPT, POSTURE, one, i(placeAct, place));
  if (i(placeLook, place) >= 0) give(SCRIPT, GAZE, one, i(placeLook, place));
}

/** End what somebody does at a place. */
function letGo(one: i32): void {
  forgetActs(one);
  setI(phase, one, WALKING);
}

/** Send somebody who is done to the next goal. */
function goOn(one: i32): void {
  const own = i(band, one), next = nextGoal(one, own);
  if (next < 0) return;
  give(SCRIPT, GOAL, one, next);
  setI(phase, one, WALKING);
}

/** Count one visit more and return its place; -1 if there is none, or it is not known. */
function nextGoal(one: i32, own: i32): i32 {
  let index = i(visited, one) + 1;
  if (i(visitCount, own) == 0) return byChance(one, own, index);
  if (index >= i(visitCount, own)) {
    if (!has(own, AGAIN)) return -1;
    index = 0;
  }
  const place = i(visits, own * longest + index);
  if (!is(knows, own * places + place)) return -1;
  setI(visited, one, index);
  return place;
}

/** A known place that is not where one is; members of a flocking band have the same chance. */
function byChance(one: i32, own: i32, index: i32): i32 {
  let known = 0;
  for (let k = 0; k < places; k++) {
    if (is(knows, own * places + k) && k != i(goal, one)) known++;
  }
  if (known == 0) return -1;
  const chooser = has(own, FLOCKING) ? i(leader, own) : one;
  let left = <i32>(uniform(VISIT, index, chooser) * <f64>known);
  setI(visited, one, index);
  let k = 0;
  while (!is(knows, own * places + k) || k == i(goal, one) || left-- > 0) k++;
  return k;
}
