// Random numbers that depend on seed, purpose and person alone, as `dice.py` has them: SplitMix64 as a hash.

import { seed } from "./memory";

const GOLDEN: u64 = 0x9e3779b97f4a7c15;
/** CRC-32 of the purposes' names, in small letters. */
export const CURVE: u64 = 0x57995db7, TURN: u64 = 0x20201547, IDLE: u64 = 0xdc24b515, VISIT: u64 = 0x437ee939,
  FOLLOWING: u64 = 0x71bf8de3, TASTE: u64 = 0x69d6de58, AWAY: u64 = 0xa65fa2d1, SPLIT: u64 = 0xb1f59a11,
  CUTS: u64 = 0xd8b2b13e, LEADER: u64 = 0xf5e3ead7, INTENTION: u64 = 0x5e80ce76, CROWDED: u64 = 0x91d9042a,
  WHOSE: u64 = 0x090327d1, SPOT: u64 = 0xb9327a73;

function mixed(z: u64): u64 {
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
  z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
  return z ^ (z >> 31);
}

/** One number in 0..1 for a purpose, how often it came up, and a person. */
export function uniform(what: u64, count: i32, who: i32): f64 {
  const purpose = (what << 32) ^ <u64>count;
  const base = mixed(mixed(seed * GOLDEN) + purpose);
  return <f64>(mixed(mixed(base + <u64>who * GOLDEN)) >> 11) * 1.1102230246251565e-16;
}
