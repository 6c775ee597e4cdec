// Execute what was selected: orders become goals with spots, speeds, postures and gazes, then feet move.

import {
  NOWHERE, STEP_S, avoids, direct, f, goal, i, is, look, looks, people, place, present, setF, setI, setIs, settled,
  slow, target, velocity, wanders, wants, way,
} from "../memory";
import { IDLE, uniform } from "../dice";
import { findWays } from "../fields";
import { step as walk } from "../walkers";
import { giveSpots } from "./adaptability";
import { naturalSpeed } from "./flocking";
import { keepGuests } from "./guests";
import { has, setKey, sort } from "./members";
import { AVOIDANCE, GAZE, GOAL, POSTURE, SPEED, chosen } from "./orders";
import {
  WANDERS, band, emotion, fresh, gaze, idle, idleActs, idleFirst, leaving, led, posture, some, thingPlace,
} from "./state";

/** An idle act is kept so long, s. */
const IDLE_S: f64 = 8.0;
/** Acts of all scenarios, as numbers, and from which squares of speeds on one walks and runs, m2/s2. */
const WALK: i32 = 1, RUN: i32 = 2;
const WALKS: f64 = 0.04;
const RUNS: f64 = 4.0;

/** Execute the orders for one step. */
export function execute(step: i32): void {
  takeGoals();
  for (let one = 0; one < people; one++) {
    const speed = chosen(SPEED, one), thing = <i32>chosen(GAZE, one);
    setIs(avoids, one, chosen(AVOIDANCE, one) != 0.0);
    setF(wants, one, speed >= 0.0 ? speed : naturalSpeed(one));
    setIs(wanders, one, has(i(band, one), WANDERS));
    setI(gaze, one, thing);
    setIs(looks, one, thing >= 0);
    if (thing < 0) continue;
    setF(look, 2 * one, f(thingPlace, 2 * thing));
    setF(look, 2 * one + 1, f(thingPlace, 2 * thing + 1));
  }
  walk();
  keepGuests();
  const anew = step % <i32>(IDLE_S / STEP_S + 0.5) == 1;
  for (let one = 0; one < people; one++) {
    if (anew) chooseIdle(one, <i32>(<f64>step * STEP_S / IDLE_S));
    pose(one);
    if (is(leaving, one) && is(settled, one)) setIs(present, one, false);
  }
}

/** Give those whose goal is new a spot there, band after band and place after place. */
function takeGoals(): void {
  let many = 0;
  for (let one = 0; one < people; one++) {
    const to = <i32>chosen(GOAL, one);
    if (!is(present, one) || to == i(goal, one)) continue;
    setI(goal, one, to);
    if (to >= 0) setI(fresh, many++, one);
    else if (to == NOWHERE) {
      setIs(settled, one, true);
      setF(target, 2 * one, f(place, 2 * one));
      setF(target, 2 * one + 1, f(place, 2 * one + 1));
    }
  }
  for (let k = 0; k < many; k++) setKey(k, i(goal, i(fresh, k)));
  sort(fresh, many);
  for (let k = 0; k < many; k++) setKey(k, i(band, i(fresh, k)));
  sort(fresh, many);
  for (let first = 0; first < many; ) {
    const own = i(band, i(fresh, first)), to = i(goal, i(fresh, first));
    let count = 0;
    for (; first < many && i(band, i(fresh, first)) == own && i(goal, i(fresh, first)) == to; first++) {
      const one = i(fresh, first);
      setI(some, count++, one);
      setIs(settled, one, false);
      setIs(direct, one, false);
      setI(slow, one, 0);
    }
    if (!is(led, to)) findWays(to);
    setIs(led, to, true);
    giveSpots(count, to);
  }
}

/** Choose what somebody does: an order, else walking or running, else an idle act of the emotion's. */
function pose(one: i32): void {
  const x = f(velocity, 2 * one), y = f(velocity, 2 * one + 1), square = x * x + y * y;
  const leads = f(way, 2 * one) != 0.0 || f(way, 2 * one + 1) != 0.0; // who steps aside goes on with what he does
  const ordered = <i32>chosen(POSTURE, one);
  if (leads && square > WALKS) setI(posture, one, square > RUNS ? RUN : WALK);
  else setI(posture, one, ordered >= 0 ? ordered : i(idle, one));
}

function chooseIdle(one: i32, period: i32): void {
  const first = i(idleFirst, i(emotion, one)), count = i(idleFirst, i(emotion, one) + 1) - first;
  setI(idle, one, i(idleActs, first + <i32>(uniform(IDLE, period, one) * <f64>count)));
}
