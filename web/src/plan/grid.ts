import { colour } from "../page/theme";
import { metres_per_unit } from "../page/units";
import { draw_caption, draw_segments } from "./draw";
import type { Point } from "./geometry";
import { round_length } from "./plan_view";
import type { PlanView } from "./plan_view";

const apart_px = 90;
/** The scale bar is in this part of the lower edge. */
const scale_bar_px = 120;

export interface GridLine {
  at_m: number;
  /** In the user's unit. */
  label: string;
}

/** The grid's lines between two coordinates, a round number of the user's unit apart. */
export function grid_lines(from_m: number, to_m: number, scale_px_per_m: number): GridLine[] {
  const unit_m = metres_per_unit();
  const step = round_length(scale_px_per_m * unit_m, apart_px);
  const digits = Math.max(0, -Math.floor(Math.log10(step)));
  const first = Math.ceil(from_m / unit_m / step);
  const count = Math.max(0, Math.floor(to_m / unit_m / step) - first + 1);
  return Array.from({ length: count }, (_, index) => {
    const at = (first + index) * step;
    return { at_m: at * unit_m, label: at.toFixed(digits) };
  });
}

/** Lines of round coordinates; those through the origin are stronger. */
export function draw_grid(context: CanvasRenderingContext2D, view: PlanView): void {
  const { width_px, height_px, scale_px_per_m } = view;
  const low = view.to_map({ x: 0, y: height_px });
  const high = view.to_map({ x: width_px, y: 0 });
  const across = grid_lines(low.x, high.x, scale_px_per_m);
  const up = grid_lines(low.y, high.y, scale_px_per_m);
  const segments = [
    ...across.map(({ at_m }): [Point, Point] => [
      { x: at_m, y: low.y },
      { x: at_m, y: high.y },
    ]),
    ...up.map(({ at_m }): [Point, Point] => [
      { x: low.x, y: at_m },
      { x: high.x, y: at_m },
    ]),
  ];
  const is_axis = ([from, to]: [Point, Point]) =>
    (from.x === 0 && to.x === 0) || (from.y === 0 && to.y === 0);
  context.globalAlpha = 0.45;
  draw_segments(context, view, segments, { colour: colour("muted"), width_px: 0.5 });
  draw_segments(context, view, segments.filter(is_axis), { colour: colour("muted"), width_px: 1.5 });
  context.globalAlpha = 1;
  for (const { at_m, label } of across) {
    const { x } = view.to_screen({ x: at_m, y: 0 });
    if (x > scale_bar_px) draw_caption(context, { x: x + 3, y: height_px - 8 }, label);
  }
  for (const { at_m, label } of up) {
    const { y } = view.to_screen({ x: 0, y: at_m });
    if (y < height_px - 30) draw_caption(context, { x: 4, y: y - 7 }, label);
  }
}
