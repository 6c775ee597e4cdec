// The arrays of a module, one after the other in its memory.
//
// A host writes how many there are of everything at `counts()`, lets the module begin, and asks `at(k)` where the k-th of
// the arrays that are lent lies. f64 unless told.

let top: usize = 0;
let lent: i32 = 0;
const LENT = memory.data(96 * 4);
const COUNTS = memory.data(24 * 4);

/** Where a host writes, as i32, how many there are. */
export function counts(): usize { return COUNTS; }

/** How many there are of what a host counts there. */
export function count(kind: i32): i32 { return i(COUNTS, kind); }

/** Take bytes of the memory; they are zero. */
export function take(bytes: usize): usize {
  const found = (taken() + 15) & ~15;
  extend(found + bytes);
  return found;
}

/** Where what is taken ends. */
export function taken(): usize {
  if (top == 0) top = __heap_base;
  return top;
}

/** Let the array that was taken last end there. */
export function extend(end: usize): void {
  top = end;
  const more = <i32>((top + 0xffff) >>> 16) - memory.size();
  if (more > 0 && memory.grow(more) < 0) unreachable();
}

/** Take an array that hosts may read and write. */
export function lend(bytes: usize): usize {
  const found = take(bytes);
  setI(LENT, lent++, <i32>found);
  return found;
}

/** Where the k-th array that is lent lies. */
export function at(kind: i32): usize { return <usize>i(LENT, kind); }

// One number of an array of f64, i32 or u8.
// @ts-ignore: decorator
@inline export function f(array: usize, k: i32): f64 { return load<f64>(array + (<usize>k << 3)); }
// @ts-ignore: decorator
@inline export function setF(array: usize, k: i32, value: f64): void { store<f64>(array + (<usize>k << 3), value); }
// @ts-ignore: decorator
@inline export function i(array: usize, k: i32): i32 { return load<i32>(array + (<usize>k << 2)); }
// @ts-ignore: decorator
@inline export function setI(array: usize, k: i32, value: i32): void { store<i32>(array + (<usize>k << 2), value); }
// @ts-ignore: decorator
@inline export function is(array: usize, k: i32): bool { return load<u8>(array + <usize>k) != 0; }
// @ts-ignore: decorator
@inline export function setIs(array: usize, k: i32, value: bool): void { store<u8>(array + <usize>k, value ? 1 : 0); }
