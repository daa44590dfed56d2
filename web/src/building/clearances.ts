/** How much space there is about each cell of the free floor. */

import { once_for_each } from "../page/once";
import type { Point } from "../plan/geometry";
import type { Floor } from "./building_file";
import { unpack_row } from "./floor_cells";

/** Steps to the eight neighbours, each with its length in cells. */
const steps = [-1, 0, 1].flatMap((down) =>
  [-1, 0, 1].flatMap((right) => (down || right ? [{ right, down, cells: Math.hypot(right, down) }] : [])),
);

/** Distances to the nearest cell that is not known to be free, in cells, with a border of such cells around. */
export class Clearances {
  readonly columns: number;
  /** How many cells there are. */
  readonly size: number;
  /** From a cell to its eight neighbours. */
  readonly offsets: readonly number[];
  readonly #cells: Float32Array;

  constructor(private readonly floor: Floor) {
    const unpacked = floor.rows.map(unpack_row);
    this.columns = Math.max(0, ...unpacked.map((row) => row.length)) + 2;
    this.size = this.columns * (unpacked.length + 2);
    this.offsets = steps.map(({ right, down }) => down * this.columns + right);
    this.#cells = new Float32Array(this.size);
    unpacked.forEach((row, index) =>
      row.forEach((cell, column) => {
        if (cell === ".") this.#cells[(index + 1) * this.columns + column + 1] = Infinity;
      }),
    );
    // Twice over all cells: lengths along straight and diagonal steps are near enough to the distance.
    for (let at = 0; at < this.size; at += 1) this.#lower(at, -1);
    for (let at = this.size - 1; at >= 0; at -= 1) this.#lower(at, 1);
  }

  at(cell: number): number {
    return this.#cells[cell] ?? 0;
  }

  /** undefined: outside the floor. */
  cell_at({ x, y }: Point): number | undefined {
    const { cell_m, low_cell } = this.floor;
    const column = Math.floor(x / cell_m) - low_cell[0] + 1;
    const cell = (Math.floor(y / cell_m) - low_cell[1] + 1) * this.columns + column;
    return column < 0 || column >= this.columns || cell < 0 || cell >= this.size ? undefined : cell;
  }

  /** The corner of a cell with the lowest coordinates. */
  low_corner(cell: number): Point {
    const { cell_m, low_cell } = this.floor;
    return {
      x: ((cell % this.columns) - 1 + low_cell[0]) * cell_m,
      y: (Math.floor(cell / this.columns) - 1 + low_cell[1]) * cell_m,
    };
  }

  /** From its neighbours before it, or behind it. */
  #lower(at: number, side: -1 | 1): void {
    if (this.at(at) === 0) return;
    steps.forEach(({ cells }, index) => {
      const offset = this.offsets[index] ?? 0;
      if (offset * side > 0) this.#cells[at] = Math.min(this.at(at), this.at(at + offset) + cells);
    });
  }
}

export const clearances_of = once_for_each((floor: Floor) => new Clearances(floor));
