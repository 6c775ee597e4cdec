// The arrays of cloth.
//
// What a host counts: 0 vertices, 1 triangles, 2 threads that are drawn, 3 that are bent, 4 held vertices, 5 neighbours in
// all, 6 points of skin; `host.py` has the list of what is lent. Metres, seconds, kilograms; points are x, y, z.
// n vertices, t triangles, s threads that are drawn, b threads that are bent, h held vertices, m points of skin.

import { count, lend, take } from "../../../webassembly/arrays";
export { at, count, counts, extend, f, i, is, setF, setI, setIs, take } from "../../../webassembly/arrays";

export let vertices: i32 = 0;
export let triangles: i32 = 0;
export let stretches: i32 = 0;
export let bends: i32 = 0;
export let helds: i32 = 0;
export let skins: i32 = 0;

export let place: usize = 0; // n x 3
export let before: usize = 0; // n x 3, places before a small step
export let velocity: usize = 0; // n x 3
export let thrust: usize = 0; // n x 3, acceleration
export let free: usize = 0; // n, one over the mass; 0 for held ones
export let faces: usize = 0; // t x 3, i32
export let stretchEnds: usize = 0; // s x 2, i32
export let stretchRest: usize = 0; // s
export let stretchGives: usize = 0; // s, m/N
export let bendEnds: usize = 0; // b x 2, i32
export let bendRest: usize = 0; // b
export let bendGives: usize = 0; // b, m/N
export let held: usize = 0; // h, i32
export let heldEarly: usize = 0; // h x 3, at a frame's beginning
export let heldLate: usize = 0; // h x 3, at its end
export let anchor: usize = 0; // n, i32: the held vertex whose cloth is nearest, or -1
export let leash: usize = 0; // n, how far from it
export let radius: usize = 0; // n, two vertices stay the sum of theirs apart
export let nextFirst: usize = 0; // n + 1, i32: where each vertex' neighbours begin
export let next: usize = 0; // i32, neighbours in the cloth, which threads hold; ~ of those that lie across an edge, and near
export let skinEarly: usize = 0; // m x 3, at a frame's beginning
export let skinLate: usize = 0; // m x 3, at its end
export let skinNormal: usize = 0; // m x 3, outward
export let leadEarly: usize = 0; // n x 3, where cloth is led
export let leadLate: usize = 0; // n x 3
export let planeEarly: usize = 0; // n x 3, a point of the tangent plane under each vertex at a frame's beginning
export let planeLate: usize = 0; // n x 3, at its end
export let planeNormal: usize = 0; // n x 3
export let near: usize = 0; // n, u8: whether it has a plane

/** Take all arrays. Called once. */
export function arrange(): void {
  vertices = count(0); triangles = count(1); stretches = count(2); bends = count(3); helds = count(4); skins = count(6);
  const n = <usize>vertices, s = <usize>stretches, b = <usize>bends, h = <usize>helds, m = <usize>skins;
  place = lend(n * 24); before = lend(n * 24); velocity = lend(n * 24); thrust = lend(n * 24); free = lend(n * 8);
  faces = lend(<usize>triangles * 12);
  stretchEnds = lend(s * 8); stretchRest = lend(s * 8); stretchGives = lend(s * 8);
  bendEnds = lend(b * 8); bendRest = lend(b * 8); bendGives = lend(b * 8);
  held = lend(h * 4); heldEarly = lend(h * 24); heldLate = lend(h * 24);
  anchor = lend(n * 4); leash = lend(n * 8); radius = lend(n * 8);
  nextFirst = lend((n + 1) * 4); next = lend(<usize>count(5) * 4);
  skinEarly = lend(m * 24); skinLate = lend(m * 24); skinNormal = lend(m * 24);
  leadEarly = lend(n * 24); leadLate = lend(n * 24);
  planeEarly = lend(n * 24); planeLate = lend(n * 24); planeNormal = lend(n * 24); near = lend(n);
}
