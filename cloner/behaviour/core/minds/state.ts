// What is true of each person's and each group's mind, and the scenario as tables of numbers.
//
// The scenario's groups are homes here; a group that acts as one is a band: one of each home at first, one of each person
// of a crowd; splitting makes new ones, joining moves people. n people, b bands, p places.

import { count, i, lend, people, places, take } from "../memory";

// What a home may be told, as bits of `homeFlags`.
export const FLOCKING: i32 = 1, ADAPTS: i32 = 2, WANDERS: i32 = 4, AGAIN: i32 = 8, OUTSIDE: i32 = 16;
// Who leads a home's bands.
export const AT_RANDOM: i32 = 0, EMERGING: i32 = 1, NAMED: i32 = 2;
// Phases of a visit.
export const WALKING: i32 = 0, WAITING: i32 = 1, CALLED: i32 = 2, ACTING: i32 = 3, DONE: i32 = 4;

export let bandsHeld: i32 = 0; // how many bands there can be
export let homes: i32 = 0;
export let longest: i32 = 0; // visits a band's list holds
export let remembers: i32 = 0; // rows of a band's memory
export let things: i32 = 0;
export let emotions: i32 = 0;
export let rules: i32 = 0;
export let events: i32 = 0;

// People
export let band: usize = 0; // n, i32
export let home: usize = 0; // n, i32
export let emotion: usize = 0; // n, i32
export let value: usize = 0; // n, how strong the emotion is, 0..1
export let vigour: usize = 0; // n, own speed over others' who feel the same
export let domination: usize = 0; // n
export let visited: usize = 0; // n, i32: which of the band's visits one is at, or how many visits by chance
export let phase: usize = 0; // n, i32
export let until: usize = 0; // n, s
export let leaving: usize = 0; // n, u8
export let posture: usize = 0; // n, i32: an act
export let gaze: usize = 0; // n, i32: a thing, or -1
export let idle: usize = 0; // n, i32: the act while nothing is ordered
export let orders: usize = 0; // channels x levels x n: what is ordered, -1 for nothing
export let ends: usize = 0; // alike, s: when it ends
export let isGuest: usize = 0; // n, u8
export let guestAt: usize = 0; // n x 2
export let guestWanted: usize = 0; // n x 2
export let guestFacing: usize = 0; // n x 2

// Bands
export let bandHome: usize = 0; // b, i32
export let leader: usize = 0; // b, i32: a person
export let follows: usize = 0; // b, i32: a home, or -1
export let followsUntil: usize = 0; // b, s
export let atTimes: usize = 0; // b, u8
export let visitCount: usize = 0; // b, i32
export let visits: usize = 0; // b x longest, i32: places
export let knows: usize = 0; // b x p, u8
export let memoryCount: usize = 0; // b, i32
export let memoryTime: usize = 0; // b x remembers, s, the oldest first
export let memoryName: usize = 0; // b x remembers, i32: a thing, or things and a place
export let acted: usize = 0; // b x rules, u8

// The scenario
export let homeFlags: usize = 0; // i32 as all that follow, unless told
export let homeLeads: usize = 0;
export let homeMemory: usize = 0;
export let likesFirst: usize = 0; // homes + 1
export let likes: usize = 0; // homes that are liked better than one's own, the most first
export let thingPlace: usize = 0; // x 2, m
export let awake: usize = 0; // u8
export let speed: usize = 0; // of each emotion, m/s
export let idleFirst: usize = 0; // emotions + 1
export let idleActs: usize = 0;
export let placeMiddle: usize = 0; // p x 2, m
export let placeLow: usize = 0; // p x 2, m
export let placeHigh: usize = 0; // p x 2, m
export let placeCounter: usize = 0; // p x 2, m: where one is served
export let placeSeconds: usize = 0; // p
export let placeAct: usize = 0; // -1 for none
export let placeHolds: usize = 0; // 0 for any number
export let placeLook: usize = 0; // a thing, or -1
export let spotFirst: usize = 0; // p + 1
export let spots: usize = 0; // x 2, m: where one can stand in each place
export let spotsNearest: usize = 0; // numbers of a place's spots, the nearest to its middle first
export let latticeFirst: usize = 0; // p + 1
export let latticeWide: usize = 0; // p
export let latticeLow: usize = 0; // p x 2, m
export let lattice: usize = 0; // a row of columns after another: the number of the spot there, or -1
export let ruleRows: usize = 0; // rules x 8: kind, who, whose, what, awake, first action, count of actions, fired
export let ruleSeconds: usize = 0; // rules
export let actionRows: usize = 0; // actions x 5: verb, who, whose, what, count
export let actionSeconds: usize = 0; // actions
export let happens: usize = 0; // u8: which events are there for the next minds
export let told: usize = 0; // rows of 4: time, what, which, how many; `toldCount` of them
export let numbers: usize = 0; // i32: how many rows are told, how many bands there are, which emotion is regular

// For use within a step
export let seenGoal: usize = 0; // n, i32
export let seenEmotion: usize = 0; // n, i32
export let seenThings: usize = 0; // b x things, u8
export let led: usize = 0; // p, u8
export let happened: usize = 0; // u8: which events are there for these
export let they: usize = 0; // b, u8: bands that meet a rule, or go their own ways
export let own: usize = 0; // n, u8: those who get spots
export let whom: usize = 0; // n, u8: people who are meant
export let fresh: usize = 0; // n, i32: those whose goal is new
export let some: usize = 0; // n, i32: a list of people
export let more: usize = 0; // alike
export let part: usize = 0; // alike
export let goals: usize = 0; // p, i32: a list of places
export let blocked: usize = 0; // of each spot, u8
export let away: usize = 0; // of each spot, m2

/** Rows of `told` that are kept until a host takes them. */
export let toldHeld: i32 = 0;

/** Take all arrays; what there is of each, hosts write at `counts()`. */
export function arrangeMinds(): void {
  homes = count(6); bandsHeld = count(7); longest = count(8); remembers = count(9); things = count(10);
  emotions = count(11); rules = count(14); events = count(16);
  toldHeld = 4 * people + 1024;
  const n = <usize>people, b = <usize>bandsHeld, p = <usize>places, h = <usize>homes, e = <usize>emotions;
  band = lend(n * 4); home = lend(n * 4); emotion = lend(n * 4); value = lend(n * 8); vigour = lend(n * 8);
  domination = lend(n * 8); visited = lend(n * 4); phase = lend(n * 4); until = lend(n * 8); leaving = lend(n);
  posture = lend(n * 4); gaze = lend(n * 4); idle = lend(n * 4); orders = lend(n * 160); ends = lend(n * 160);
  bandHome = lend(b * 4); leader = lend(b * 4); follows = lend(b * 4); followsUntil = lend(b * 8); atTimes = lend(b);
  visitCount = lend(b * 4); visits = lend(b * <usize>longest * 4); knows = lend(b * p);
  memoryCount = lend(b * 4); memoryTime = lend(b * <usize>remembers * 8); memoryName = lend(b * <usize>remembers * 4);
  homeFlags = lend(h * 4); homeLeads = lend(h * 4); homeMemory = lend(h * 4);
  likesFirst = lend((h + 1) * 4); likes = lend(<usize>count(12) * 4);
  thingPlace = lend(<usize>things * 16); awake = lend(<usize>things);
  speed = lend(e * 8); idleFirst = lend((e + 1) * 4); idleActs = lend(<usize>count(13) * 4);
  placeMiddle = lend(p * 16); placeLow = lend(p * 16); placeHigh = lend(p * 16); placeCounter = lend(p * 16);
  placeSeconds = lend(p * 8); placeAct = lend(p * 4); placeHolds = lend(p * 4); placeLook = lend(p * 4);
  spotFirst = lend((p + 1) * 4); spots = lend(<usize>count(17) * 16); spotsNearest = lend(<usize>count(17) * 4);
  latticeFirst = lend((p + 1) * 4); latticeWide = lend(p * 4); latticeLow = lend(p * 16);
  lattice = lend(<usize>count(18) * 4);
  ruleRows = lend(<usize>rules * 32); ruleSeconds = lend(<usize>rules * 8);
  actionRows = lend(<usize>count(15) * 20); actionSeconds = lend(<usize>count(15) * 8);
  told = lend(<usize>toldHeld * 32); numbers = lend(4 * 4);
  acted = take(b * <usize>rules); happens = take(<usize>events);
  happened = take(<usize>events);
  isGuest = take(n); guestAt = take(n * 16); guestWanted = take(n * 16); guestFacing = take(n * 16);
  seenGoal = take(n * 4); seenEmotion = take(n * 4); seenThings = take(b * <usize>things); led = take(p);
  they = take(b); whom = take(n); own = take(n); some = take(n * 4); fresh = take(n * 4); more = take(n * 4); part = take(n * 4); goals = take(p * 4);
  blocked = take(<usize>count(17)); away = take(<usize>count(17) * 8);
}

/** How many bands there are now. */
// @ts-ignore: decorator
@inline export function bands(): i32 { return i(numbers, 1); }
