// Group behaviour 3, goal changing: who likes another home better joins it; who dominates most leads, elsewhere.

import { f, i, is, people, place, present, setI } from "../memory";
import { TASTE } from "../dice";
import { membersOf, mix, strongest } from "./members";
import { GOAL, SCRIPT, forgetScript, give, ordered, withdraw } from "./orders";
import {
  DONE, EMERGING, WALKING, band, bandHome, bands, homeLeads, leader, likes, likesFirst, longest, memoryCount, phase,
  some, visitCount, visited, visits,
} from "./state";
import { JOINED, LED, tell } from "./told";

/** A band that is so near can be joined, m; taste. */
const NEAR_M: f64 = 5.0;

/** Let people change band by liking, then bands change leader by domination. */
export function change(now: f64): void {
  for (let one = 0, count = bands(); one < count; one++) {
    const first = i(likesFirst, i(bandHome, one)), last = i(likesFirst, i(bandHome, one) + 1);
    for (let k = first; k < last; k++) joinNear(one, i(likes, k), now);
  }
  for (let one = 0, count = bands(); one < count; one++) {
    if (i(homeLeads, i(bandHome, one)) != EMERGING) continue;
    const members = membersOf(one, some);
    if (members == 0) continue;
    const first = strongest(some, members);
    if (first != i(leader, one)) lead(one, first, members, now);
  }
}

/** Let each member who is near the leader of a better liked home's band join it. */
function joinNear(one: i32, home: i32, now: f64): void {
  for (let who = 0; who < people; who++) {
    if (i(band, who) != one || !is(present, who)) continue;
    for (let other = 0, count = bands(); other < count; other++) {
      const first = i(leader, other);
      if (i(bandHome, other) != home || other == one || !is(present, first)) continue;
      const dx = f(place, 2 * first) - f(place, 2 * who), dy = f(place, 2 * first + 1) - f(place, 2 * who + 1);
      if (dx * dx + dy * dy >= NEAR_M * NEAR_M) continue;
      join(who, other, now);
      break;
    }
  }
}

/** Let somebody leave his band, take another's goal from where it is now, and lead nobody. */
function join(who: i32, other: i32, now: f64): void {
  const left = i(band, who), first = i(leader, other);
  setI(band, who, other);
  setI(visited, who, i(visited, first));
  setI(phase, who, WALKING);
  forgetScript(who);
  const goal = ordered(SCRIPT, GOAL, first);
  if (goal >= 0.0) give(SCRIPT, GOAL, who, goal);
  else setI(phase, who, DONE);
  tell(now, JOINED, i(bandHome, other), 1);
  if (i(band, i(leader, left)) == left && is(present, i(leader, left))) return;
  const members = membersOf(left, some);
  if (members > 0) setI(leader, left, strongest(some, members));
}

/** Let somebody lead a band: he takes it through the goals in an order of his own. */
function lead(one: i32, first: i32, members: i32, now: f64): void {
  setI(leader, one, first);
  mix(visits + (<usize>(one * longest) << 2), i(visitCount, one), TASTE, first);
  for (let k = 0; k < members; k++) {
    setI(visited, i(some, k), -1);
    setI(phase, i(some, k), DONE);
    withdraw(SCRIPT, GOAL, i(some, k));
  }
  setI(memoryCount, one, 0);
  tell(now, LED, i(bandHome, one));
}
