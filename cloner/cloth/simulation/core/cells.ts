// Points sorted into the cells of a grid, as many as lie in the box round them.

import { f, i, setI, take } from "./memory";

/** No side of a grid has more cells: cloth that flies far makes cells larger, not more. */
const MOST: i32 = 96;

// @ts-ignore: decorator
@unmanaged
export class Cells {
  begin: usize; // where each cell's points begin in `listed`
  listed: usize;
  cell: usize; // of each point
  lowX: f64; lowY: f64; lowZ: f64;
  side: f64;
  wide: i32; high: i32; deep: i32;

  /** Take a grid for so many points. */
  static of(count: i32): Cells {
    const made = changetype<Cells>(take(offsetof<Cells>()));
    made.begin = take((<usize>(MOST * MOST * MOST) + 1) << 2);
    made.listed = take(<usize>count << 2);
    made.cell = take(<usize>count << 2);
    return made;
  }

  /** Sort `count` points into cells of at least so many metres. */
  sort(points: usize, count: i32, side: f64): void {
    let lowX = Infinity, lowY = Infinity, lowZ = Infinity, highX = -Infinity, highY = -Infinity, highZ = -Infinity;
    for (let k = 0; k < count; k++) {
      const x = f(points, 3 * k), y = f(points, 3 * k + 1), z = f(points, 3 * k + 2);
      lowX = min(lowX, x); lowY = min(lowY, y); lowZ = min(lowZ, z);
      highX = max(highX, x); highY = max(highY, y); highZ = max(highZ, z);
    }
    this.side = side = max(side, max(max(highX - lowX, highY - lowY), highZ - lowZ) / <f64>(MOST - 1));
    this.lowX = lowX; this.lowY = lowY; this.lowZ = lowZ;
    this.wide = <i32>((highX - lowX) / side) + 1;
    this.high = <i32>((highY - lowY) / side) + 1;
    this.deep = <i32>((highZ - lowZ) / side) + 1;
    const cells = this.wide * this.high * this.deep;
    memory.fill(this.begin, 0, (<usize>cells + 1) << 2);
    for (let k = 0; k < count; k++) {
      const own = this.index(this.column(f(points, 3 * k)), this.row(f(points, 3 * k + 1)), this.layer(f(points, 3 * k + 2)));
      setI(this.cell, k, own);
      setI(this.begin, own, i(this.begin, own) + 1);
    }
    for (let k = 1; k <= cells; k++) setI(this.begin, k, i(this.begin, k) + i(this.begin, k - 1));
    for (let k = count - 1; k >= 0; k--) {
      const own = i(this.cell, k), to = i(this.begin, own) - 1;
      setI(this.begin, own, to);
      setI(this.listed, to, k);
    }
  }

  // Cells of a place, which may lie outside the box.
  column(x: f64): i32 { return <i32>floor((x - this.lowX) / this.side); }
  row(y: f64): i32 { return <i32>floor((y - this.lowY) / this.side); }
  layer(z: f64): i32 { return <i32>floor((z - this.lowZ) / this.side); }
  index(column: i32, row: i32, layer: i32): i32 { return (layer * this.high + row) * this.wide + column; }
}
