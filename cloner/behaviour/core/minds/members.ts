// Who belongs to a band, who leads it, and lists of people or places in an order.

import { f, i, is, people, places, present, setF, setI, take } from "../memory";
import { LEADER, uniform } from "../dice";
import { EMERGING, NAMED, band, bandHome, domination, homeFlags, homeLeads, longest } from "./state";

let keys: usize = 0; // of what is sorted, and room to merge
let spareKeys: usize = 0;
let spareRows: usize = 0;

/** Take room to sort people, places or visits. */
export function arrangeSorting(): void {
  const most = max(max(people, places), longest);
  keys = take(<usize>most * 8);
  spareKeys = take(<usize>most * 8);
  spareRows = take(<usize>most * 4);
}

/** Whether a band's home was told so. */
// @ts-ignore: decorator
@inline export function has(number: i32, flag: i32): bool { return (i(homeFlags, i(bandHome, number)) & flag) != 0; }

/** Write who of a band is there into a list, by their numbers; return how many. */
export function membersOf(number: i32, list: usize): i32 {
  let found = 0;
  for (let one = 0; one < people; one++) {
    if (i(band, one) == number && is(present, one)) setI(list, found++, one);
  }
  return found;
}

/** Who leads some people: the highest domination if leaders emerge, one at random, or, if named, the first. */
export function leaderOf(number: i32, list: usize, many: i32): i32 {
  const leads = i(homeLeads, i(bandHome, number));
  if (leads == EMERGING) return strongest(list, many);
  if (leads == NAMED) return i(list, 0);
  let first = i(list, 0), least = Infinity;
  for (let k = 0; k < many; k++) {
    const drawn = uniform(LEADER, 0, i(list, k));
    if (drawn < least) {
      least = drawn;
      first = i(list, k);
    }
  }
  return first;
}

/** Who of some people has the highest domination. */
export function strongest(list: usize, many: i32): i32 {
  let best = i(list, 0);
  for (let k = 1; k < many; k++) {
    if (f(domination, i(list, k)) > f(domination, best)) best = i(list, k);
  }
  return best;
}

/** Mix a list at random. */
export function mix(list: usize, many: i32, purpose: u64, times: i32): void {
  for (let k = 0; k < many; k++) setF(keys, k, uniform(purpose, times, i(list, k)));
  sort(list, many);
}

/** Give a row of a list its key, before `sort`. */
// @ts-ignore: decorator
@inline export function setKey(k: i32, key: f64): void { setF(keys, k, key); }

/** Sort a list by its keys, the least first; equal ones stay as they are. */
export function sort(list: usize, many: i32): void {
  for (let wide = 1; wide < many; wide *= 2) {
    for (let start = 0; start < many; start += 2 * wide) merge(list, start, min(start + wide, many), min(start + 2 * wide, many));
    memory.copy(keys, spareKeys, <usize>many * 8);
    memory.copy(list, spareRows, <usize>many * 4);
  }
}

function merge(list: usize, start: i32, middle: i32, end: i32): void {
  let left = start, right = middle;
  for (let k = start; k < end; k++) {
    const from = left < middle && (right >= end || f(keys, left) <= f(keys, right)) ? left++ : right++;
    setF(spareKeys, k, f(keys, from));
    setI(spareRows, k, i(list, from));
  }
}
