// Random numbers that depend on seed, purpose and person alone, as `dice.py` has them: SplitMix64 as a hash.

import { seed } from "./memory";

const GOLDEN: u64 = 0x9e3779b97f4a7c15;
/** CRC-32 of the purposes' names: "curve" and "turn". */
export const CURVE: u64 = 0x57995db7;
export const TURN: u64 = 0x20201547;

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
