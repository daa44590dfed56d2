import type { Cell, Maze, Side } from "./maze";
import type { MazeFrame } from "./maze_drawing";

export interface Edge {
  cell: Cell;
  side: Side;
}

/** A click within this distance of an edge picks it, as a share of a cell. */
const pick_distance = 0.34;

export function cell_at(maze: Maze, frame: MazeFrame, u_px: number, v_px: number): Cell | undefined {
  const x = Math.floor((u_px - frame.left_px) / frame.cell_px);
  const y = Math.floor((frame.bottom_px - v_px) / frame.cell_px);
  return maze.contains({ x, y }) ? { x, y } : undefined;
}

/** In a stroke, an edge is picked only where the pointer passes its middle part: corners belong to two edges. */
const corner_share = 0.25;

/**
 * The edge nearest to a point of the canvas; none near the middle of a cell.
 * @param in_stroke none near corners either
 */
export function edge_at(
  maze: Maze,
  frame: MazeFrame,
  u_px: number,
  v_px: number,
  in_stroke = false,
): Edge | undefined {
  const cell = cell_at(maze, frame, u_px, v_px);
  if (!cell) return undefined;
  const right = (u_px - frame.left_px) / frame.cell_px - cell.x;
  const up = (frame.bottom_px - v_px) / frame.cell_px - cell.y;
  const distances: [Side, number][] = [
    ["N", 1 - up],
    ["E", 1 - right],
    ["S", up],
    ["W", right],
  ];
  const [side, away] = distances.reduce((best, candidate) => (candidate[1] < best[1] ? candidate : best));
  const along = side === "N" || side === "S" ? right : up;
  if (in_stroke && Math.min(along, 1 - along) < corner_share) return undefined;
  return away < pick_distance ? { cell, side } : undefined;
}
