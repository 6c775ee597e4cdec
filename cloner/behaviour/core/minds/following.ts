// Group behaviour 2, following: a band takes another home's goals, for ever or for times chosen at random.

import { f, i, is, people, places, present, setI, setIs } from "../memory";
import { FOLLOWING, uniform } from "../dice";
import { GOAL, SCRIPT, give, withdraw } from "./orders";
import { DONE, atTimes, band, bandHome, bands, follows, followsUntil, knows, leader, phase, seenGoal } from "./state";

/** Periods of following at times, s; taste. */
const SHORTEST_S: f64 = 10.0;
const LONGEST_S: f64 = 40.0;

/** Give the members of each following band the goal that the followed home's leader had. */
export function follow(now: f64): void {
  for (let one = 0, count = bands(); one < count; one++) {
    if (i(follows, one) < 0) continue;
    const over = now >= f(followsUntil, one);
    const goal = over || !isFollowing(one, now) ? -1 : leadersGoal(i(follows, one));
    if (over) setI(follows, one, -1);
    if (!over && goal < 0) continue;
    if (goal >= 0) setIs(knows, one * places + goal, true);
    for (let k = 0; k < people; k++) {
      if (i(band, k) != one || !is(present, k)) continue;
      if (goal >= 0) give(SCRIPT, GOAL, k, goal);
      else {
        withdraw(SCRIPT, GOAL, k);
        setI(phase, k, DONE);
      }
    }
  }
}

/** Where the first leader of a home's bands went who had a goal, -1 for nowhere. */
function leadersGoal(home: i32): i32 {
  for (let one = 0, count = bands(); one < count; one++) {
    if (i(bandHome, one) == home && is(present, i(leader, one)) && i(seenGoal, i(leader, one)) >= 0) {
      return i(seenGoal, i(leader, one));
    }
  }
  return -1;
}

/** Whether a band has its goals from another home now; who follows at times does so by turns, from the first. */
export function isFollowing(one: i32, now: f64): bool {
  if (i(follows, one) < 0) return false;
  if (!is(atTimes, one)) return true;
  let begin = 0.0, periods = 0;
  while (begin <= now) begin += SHORTEST_S + uniform(FOLLOWING, periods++, one) * (LONGEST_S - SHORTEST_S);
  return periods % 2 == 1;
}
