import { Maze, neighbour, sides } from "./maze";
import type { Cell } from "./maze";

/**
 * A maze in which every cell is reachable: a random depth-first walk removes walls.
 * @param loops share of the remaining walls that are removed as well, which makes loops
 * @param random as Math.random
 */
export function random_maze(width: number, height: number, loops: number, random: () => number): Maze {
  const maze = new Maze(width, height);
  for (const cell of maze.cells()) for (const side of sides) maze.set_wall(cell, side, true);

  const visited = new Set([0]);
  const path: Cell[] = [maze.start];
  for (let at = path.at(-1); at; at = path.at(-1)) {
    const here = at;
    const fresh = sides.filter((side) => {
      const beyond = neighbour(here, side);
      return maze.contains(beyond) && !visited.has(maze.index(beyond));
    });
    const side = fresh[Math.floor(random() * fresh.length)];
    if (side === undefined) {
      path.pop();
      continue;
    }
    maze.set_wall(here, side, false);
    visited.add(maze.index(neighbour(here, side)));
    path.push(neighbour(here, side));
  }
  for (const cell of maze.cells()) {
    for (const side of ["N", "E"] as const) if (random() < loops) maze.set_wall(cell, side, false);
  }
  return maze;
}
