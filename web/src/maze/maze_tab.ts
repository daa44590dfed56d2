import type { App, Tab } from "../page/app";
import { button, element, panel, select } from "../page/element";
import { text } from "../text";
import { UndoList } from "../page/undo_list";
import { download_text } from "../page/server_files";
import { Maze, max_size } from "./maze";
import { MazeCanvas } from "./maze_canvas";
import type { MazeTool } from "./maze_canvas";
import type { MazeRun } from "./maze_run";
import { maze_numbers, maze_picture, read_maze } from "./maze_text";
import { random_maze } from "./random_maze";
import { RunPlayer } from "./run_player";

const choices = (words: Record<string, string>) =>
  Object.entries(words).map(([value, label]) => ({ value, label }));

/** Draw a maze and watch how it is explored, cycle by cycle. */
export function maze_tab(app: App): Tab {
  const words = text.maze;
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
  const [width, height] = [size(words.width), size(words.height)];
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

  const undo = button(text.building.undo, () => {
    history.undo();
    show();
  });
  const redo = button(text.building.redo, () => {
    history.redo();
    show();
  });
  const tool = select(words.draw, choices(words.tools), (value) => (canvas.tool = value as MazeTool));
  const rule_list = select(words.rules, choices(words.rule_sets), (value) => (rules = value));

  const tab = element(
    "div",
    { class: "tab maze-tab" },
    panel(words.title, "maze-panel", canvas.element),
    element(
      "div",
      { class: "maze-side" },
      panel(
        words.draw,
        "maze-draw",
        element("div", { class: "buttons line" }, tool.field, undo, redo),
        element(
          "div",
          { class: "buttons line" },
          width,
          "x",
          height,
          button(words.empty, () => begin((w, h) => new Maze(w, h))),
          button(words.random, () => begin((w, h) => random_maze(w, h, 0.08, Math.random))),
        ),
        element(
          "div",
          { class: "buttons line" },
          button(words.load, () => file.click()),
          button(words.save_text, () => download_text("maze.txt", maze_picture(history.present))),
          button(words.save_numbers, () => download_text("maze.num", maze_numbers(history.present))),
          file,
        ),
      ),
      panel(
        words.explore,
        "maze-run",
        rule_list.field,
        element(
          "div",
          { class: "buttons" },
          button(words.explore, () => void explore(), { class: "primary" }),
        ),
        player.element,
      ),
    ),
  );
  show();
  return { name: "maze", title: text.tabs.maze, element: tab };
}
