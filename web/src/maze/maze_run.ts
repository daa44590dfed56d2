import { neighbour, opposite } from "./maze";
import type { Cell, Side } from "./maze";

/** One learning cycle in the response of the service maze/run. */
export interface MazeStep {
  cell: [number, number];
  open: string;
  input: string;
  /** How the preprocessing unit classified the cell, and the sides that it left open. */
  input_kind: string;
  input_open: string;
  rule: string;
  state: string;
  move: Side | "";
  stack: string[];
}

export interface MazeRun {
  width: number;
  height: number;
  start: [number, number];
  rules: string;
  steps: MazeStep[];
  figures: { reachable: number; visited: number; moves: number; complete: boolean };
}

/** What the vehicle knows after a number of cycles. */
export interface Known {
  at: Cell;
  /** The open sides of every visited cell, by the cell's index. */
  open: Map<number, string>;
  path: Cell[];
  /** The side through which the vehicle entered the cell; undefined at the start. */
  came_from: Side | undefined;
}

export function cell_of([x, y]: [number, number]): Cell {
  return { x, y };
}

/** The cells of the last run that was asked for, so that the next cycle adds its own only. */
let last: { run: MazeRun; open: Map<number, string>; path: Cell[] } | undefined;

/** @param count of cycles so far, at least 1. The result is valid until the next call */
export function known_after(run: MazeRun, count: number): Known {
  if (last?.run !== run || last.path.length > count) last = { run, open: new Map(), path: [] };
  const { open, path } = last;
  for (const { cell, open: sides } of run.steps.slice(path.length, count)) {
    open.set(cell[1] * run.width + cell[0], sides);
    path.push(cell_of(cell));
  }
  const before = run.steps[count - 2]?.move;
  return {
    at: path.at(-1) ?? cell_of(run.start),
    open,
    path,
    came_from: before ? opposite(before) : undefined,
  };
}

/** The sides closed by a false wall of the preprocessing unit; in explored cells that is the side of entry. */
export function false_walls(step: MazeStep, came_from: Side | undefined): Side[] {
  const is_given = step.input_open !== "" || /ending|dead/.test(step.input_kind);
  const is_closed = (side: Side) => (is_given ? !step.input_open.includes(side) : side === came_from);
  return ([...step.open] as Side[]).filter(is_closed);
}

/** Unvisited cells that are open to a visited one. */
export function frontier_cells(run: MazeRun, known: Known): Cell[] {
  const frontier = new Map<number, Cell>();
  for (const [index, open] of known.open) {
    const cell = { x: index % run.width, y: Math.floor(index / run.width) };
    for (const side of open as Iterable<Side>) {
      const beyond = neighbour(cell, side);
      const number = beyond.y * run.width + beyond.x;
      if (!known.open.has(number)) frontier.set(number, beyond);
    }
  }
  return [...frontier.values()];
}
