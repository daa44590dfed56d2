/** Mazes as text: the picture and the `num` format of docs/formats/maze.md. */

import { Maze, max_size, sides } from "./maze";
import type { Cell } from "./maze";

const horizontal_wall = /[-_=#]/;
const vertical_wall = /[|!#]/;

function check_size(width: number, height: number): void {
  if (width < 1 || height < 1) throw new Error("the maze has no cells");
  if (width > max_size || height > max_size)
    throw new Error(`at most ${max_size} x ${max_size} cells can be shown`);
}

function read_picture(text: string): Maze {
  const lines = text.replace(/\r/g, "").trimEnd().split("\n");
  const width = Math.round((Math.max(...lines.map((line) => line.length)) - 1) / 4);
  const height = (lines.length - 1) / 2;
  if (!Number.isInteger(height)) throw new Error(`line ${lines.length}: the number of lines must be odd`);
  check_size(width, height);
  const maze = new Maze(width, height);
  const at = (line: number, column: number) => lines[line]?.[column] ?? " ";
  for (const cell of maze.cells()) {
    const line = 2 * (height - 1 - cell.y) + 1;
    const column = 4 * cell.x + 2;
    maze.set_wall(cell, "N", horizontal_wall.test(at(line - 1, column)));
    maze.set_wall(cell, "E", vertical_wall.test(at(line, column + 2)));
    if (at(line, column) === "S") maze.start = cell;
    if (at(line, column) === "G") maze.goals.add(maze.index(cell));
  }
  return maze;
}

function read_numbers(text: string): Maze {
  const rows = text.trim().split(/\s*\n\s*/);
  const numbers = rows.map((row, index) => {
    const values = row.split(/\s+/).map(Number);
    if (values.length !== 6 || values.some((value) => !Number.isInteger(value) || value < 0)) {
      throw new Error(`line ${index + 1}: must be: x y north east south west`);
    }
    return values as [number, number, number, number, number, number];
  });
  const width = Math.max(...numbers.map(([x]) => x)) + 1;
  const height = Math.max(...numbers.map(([, y]) => y)) + 1;
  check_size(width, height);
  if (numbers.length !== width * height)
    throw new Error(`${width * height} cells are needed, ${numbers.length} are given`);
  const maze = new Maze(width, height);
  for (const [x, y, ...walls] of numbers) {
    sides.forEach((side, index) => maze.set_wall({ x, y }, side, walls[index] === 1));
  }
  return maze;
}

/** @throws Error that names the line that cannot be read */
export function read_maze(text: string): Maze {
  return /^\s*\d/.test(text) ? read_numbers(text) : read_picture(text);
}

function middle_of(maze: Maze, cell: Cell): string {
  if (cell.x === maze.start.x && cell.y === maze.start.y) return "S";
  return maze.goals.has(maze.index(cell)) ? "G" : " ";
}

export function maze_picture(maze: Maze): string {
  const lines: string[] = [];
  const columns = [...Array(maze.width).keys()];
  for (let y = maze.height - 1; y >= 0; y -= 1) {
    lines.push(columns.map((x) => (maze.has_wall({ x, y }, "N") ? "o---" : "o   ")).join("") + "o");
    const cells = columns.map(
      (x) => ` ${middle_of(maze, { x, y })} ${maze.has_wall({ x, y }, "E") ? "|" : " "}`,
    );
    lines.push("|" + cells.join(""));
  }
  lines.push("o---".repeat(maze.width) + "o");
  return lines.join("\n") + "\n";
}

export function maze_numbers(maze: Maze): string {
  const line = (cell: Cell) =>
    [cell.x, cell.y, ...sides.map((side) => Number(maze.has_wall(cell, side)))].join(" ") + "\n";
  return [...maze.cells()].map(line).join("");
}
