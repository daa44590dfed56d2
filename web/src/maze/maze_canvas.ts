import { element } from "../page/element";
import { text } from "../text";
import { Sheet } from "../page/sheet";
import { edge_at, cell_at } from "./maze_picking";
import type { Edge } from "./maze_picking";
import {
  draw_cursor,
  draw_grid,
  draw_known,
  draw_vehicle,
  draw_start_and_goals,
  draw_walls,
  draw_path,
  frame_of,
} from "./maze_drawing";
import { Maze, neighbour } from "./maze";
import type { Cell, Side } from "./maze";
import { known_after } from "./maze_run";
import type { MazeRun } from "./maze_run";

export type MazeTool = "walls" | "start" | "goals";

const key_sides: Record<string, Side> = { ArrowUp: "N", ArrowRight: "E", ArrowDown: "S", ArrowLeft: "W" };

interface Actions {
  /** Add or remove a wall; `begins`: the first wall of a stroke. */
  wall(edge: Edge, is_closed: boolean, begins: boolean): void;
  pick(cell: Cell, tool: MazeTool): void;
}

/** The maze on a canvas: the user edits it there and watches how it is explored. */
export class MazeCanvas {
  readonly element: HTMLCanvasElement;
  tool: MazeTool = "walls";
  maze = new Maze(8, 8);
  run: MazeRun | undefined;
  /** Cycles of the run that are shown. */
  count = 0;

  #cursor: Cell = { x: 0, y: 0 };
  #drawing: boolean | undefined;
  /** The last point of the stroke. */
  #last: { u: number; v: number } | undefined;
  readonly #sheet: Sheet;

  constructor(private readonly actions: Actions) {
    this.element = element("canvas", {
      class: "maze-canvas",
      tabindex: 0,
      "data-arrows": "",
      role: "application",
    });
    this.element.setAttribute("aria-label", text.maze.canvas);
    this.element.addEventListener("pointerdown", (event) => this.#press(event));
    this.element.addEventListener("pointermove", (event) => this.#move(event));
    for (const end of ["pointerup", "pointercancel"]) {
      this.element.addEventListener(end, () => (this.#drawing = undefined));
    }
    this.element.addEventListener("keydown", (event) => this.#key(event));
    for (const change of ["focus", "blur"]) this.element.addEventListener(change, () => this.redraw());
    this.#sheet = new Sheet(this.element, (context) => this.#draw(context));
  }

  redraw(): void {
    this.#sheet.redraw();
  }

  #frame() {
    return frame_of(this.maze, this.#sheet.width_px, this.#sheet.height_px);
  }

  #draw(context: CanvasRenderingContext2D): void {
    const frame = this.#frame();
    const known = this.run && this.count > 0 ? known_after(this.run, this.count) : undefined;
    if (this.run && known) draw_known(context, frame, this.run, known);
    draw_grid(context, frame, this.maze);
    draw_start_and_goals(context, frame, this.maze);
    if (known) draw_path(context, frame, known);
    draw_walls(context, frame, this.maze, known);
    if (known) draw_vehicle(context, frame, known.at, this.run?.steps[this.count - 1]?.move ?? "");
    if (document.activeElement === this.element) draw_cursor(context, frame, this.#cursor);
  }

  #press(event: PointerEvent): void {
    this.element.setPointerCapture(event.pointerId);
    const cell = cell_at(this.maze, this.#frame(), event.offsetX, event.offsetY);
    if (cell) this.#cursor = cell;
    if (this.tool !== "walls") {
      if (cell) this.actions.pick(cell, this.tool);
      return;
    }
    const edge = edge_at(this.maze, this.#frame(), event.offsetX, event.offsetY);
    if (!edge) return;
    this.#last = { u: event.offsetX, v: event.offsetY };
    this.#drawing = !this.maze.has_wall(edge.cell, edge.side);
    this.actions.wall(edge, this.#drawing, true);
  }

  #move(event: PointerEvent): void {
    if (this.#drawing === undefined) return;
    const to = { u: event.offsetX, v: event.offsetY };
    const from = this.#last ?? to;
    this.#last = to;
    const frame = this.#frame();
    const steps = Math.ceil((4 * Math.hypot(to.u - from.u, to.v - from.v)) / frame.cell_px) || 1;
    for (let step = 1; step <= steps; step += 1) {
      const [u, v] = [from.u + ((to.u - from.u) * step) / steps, from.v + ((to.v - from.v) * step) / steps];
      const edge = edge_at(this.maze, frame, u, v, true);
      if (edge && this.maze.has_wall(edge.cell, edge.side) !== this.#drawing)
        this.actions.wall(edge, this.#drawing, false);
    }
  }

  #key(event: KeyboardEvent): void {
    const side = key_sides[event.key];
    const letter = event.key.toLowerCase();
    if (side && event.shiftKey) {
      this.actions.wall({ cell: this.#cursor, side }, !this.maze.has_wall(this.#cursor, side), true);
    } else if (side) {
      const next = neighbour(this.#cursor, side);
      if (this.maze.contains(next)) this.#cursor = next;
    } else if (letter === "s" && !event.ctrlKey) this.actions.pick(this.#cursor, "start");
    else if (letter === "g" && !event.ctrlKey) this.actions.pick(this.#cursor, "goals");
    else return;
    event.preventDefault();
    this.redraw();
  }
}
