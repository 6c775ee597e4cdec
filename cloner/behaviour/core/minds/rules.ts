// Events and reactions: what lets a rule act, and what its actions order on which level.

import { f, i, is, people, places, present, setF, setI, setIs, settled } from "../memory";
import { attract } from "./attraction";
import { seesAnybody } from "./perceiving";
import { keepClear } from "./repulsion";
import { split } from "./splitting";
import { AVOIDANCE, CHANNELS, GAZE, GOAL, POSTURE, REACTION, SCRIPT, SPEED, forgetActs, give, withdraw } from "./orders";
import { AWAKENS, HAPPENS, SLEEPS, tell } from "./told";
import {
  DONE, WALKING, acted, actionRows, actionSeconds, atTimes, awake, band, bandHome, bands, emotion, events,
  follows, followsUntil, happened, happens, knows, leader, leaving, longest, phase, ruleRows, ruleSeconds, rules, seenEmotion,
  seenGoal, seenThings, speed, they, things, value, vigour, visitCount, visited, visits, whom,
} from "./state";

/** How much faster than their own walk people run. */
const RUN: f64 = 1.35;
/** How strong at least an emotion is that one comes to feel. */
const FELT: f64 = 0.8;

// Columns of `ruleRows`, and kinds of a rule.
const KIND: i32 = 0, WHO: i32 = 1, WHOSE: i32 = 2, WHAT: i32 = 3, AWAKE: i32 = 4, FIRST: i32 = 5, COUNT: i32 = 6,
  FIRED: i32 = 7, RULE: i32 = 8;
const AT: i32 = 0, EVENT: i32 = 1, SEES_THING: i32 = 2, SEES_GROUP: i32 = 3, SEES_FEELING: i32 = 4, IS: i32 = 5,
  REACHES: i32 = 6;
// Whom something is for.
const EVERYBODY: i32 = 0, THEY: i32 = 1, NAMED: i32 = 2;
// Verbs.
const BECOME: i32 = 0, GO: i32 = 1, RUNS: i32 = 2, LEAVE: i32 = 3, GATHER: i32 = 4, FOLLOW: i32 = 5, LOOK: i32 = 6,
  ACT: i32 = 7, FREE: i32 = 8, IGNORE: i32 = 9, HEED: i32 = 10, AWAKEN: i32 = 11, SLEEP: i32 = 12, CLEAR: i32 = 13,
  PART: i32 = 14, HAPPEN: i32 = 15;
const ACTION: i32 = 5; // columns of `actionRows`

/** Let the rules of the clock act. */
export function timed(step: i32, now: f64): void {
  for (let rule = 0; rule < rules; rule++) {
    const row = RULE * rule;
    if (i(ruleRows, row + KIND) != AT || i(ruleRows, row + FIRED) != 0 || now < f(ruleSeconds, rule)) continue;
    setI(ruleRows, row + FIRED, 1);
    act(rule, SCRIPT, step, now);
  }
}

/** Let each rule act for the bands that meet its condition for the first time. */
export function react(step: i32, now: f64): void {
  for (let k = 0; k < events; k++) {
    setIs(happened, k, is(happens, k));
    setIs(happens, k, false);
  }
  for (let rule = 0; rule < rules; rule++) {
    const kind = i(ruleRows, RULE * rule + KIND);
    if (kind == AT) continue;
    if (kind == EVENT) {
      if (is(happened, i(ruleRows, RULE * rule + WHAT))) act(rule, REACTION, step, now);
      continue;
    }
    if (kind == SEES_GROUP || kind == SEES_FEELING) find(kind, i(ruleRows, RULE * rule + WHAT));
    let any = false;
    const count = bands();
    for (let one = 0; one < count; one++) {
      const meets = !is(acted, one * rules + rule) && means(rule, one) && met(rule, kind, one);
      setIs(they, one, meets);
      if (meets) setIs(acted, one * rules + rule, true);
      any = any || meets;
    }
    if (any) act(rule, REACTION, step, now);
  }
}

function act(rule: i32, level: i32, step: i32, now: f64): void {
  const first = i(ruleRows, RULE * rule + FIRST), count = i(ruleRows, RULE * rule + COUNT);
  for (let k = first; k < first + count; k++) {
    const row = ACTION * k;
    order(level, i(actionRows, row), i(actionRows, row + 1), i(actionRows, row + 2), i(actionRows, row + 3),
      i(actionRows, row + 4), f(actionSeconds, k), step, now);
  }
}

/** Whether a rule is for a band. */
function means(rule: i32, one: i32): bool {
  const named = i(ruleRows, RULE * rule + WHO) == NAMED;
  return !named || i(bandHome, one) == i(ruleRows, RULE * rule + WHOSE);
}

/** Mark in `whom` who is there of a home, or feels something. */
function find(kind: i32, what: i32): void {
  for (let one = 0; one < people; one++) {
    const fits = kind == SEES_GROUP ? i(bandHome, i(band, one)) == what : i(seenEmotion, one) == what;
    setIs(whom, one, is(present, one) && fits);
  }
}

/** Whether a band meets a condition, through its leader. */
function met(rule: i32, kind: i32, one: i32): bool {
  const eyes = i(leader, one), what = i(ruleRows, RULE * rule + WHAT);
  if (!is(present, eyes)) return false;
  if (kind == SEES_THING) {
    return is(seenThings, one * things + what) && (is(awake, what) || i(ruleRows, RULE * rule + AWAKE) == 0);
  }
  if (kind == IS) return i(seenEmotion, eyes) == what;
  if (kind == REACHES) return is(settled, eyes) && i(seenGoal, eyes) == what;
  return seesAnybody(eyes, whom);
}

/** Order what an action says, on a level. */
export function order(
  level: i32, verb: i32, who: i32, whose: i32, what: i32, many: i32, seconds: f64, step: i32, now: f64,
): void {
  const end = seconds > 0.0 ? now + seconds : Infinity;
  if (verb == AWAKEN || verb == SLEEP) {
    setIs(awake, whose, verb == AWAKEN);
    tell(now, verb == AWAKEN ? AWAKENS : SLEEPS, whose);
  } else if (verb == HAPPEN) {
    if (what < events) setIs(happens, what, true);
    tell(now, HAPPENS, what);
  } else if (verb == CLEAR) {
    keepClear(what, end);
  } else if (verb == PART) {
    for (let one = 0, count = bands(); one < count; one++) {
      if (meantBand(who, whose, one)) split(one, many, step, now);
    }
  } else {
    for (let one = 0; one < people; one++) {
      if (!is(present, one) || !meantBand(who, whose, i(band, one))) continue;
      changeMind(level, verb, i(band, one), what, end);
      obey(level, verb, one, what, end);
    }
  }
}

/** Whether an action is for a band. */
function meantBand(who: i32, whose: i32, one: i32): bool {
  return who == EVERYBODY || (who == THEY ? is(they, one) : i(bandHome, one) == whose);
}

/** Change the mind of a band whose people are ordered to go somewhere, or to follow. */
function changeMind(level: i32, verb: i32, one: i32, what: i32, end: f64): void {
  if (verb == FOLLOW && i(bandHome, one) != what) {
    setI(follows, one, what);
    setIs(atTimes, one, false);
    setF(followsUntil, one, end);
  }
  if (verb != GO && verb != RUNS && verb != LEAVE) return;
  setIs(knows, one * places + what, true);
  if (level != SCRIPT) return;
  setI(visitCount, one, 1); // a script goes on in place of what the band wanted to visit
  setI(visits, one * longest, what);
  setI(follows, one, -1);
}

/** Order somebody something. */
function obey(level: i32, verb: i32, one: i32, what: i32, end: f64): void {
  if (verb == BECOME) {
    setI(emotion, one, what);
    setF(value, one, max(f(value, one), FELT));
  } else if (verb == GO || verb == RUNS || verb == LEAVE) {
    if (level == SCRIPT) {
      withdraw(SCRIPT, GOAL, one);
      forgetActs(one);
      setI(visited, one, -1);
      setI(phase, one, DONE);
    } else give(level, GOAL, one, what);
    setIs(leaving, one, verb == LEAVE);
    if (verb == RUNS) give(level, SPEED, one, RUN * f(speed, i(emotion, one)) * f(vigour, one));
  } else if (verb == GATHER) attract(level, one, what, end);
  else if (verb == FOLLOW) setI(phase, one, WALKING);
  else if (verb == LOOK) give(level, GAZE, one, what, end);
  else if (verb == ACT) give(level, POSTURE, one, what, end);
  else if (verb == IGNORE || verb == HEED) give(level, AVOIDANCE, one, verb == HEED ? 1.0 : 0.0, end);
  else if (verb == FREE) {
    for (let lower = REACTION; lower <= level; lower++) {
      for (let channel = 0; channel < CHANNELS; channel++) withdraw(lower, channel, one);
    }
  }
}
