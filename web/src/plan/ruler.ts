import { length_text } from "../page/units";
import { colour } from "../page/theme";
import { text } from "../text";
import { draw_dots, draw_line, draw_name } from "./draw";
import { direction_deg, distance } from "./geometry";
import type { Point } from "./geometry";
import type { Layer, PlanTool } from "./plan_canvas";

/** Measures along the points that are clicked on a plan, and on to where the pointer is. */
export class Ruler implements PlanTool {
  readonly layer: Layer;
  #clicked: Point[] = [];
  #pointed: Point | undefined;

  constructor(private readonly changed: () => void) {
    this.layer = (context, view) => {
      const points = this.#points();
      draw_line(context, view, points, { colour: colour("accent"), width_px: 2 });
      draw_dots(context, view, this.#clicked, colour("accent"), 4);
      points.slice(1).forEach((to, index) => {
        const from = points[index] as Point;
        const middle = { x: (from.x + to.x) / 2, y: (from.y + to.y) / 2 };
        draw_name(context, view, middle, length_text(distance(from, to), 2));
      });
    };
  }

  click(at: Point): void {
    this.#clicked.push(at);
    this.#pointed = undefined;
    this.changed();
  }

  hover(at: Point | undefined): void {
    this.#pointed = at;
    this.changed();
  }

  take_back(): void {
    this.#clicked.pop();
    this.changed();
  }

  clear(): void {
    this.#clicked = [];
    this.#pointed = undefined;
    this.changed();
  }

  /** Length and direction of the last piece, and the length of all. */
  text(): string {
    const points = this.#points();
    const [from, to] = points.slice(-2);
    if (!from || !to) return text.plan.measure_how;
    const all_m = points.slice(1).reduce((sum, at, index) => sum + distance(at, points[index] as Point), 0);
    const piece = `${length_text(distance(from, to), 2)}, ${direction_deg(from, to)}°`;
    return points.length > 2 ? `${piece} · ${text.plan.measured(length_text(all_m, 2))}` : piece;
  }

  #points(): Point[] {
    return this.#pointed && this.#clicked.length > 0 ? [...this.#clicked, this.#pointed] : this.#clicked;
  }
}
