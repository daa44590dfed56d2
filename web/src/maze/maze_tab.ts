import type { App, Tab } from "../page/app";
import { button, element, panel, select } from "../page/element";
import { UndoList } from "../page/undo_list";
import { download_text } from "../page/server_files";
import { Maze, max_size } from "./maze";
import { MazeCanvas } from "./maze_canvas";
import type { MazeTool } from "./maze_canvas";
import type { MazeRun } from "./maze_run";
import { maze_numbers, maze_picture, read_maze } from "./maze_text";
import { random_maze } from "./random_maze";
import { RunPlayer } from "./run_player";

const rule_sets = [
  { value: "published", label: "Published (C97)" },
  { value: "shortcut", label: "Shortcut" },
  { value: "cells", label: "Cells" },
  { value: "homing", label: "Homing" },
  { value: "roaming", label: "Roaming" },
];

const tools: { value: MazeTool; label: string }[] = [
  { value: "walls", label: "Walls" },
  { value: "start", label: "Start" },
  { value: "goals", label: "Goals" },
];

/** Draw a maze and watch how it is explored, cycle by cycle. */
export function maze_tab(app: App): Tab {
  const history = new UndoList<Maze>(random_maze(8, 8, 0.08, Math.random));
  const canvas = new MazeCanvas({
    wall: ({ cell, side }, is_closed, begins) =>
      change((maze) => maze.set_wall(cell, side, is_closed), begins),
    pick: (cell, tool) =>
      change((maze) => {
        if (tool === "start") maze.start = cell;
        else if (!maze.goals.delete(maze.index(cell))) maze.goals.add(maze.index(cell));
      }),
  });
  const player = new RunPlayer((count) => {
    canvas.count = count;
    canvas.redraw();
  });

  const show = (run?: MazeRun) => {
    canvas.maze = history.present;
    canvas.run = run;
    canvas.count = 0;
    undo.disabled = !history.can_undo;
    redo.disabled = !history.can_redo;
    player.load(run);
    canvas.redraw();
  };
  const change = (edit: (maze: Maze) => void, begins = true) => {
    const maze = history.present.copy();
    edit(maze);
    history.put(maze, begins);
    show();
  };

  let rules = "published";
  const explore = async () => {
    const maze = maze_picture(history.present);
    const called = app.connection.call<MazeRun>("maze/run", { maze, rules });
    if (!(await app.notices.attempt(called))) return;
    show(await called);
    player.play();
  };

  const size = (label: string) => {
    const input = element("input", { type: "number", min: 1, max: max_size, value: 8, class: "size" });
    input.setAttribute("aria-label", label);
    return input;
  };
  const [width, height] = [size("Width"), size("Height")];
  const wanted = (input: HTMLInputElement) =>
    Math.min(max_size, Math.max(1, Math.round(Number(input.value) || 1)));
  const begin = (make: (width: number, height: number) => Maze) => {
    history.put(make(wanted(width), wanted(height)));
    show();
  };

  const file = element("input", {
    type: "file",
    accept: ".txt,.num,.maz,text/plain",
    hidden: true,
    onchange: () => void app.notices.attempt(load(file.files?.[0]).finally(() => (file.value = ""))),
  });
  const load = async (chosen: File | undefined) => {
    if (!chosen) return;
    try {
      history.put(read_maze(await chosen.text()));
      show();
    } catch (problem) {
      throw new Error(`${chosen.name}: ${(problem as Error).message}`);
    }
  };

  const undo = button("Undo", () => {
    history.undo();
    show();
  });
  const redo = button("Redo", () => {
    history.redo();
    show();
  });
  const tool = select("Draw", tools, (value) => (canvas.tool = value as MazeTool));
  const rule_list = select("Rules", rule_sets, (value) => (rules = value));

  const tab = element(
    "div",
    { class: "tab maze-tab" },
    panel("Maze", "maze-panel", canvas.element),
    element(
      "div",
      { class: "maze-side" },
      panel(
        "Draw",
        "maze-draw",
        element("div", { class: "buttons line" }, tool.field, undo, redo),
        element(
          "div",
          { class: "buttons line" },
          width,
          "x",
          height,
          button("Empty", () => begin((w, h) => new Maze(w, h))),
          button("Random", () => begin((w, h) => random_maze(w, h, 0.08, Math.random))),
        ),
        element(
          "div",
          { class: "buttons line" },
          button("Load", () => file.click()),
          button("Save text", () => download_text("maze.txt", maze_picture(history.present))),
          button("Save num", () => download_text("maze.num", maze_numbers(history.present))),
          file,
        ),
      ),
      panel(
        "Explore",
        "maze-run",
        rule_list.field,
        element(
          "div",
          { class: "buttons" },
          button("Explore", () => void explore(), { class: "primary" }),
        ),
        player.element,
      ),
    ),
  );
  show();
  return { name: "maze", title: "Maze", element: tab };
}
