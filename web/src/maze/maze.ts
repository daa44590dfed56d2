/** A world of square cells with walls on their edges; (0, 0) is the bottom left cell, as in docs/formats/maze.md. */

export type Side = "N" | "E" | "S" | "W";

export interface Cell {
  x: number;
  y: number;
}

export const sides: readonly Side[] = ["N", "E", "S", "W"];
export const max_size = 64;

const steps: Record<Side, Cell> = {
  N: { x: 0, y: 1 },
  E: { x: 1, y: 0 },
  S: { x: 0, y: -1 },
  W: { x: -1, y: 0 },
};
const opposites: Record<Side, Side> = { N: "S", E: "W", S: "N", W: "E" };

export function neighbour({ x, y }: Cell, side: Side): Cell {
  return { x: x + steps[side].x, y: y + steps[side].y };
}

export function opposite(side: Side): Side {
  return opposites[side];
}

export class Maze {
  start: Cell = { x: 0, y: 0 };
  readonly goals = new Set<number>();
  /** One bit for each side of a cell that has a wall; set in both cells of an edge. */
  readonly #walls: Uint8Array;

  constructor(
    readonly width: number,
    readonly height: number,
  ) {
    this.#walls = new Uint8Array(width * height);
    for (const cell of this.cells()) {
      for (const side of sides) if (!this.contains(neighbour(cell, side))) this.#mark(cell, side, true);
    }
  }

  copy(): Maze {
    const made = new Maze(this.width, this.height);
    made.#walls.set(this.#walls);
    made.start = this.start;
    for (const goal of this.goals) made.goals.add(goal);
    return made;
  }

  contains({ x, y }: Cell): boolean {
    return x >= 0 && y >= 0 && x < this.width && y < this.height;
  }

  index({ x, y }: Cell): number {
    return y * this.width + x;
  }

  *cells(): Iterable<Cell> {
    for (let y = 0; y < this.height; y += 1) for (let x = 0; x < this.width; x += 1) yield { x, y };
  }

  has_wall(cell: Cell, side: Side): boolean {
    return ((this.#walls[this.index(cell)] ?? 0) & (1 << sides.indexOf(side))) !== 0;
  }

  /** Adds or removes the wall between two cells; the outer walls cannot be changed. */
  set_wall(cell: Cell, side: Side, is_closed: boolean): void {
    const beyond = neighbour(cell, side);
    if (!this.contains(cell) || !this.contains(beyond)) return;
    this.#mark(cell, side, is_closed);
    this.#mark(beyond, opposite(side), is_closed);
  }

  #mark(cell: Cell, side: Side, is_closed: boolean): void {
    const at = this.index(cell);
    const bit = 1 << sides.indexOf(side);
    this.#walls[at] = ((this.#walls[at] ?? 0) & ~bit) | (is_closed ? bit : 0);
  }
}
