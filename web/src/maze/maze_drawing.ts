import { colour } from "../page/theme";
import { neighbour, sides } from "./maze";
import type { Cell, Maze, Side } from "./maze";
import { frontier_cells } from "./maze_run";
import type { Known, MazeRun } from "./maze_run";

/** Where the maze is on its canvas: pixels per cell, and the lower left corner. */
export interface MazeFrame {
  cell_px: number;
  left_px: number;
  bottom_px: number;
}

type Context = CanvasRenderingContext2D;

const margin_px = 14;
const turns: Record<Side, number> = { E: 0, N: -Math.PI / 2, W: Math.PI, S: Math.PI / 2 };

export function frame_of(maze: Maze, width_px: number, height_px: number): MazeFrame {
  const cell_px = Math.min(
    (width_px - 2 * margin_px) / maze.width,
    (height_px - 2 * margin_px) / maze.height,
    64,
  );
  return {
    cell_px,
    left_px: (width_px - cell_px * maze.width) / 2,
    bottom_px: (height_px + cell_px * maze.height) / 2,
  };
}

function corner(frame: MazeFrame, x: number, y: number): [number, number] {
  return [frame.left_px + x * frame.cell_px, frame.bottom_px - y * frame.cell_px];
}

function middle(frame: MazeFrame, { x, y }: Cell): [number, number] {
  return corner(frame, x + 0.5, y + 0.5);
}

function fill_cells(context: Context, frame: MazeFrame, cells: Iterable<Cell>, style: string): void {
  context.fillStyle = style;
  context.beginPath();
  for (const { x, y } of cells) context.rect(...corner(frame, x, y + 1), frame.cell_px, frame.cell_px);
  context.fill();
}

function edge(context: Context, frame: MazeFrame, { x, y }: Cell, side: Side): void {
  const [left, low] = [side === "E" ? x + 1 : x, side === "N" ? y + 1 : y];
  const is_level = side === "N" || side === "S";
  context.moveTo(...corner(frame, left, low));
  context.lineTo(...corner(frame, is_level ? left + 1 : left, is_level ? low : low + 1));
}

export function draw_grid(context: Context, frame: MazeFrame, maze: Maze): void {
  context.fillStyle = colour("edge");
  for (let x = 0; x <= maze.width; x += 1) {
    for (let y = 0; y <= maze.height; y += 1) {
      const [u, v] = corner(frame, x, y);
      context.fillRect(u - 1, v - 1, 2, 2);
    }
  }
}

/** @param known what the vehicle has explored; walls that it has not seen are drawn faint */
export function draw_walls(context: Context, frame: MazeFrame, maze: Maze, known?: Known): void {
  const seen = (cell: Cell, side: Side) =>
    !known || known.open.has(maze.index(cell)) || known.open.has(maze.index(neighbour(cell, side)));
  for (const is_seen of [false, true]) {
    context.strokeStyle = colour(is_seen ? "wall" : "blocked");
    context.lineWidth = is_seen ? Math.max(2, frame.cell_px / 10) : 1.5;
    context.setLineDash(is_seen ? [] : [3, 3]);
    context.lineCap = is_seen ? "round" : "butt";
    context.beginPath();
    for (const cell of maze.cells()) {
      for (const side of sides) {
        const is_drawn_by_neighbour = (side === "S" && cell.y > 0) || (side === "W" && cell.x > 0);
        if (!is_drawn_by_neighbour && maze.has_wall(cell, side) && seen(cell, side) === is_seen)
          edge(context, frame, cell, side);
      }
    }
    context.stroke();
  }
  context.setLineDash([]);
}

export function draw_start_and_goals(context: Context, frame: MazeFrame, maze: Maze): void {
  context.font = `600 ${Math.min(16, frame.cell_px * 0.45)}px system-ui, sans-serif`;
  context.textAlign = "center";
  context.textBaseline = "middle";
  context.fillStyle = colour("good");
  context.fillText("S", ...middle(frame, maze.start));
  context.fillStyle = colour("path");
  for (const goal of maze.goals) {
    context.fillText("G", ...middle(frame, { x: goal % maze.width, y: Math.floor(goal / maze.width) }));
  }
}

export function draw_known(context: Context, frame: MazeFrame, run: MazeRun, known: Known): void {
  const visited = [...known.open.keys()].map((index) => ({
    x: index % run.width,
    y: Math.floor(index / run.width),
  }));
  fill_cells(context, frame, visited, colour("visited"));
  fill_cells(context, frame, frontier_cells(run, known), colour("frontier"));
}

export function draw_path(context: Context, frame: MazeFrame, { path }: Known): void {
  context.strokeStyle = colour("trail");
  context.lineWidth = Math.max(1.5, frame.cell_px / 16);
  context.lineCap = "square";
  context.beginPath();
  const drawn = new Set<number>();
  for (let index = 1; index < path.length; index += 1) {
    const [from, to] = [path[index - 1] as Cell, path[index] as Cell];
    const key = (from.x + to.x) * 1000 + from.y + to.y; // the way back is drawn with the way there
    if (drawn.has(key)) continue;
    drawn.add(key);
    context.moveTo(...middle(frame, from));
    context.lineTo(...middle(frame, to));
  }
  context.stroke();
}

/** The vehicle as an arrow in the direction of its next move. */
export function draw_vehicle(context: Context, frame: MazeFrame, at: Cell, next: Side | ""): void {
  const size = frame.cell_px * 0.32;
  context.save();
  context.translate(...middle(frame, at));
  context.fillStyle = colour("accent");
  context.beginPath();
  if (next === "") context.arc(0, 0, size * 0.8, 0, 2 * Math.PI);
  else {
    context.rotate(turns[next]);
    context.moveTo(size, 0);
    context.lineTo(-size * 0.8, size * 0.75);
    context.lineTo(-size * 0.4, 0);
    context.lineTo(-size * 0.8, -size * 0.75);
  }
  context.fill();
  context.restore();
}

export function draw_cursor(context: Context, frame: MazeFrame, { x, y }: Cell): void {
  context.strokeStyle = colour("focus");
  context.lineWidth = 2;
  const [u, v] = corner(frame, x, y + 1);
  context.strokeRect(u + 4, v + 4, frame.cell_px - 8, frame.cell_px - 8);
}

/** A cell as the preprocessing unit passes it on: its walls, with the false ones dashed. */
export function draw_input(
  context: Context,
  size_px: number,
  open: string,
  false_walls: readonly Side[],
): void {
  const frame = { cell_px: size_px - 16, left_px: 8, bottom_px: size_px - 8 };
  const cell = { x: 0, y: 0 };
  context.clearRect(0, 0, size_px, size_px);
  context.lineCap = "round";
  for (const side of sides) {
    const is_false = false_walls.includes(side);
    if (open.includes(side) && !is_false) continue;
    context.strokeStyle = colour(is_false ? "path" : "wall");
    context.lineWidth = is_false ? 3 : 5;
    context.setLineDash(is_false ? [4, 5] : []);
    context.beginPath();
    edge(context, frame, cell, side);
    context.stroke();
  }
  context.setLineDash([]);
}
