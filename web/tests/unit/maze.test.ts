import assert from "node:assert/strict";
import { test } from "node:test";

import { Maze, neighbour, sides } from "../../src/maze/maze";
import { cell_at, edge_at } from "../../src/maze/maze_picking";
import { false_walls, known_after, frontier_cells } from "../../src/maze/maze_run";
import type { MazeRun, MazeStep } from "../../src/maze/maze_run";
import { maze_numbers, maze_picture, read_maze } from "../../src/maze/maze_text";
import { random_maze } from "../../src/maze/random_maze";

// The example in docs/formats/maze.md.
const picture = `o---o---o
| S |   |
o   o---o
|     G |
o---o---o
`;

test("The documented picture is read, and writing it gives the same text", () => {
  const maze = read_maze(picture);
  assert.deepEqual([maze.width, maze.height], [2, 2]);
  assert.deepEqual(maze.start, { x: 0, y: 1 });
  assert.ok(maze.goals.has(maze.index({ x: 1, y: 0 })));
  assert.ok(maze.has_wall({ x: 0, y: 1 }, "E"));
  assert.ok(!maze.has_wall({ x: 0, y: 1 }, "S"));
  assert.equal(maze_picture(maze), picture);
});

test("The documented numbers are read: north, east, south, west", () => {
  const maze = read_maze("0 0 0 0 1 1\n0 1 1 1 0 1\n1 0 1 1 1 0\n1 1 1 1 1 1\n");
  assert.ok(!maze.has_wall({ x: 0, y: 0 }, "N"));
  assert.ok(!maze.has_wall({ x: 0, y: 0 }, "E"));
  assert.ok(maze.has_wall({ x: 1, y: 1 }, "S"));
});

test("Any maze survives writing and reading, as a picture and as numbers", () => {
  for (let seed = 1; seed < 40; seed += 1) {
    const maze = random_maze(1 + (seed % 7), 1 + (seed % 5), 0.2, repeatable(seed));
    assert.equal(maze_picture(read_maze(maze_picture(maze))), maze_picture(maze));
    assert.equal(maze_numbers(read_maze(maze_numbers(maze))), maze_numbers(maze));
  }
});

test("A text that is not a maze is refused with the reason", () => {
  assert.throws(() => read_maze("o---o\n|   |\n"), /number of lines must be odd/);
  assert.throws(() => read_maze("0 0 1 1\n"), /line 1/);
  assert.throws(() => read_maze("0 0 1 1 1 1\n5 0 1 1 1 1\n"), /6 cells are needed, 2 are given/);
  assert.throws(() => read_maze(`o${"---o".repeat(65)}\n|\no${"---o".repeat(65)}\n`), /at most 64/);
});

test("Every cell of a random maze is reachable", () => {
  const maze = random_maze(9, 6, 0, repeatable(3));
  const reached = new Set([0]);
  const queue = [{ x: 0, y: 0 }];
  for (let at = queue.pop(); at; at = queue.pop()) {
    for (const side of sides) {
      const beyond = neighbour(at, side);
      if (maze.has_wall(at, side) || reached.has(maze.index(beyond))) continue;
      reached.add(maze.index(beyond));
      queue.push(beyond);
    }
  }
  assert.equal(reached.size, 54);
});

test("A click near an edge picks it; a click in the middle of a cell picks none", () => {
  const maze = new Maze(3, 2);
  const frame = { cell_px: 20, left_px: 100, bottom_px: 200 };
  assert.deepEqual(edge_at(maze, frame, 138, 190), { cell: { x: 1, y: 0 }, side: "E" });
  assert.deepEqual(edge_at(maze, frame, 130, 163), { cell: { x: 1, y: 1 }, side: "N" });
  assert.equal(edge_at(maze, frame, 130, 190), undefined);
  assert.equal(cell_at(maze, frame, 99, 190), undefined);
});

test("The outer walls cannot be removed", () => {
  const maze = new Maze(2, 2);
  maze.set_wall({ x: 0, y: 0 }, "W", false);
  assert.ok(maze.has_wall({ x: 0, y: 0 }, "W"));
});

test("After two cycles the vehicle knows two cells and the frontier beyond", () => {
  const step = {
    input: "G1",
    input_kind: "one-way",
    input_open: "E",
    rule: "",
    state: "exploring",
    stack: ["Z_0"],
  };
  const run: MazeRun = {
    width: 3,
    height: 1,
    start: [0, 0],
    rules: "published",
    steps: [
      { ...step, cell: [0, 0], open: "E", move: "E" },
      { ...step, cell: [1, 0], open: "EW", move: "E" },
      { ...step, cell: [2, 0], open: "W", move: "W" },
    ],
    figures: { reachable: 3, visited: 3, moves: 4, complete: true },
  };
  const known = known_after(run, 2);
  assert.deepEqual(known.at, { x: 1, y: 0 });
  assert.equal(known.came_from, "W");
  assert.deepEqual(frontier_cells(run, known), [{ x: 2, y: 0 }]);
  assert.deepEqual(false_walls(run.steps[1] as MazeStep, known.came_from), ["W"]);
});

/** A pseudo-random generator with a fixed seed: the same numbers in every run. */
function repeatable(seed: number): () => number {
  let state = seed;
  return () => {
    state = (state * 1103515245 + 12345) % 2 ** 31;
    return state / 2 ** 31;
  };
}
