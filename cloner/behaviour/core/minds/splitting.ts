// Group behaviour 6, split: members chosen at random get new intentions and are bands of their own.

import { f, goal, i, is, people, places, setF, setI, setIs } from "../memory";
import { CUTS, INTENTION, SPLIT } from "../dice";
import { leaderOf, membersOf, mix, setKey, sort } from "./members";
import { forgetScript } from "./orders";
import {
  DONE, acted, atTimes, band, bandHome, bands, bandsHeld, follows, followsUntil, goals, knows, leader, longest, memoryCount,
  memoryName, memoryTime, more, numbers, part, phase, remembers, rules, some, they, visitCount, visited, visits,
} from "./state";
import { PART, SPLITS, tell } from "./told";

/** Split a band into so many, each of a random size; the first part, with the leader, stays as it is. */
export function split(one: i32, wanted: i32, step: i32, now: f64): void {
  const count = membersOf(one, some), into = min(wanted, count);
  if (into < 2) return;
  mix(some, count, SPLIT, step);
  leaderFirst(one, count);
  for (let k = 1; k < count; k++) setI(more, k - 1, k);
  mix(more, count - 1, CUTS, step);
  for (let k = 0; k < into - 1; k++) setKey(k, i(more, k));
  sort(more, into - 1);
  setI(more, into - 1, count);
  tell(now, SPLITS, i(bandHome, one), into);
  tell(now, PART, 0, i(more, 0));
  for (let k = 1; k < into; k++) tell(now, PART, 0, i(more, k) - i(more, k - 1));
  for (let k = 1; k < into; k++) {
    const first = i(more, k - 1), size = i(more, k) - first;
    for (let j = 0; j < size; j++) {
      setI(part, j, i(some, first + j));
      setKey(j, i(part, j));
    }
    sort(part, size);
    makeBand(one, size);
  }
}

/** Put the leader, if he is in `some`, before all others. */
function leaderFirst(one: i32, count: i32): void {
  let at = 0;
  while (at < count && i(some, at) != i(leader, one)) at++;
  if (at == count) return;
  for (let k = at; k > 0; k--) setI(some, k, i(some, k - 1));
  setI(some, 0, i(leader, one));
}

/** Make a band of those in `part`: it knows what the old one knew and goes to other places first. */
function makeBand(old: i32, size: i32): void {
  const made = free();
  if (made < 0) return;
  setI(bandHome, made, i(bandHome, old));
  setIs(they, made, false);
  const first = leaderOf(made, part, size);
  setI(leader, made, first);
  setI(follows, made, -1);
  setF(followsUntil, made, f(followsUntil, old));
  setIs(atTimes, made, is(atTimes, old));
  memory.copy(knows + <usize>(made * places), knows + <usize>(old * places), <usize>places);
  memory.copy(acted + <usize>(made * rules), acted + <usize>(old * rules), <usize>rules);
  setI(memoryCount, made, i(memoryCount, old));
  for (let k = 0; k < i(memoryCount, old); k++) {
    setI(memoryName, made * remembers + k, i(memoryName, old * remembers + k));
    setF(memoryTime, made * remembers + k, f(memoryTime, old * remembers + k));
  }
  intend(old, made, first);
  for (let k = 0; k < size; k++) {
    const one = i(part, k);
    setI(band, one, made);
    setI(visited, one, -1);
    setI(phase, one, DONE);
    forgetScript(one);
  }
}

/** Give a new band what the old one wanted to visit, else what it knows, in an order of its own: last where it is. */
function intend(old: i32, made: i32, first: i32): void {
  let count = 0, kept = 0;
  for (let k = 0; k < places; k++) {
    if (i(visitCount, old) > 0 ? wanted(old, k) : is(knows, old * places + k)) setI(goals, count++, k);
  }
  mix(goals, count, INTENTION, first);
  const now = i(goal, i(leader, old));
  for (let k = 0; k < count; k++) {
    if (i(goals, k) != now) setI(visits, made * longest + kept++, i(goals, k));
  }
  if (kept < count) setI(visits, made * longest + kept++, now);
  setI(visitCount, made, kept);
}

function wanted(one: i32, place: i32): bool {
  for (let k = 0; k < i(visitCount, one); k++) {
    if (i(visits, one * longest + k) == place) return true;
  }
  return false;
}

/** The number of a band to come: a new one, else one that has nobody left. */
function free(): i32 {
  const count = bands();
  if (count < bandsHeld) {
    setI(numbers, 1, count + 1);
    return count;
  }
  for (let one = 0; one < count; one++) {
    let empty = true;
    for (let k = 0; k < people; k++) empty = empty && i(band, k) != one;
    if (empty) return one;
  }
  return -1;
}
