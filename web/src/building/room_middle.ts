/** Where a room has most space: there its name is put. */

import type { Point } from "../plan/geometry";
import type { Floor } from "./building_file";
import { unpack_row } from "./floor_cells";

/** Space may shrink over this distance on the way to where there is more: furniture stands about. */
const look_m = 0.5;

/** Steps to the eight neighbours, each with its length in cells. */
const steps = [-1, 0, 1].flatMap((down) =>
  [-1, 0, 1].flatMap((right) => (down || right ? [{ right, down, cells: Math.hypot(right, down) }] : [])),
);

/** Distances to the nearest cell that is not known to be free, in cells, with a border of such cells around. */
class Clearances {
  readonly columns: number;
  readonly #cells: Float32Array;

  constructor(rows: readonly string[]) {
    const unpacked = rows.map(unpack_row);
    this.columns = Math.max(0, ...unpacked.map((row) => row.length)) + 2;
    this.#cells = new Float32Array(this.columns * (rows.length + 2));
    unpacked.forEach((row, index) =>
      row.forEach((cell, column) => {
        if (cell === ".") this.#cells[(index + 1) * this.columns + column + 1] = Infinity;
      }),
    );
    // Twice over all cells: lengths along straight and diagonal steps are near enough to the distance.
    const size = this.#cells.length;
    for (let at = 0; at < size; at += 1) this.#lower(at, -1);
    for (let at = size - 1; at >= 0; at -= 1) this.#lower(at, 1);
  }

  at(cell: number): number {
    return this.#cells[cell] ?? 0;
  }

  /** From its neighbours before it, or behind it. */
  #lower(at: number, side: -1 | 1): void {
    if (this.at(at) === 0) return;
    for (const { right, down, cells } of steps) {
      const offset = down * this.columns + right;
      if (offset * side > 0) this.#cells[at] = Math.min(this.at(at), this.at(at + offset) + cells);
    }
  }

  /** The cell with most space, the nearest of equals, of those to which free floor leads within a distance. */
  best_near(start: number, within: number): number {
    let best = start;
    const seen = new Set([start]);
    for (const cell of seen) {
      if (this.at(cell) > this.at(best)) best = cell;
      for (const { right, down } of steps) {
        const next = cell + down * this.columns + right;
        if (this.at(next) > 0 && this.#away(start, next) <= within) seen.add(next);
      }
    }
    return best;
  }

  #away(from: number, to: number): number {
    const row = (cell: number) => Math.floor(cell / this.columns);
    return Math.hypot(row(to) - row(from), (to % this.columns) - (from % this.columns));
  }
}

/**
 * From a point of the free floor to where there is more space, until nowhere near has more: the middle of the room, or of
 * the corridor beside the point. Doors are narrow, so it does not leave the room. undefined: no free floor is known there
 */
export function room_middle({ cell_m, low_cell, rows }: Floor, at: Point): Point | undefined {
  const clearances = new Clearances(rows);
  const column = Math.floor(at.x / cell_m) - low_cell[0] + 1;
  const row = Math.floor(at.y / cell_m) - low_cell[1] + 1;
  if (column < 0 || column >= clearances.columns) return undefined;
  let cell = row * clearances.columns + column;
  if (clearances.at(cell) === 0) return undefined;
  for (let next = -1; next !== cell;) {
    if (next >= 0) cell = next;
    next = clearances.best_near(cell, look_m / cell_m);
  }
  const centre = (index: number, low: number) => (index - 1 + low + 0.5) * cell_m;
  return {
    x: centre(cell % clearances.columns, low_cell[0]),
    y: centre(Math.floor(cell / clearances.columns), low_cell[1]),
  };
}
