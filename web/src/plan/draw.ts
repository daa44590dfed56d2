/** Draws lines, dots and names on a plan, in map coordinates [m]. */

import { colour } from "../page/theme";
import { metres_per_unit, unit } from "../page/units";
import { moved_by } from "./geometry";
import type { Ellipse, Point, Pose } from "./geometry";
import { round_length } from "./plan_view";
import type { PlanView } from "./plan_view";

type Context = CanvasRenderingContext2D;

export interface Stroke {
  colour: string;
  width_px: number;
  dash_px?: number[];
}

/** The stroke of a barrier; `kind` as in a building file. */
export function barrier_stroke(kind: string): Stroke {
  return kind === "glass"
    ? { colour: colour("glass"), width_px: 4 }
    : { colour: colour("trouble"), width_px: 3, dash_px: [8, 6] };
}

/** The stroke of a zone's outline; `kind` as in a building file. */
export function zone_stroke(kind: string): Stroke {
  if (kind === "keep_out") return barrier_stroke(kind);
  return { colour: colour("busy"), width_px: 2, dash_px: kind === "slow" ? [2, 4] : [] };
}

export function apply_stroke(context: Context, stroke: Stroke): void {
  context.strokeStyle = stroke.colour;
  context.lineWidth = stroke.width_px;
  context.lineCap = "round";
  context.lineJoin = "round";
  context.setLineDash(stroke.dash_px ?? []);
}

export function trace(context: Context, view: PlanView, points: readonly Point[], is_closed = false): void {
  points.forEach((point, index) => {
    const { x, y } = view.to_screen(point);
    if (index === 0) context.moveTo(x, y);
    else context.lineTo(x, y);
  });
  if (is_closed) context.closePath();
}

export function draw_line(context: Context, view: PlanView, points: readonly Point[], stroke: Stroke): void {
  apply_stroke(context, stroke);
  context.beginPath();
  trace(context, view, points);
  context.stroke();
}

export function draw_segments(
  context: Context,
  view: PlanView,
  segments: Iterable<[Point, Point]>,
  stroke: Stroke,
): void {
  apply_stroke(context, stroke);
  context.beginPath();
  for (const segment of segments) trace(context, view, segment);
  context.stroke();
}

export const area_opacity = 0.1;

/** An area, softly: what is under it stays legible. @param outlines  closed; those of holes are among them */
export function draw_area(context: Context, view: PlanView, outlines: Point[][], fill: string): void {
  context.save();
  context.beginPath();
  for (const outline of outlines) trace(context, view, outline, true);
  context.globalAlpha = area_opacity;
  context.fillStyle = fill;
  context.fill("evenodd");
  context.globalAlpha = 0.45;
  apply_stroke(context, { colour: fill, width_px: 1.5 });
  context.stroke();
  context.restore();
}

export function draw_dots(
  context: Context,
  view: PlanView,
  points: Iterable<Point>,
  fill: string,
  radius_px: number,
): void {
  context.fillStyle = fill;
  context.beginPath();
  for (const point of points) {
    const { x, y } = view.to_screen(point);
    context.moveTo(x + radius_px, y);
    context.arc(x, y, radius_px, 0, 2 * Math.PI);
  }
  context.fill();
}

/** Words at a position of the screen, legible on any background. */
export function draw_caption(context: Context, { x, y }: Point, words: string): void {
  context.font = "12px system-ui, sans-serif";
  context.textBaseline = "middle";
  context.lineWidth = 3;
  context.lineJoin = "round";
  context.setLineDash([]);
  context.strokeStyle = colour("sheet");
  context.strokeText(words, x, y);
  context.fillStyle = colour("ink");
  context.fillText(words, x, y);
}

/** A name beside a point. */
export function draw_name(context: Context, view: PlanView, at: Point, name: string): void {
  const { x, y } = view.to_screen(at);
  draw_caption(context, { x: x + 8, y: y - 8 }, name);
}

const arrow_px = 34;

/**
 * A goal with its number, and an arrow where the vehicle is to face there.
 * @param drawn_px  how long the arrow is being drawn; it is not shorter than others
 */
export function draw_goal(
  context: Context,
  view: PlanView,
  goal: Point & { heading_deg?: number },
  number: string,
  drawn_px = 0,
): void {
  const at = view.to_screen(goal);
  const length_px = Math.max(arrow_px, drawn_px);
  if (goal.heading_deg !== undefined) {
    const heading_rad = (goal.heading_deg * Math.PI) / 180;
    const pose: Pose = { ...goal, heading_rad };
    const along = (ahead_px: number, left_px: number) =>
      moved_by(pose, { x: ahead_px / view.scale_px_per_m, y: left_px / view.scale_px_per_m });
    const arrow = [along(0, 0), along(length_px, 0)];
    const head = [along(length_px - 9, 7), along(length_px, 0), along(length_px - 9, -7)];
    for (const line of [arrow, head]) draw_line(context, view, line, { colour: colour("path"), width_px: 3 });
  }
  draw_dots(context, view, [goal], colour("path"), number === "" ? 7 : 10);
  context.font = "bold 12px system-ui, sans-serif";
  context.textAlign = "center";
  context.textBaseline = "middle";
  context.fillStyle = colour("sheet");
  context.fillText(number, at.x, at.y + 1);
  context.textAlign = "start";
}

/** Strokes the traced outline in the vehicle's colour and fills it faintly. */
function draw_tinted(context: Context, { opacity, width_px }: { opacity: number; width_px: number }): void {
  context.globalAlpha = opacity;
  context.fillStyle = colour("accent");
  context.fill();
  context.globalAlpha = 1;
  apply_stroke(context, { colour: colour("accent"), width_px });
  context.stroke();
}

export function draw_ellipse(context: Context, view: PlanView, at: Point, ellipse: Ellipse): void {
  const { x, y } = view.to_screen(at);
  context.beginPath();
  context.ellipse(
    x,
    y,
    ellipse.a_m * view.scale_px_per_m,
    ellipse.b_m * view.scale_px_per_m,
    -ellipse.heading_rad,
    0,
    2 * Math.PI,
  );
  draw_tinted(context, { opacity: 0.2, width_px: 1 });
}

/** The vehicle from above: its outline, and an arrow that stays visible however small the scale is. */
export function draw_vehicle(
  context: Context,
  view: PlanView,
  pose: Pose,
  size: { front_m: number; rear_m: number; width_m: number },
): void {
  const { front_m, rear_m, width_m } = size;
  const corners = [
    { x: front_m, y: width_m / 2 },
    { x: -rear_m, y: width_m / 2 },
    { x: -rear_m, y: -width_m / 2 },
    { x: front_m, y: -width_m / 2 },
  ].map((corner) => moved_by(pose, corner));
  context.beginPath();
  trace(context, view, corners, true);
  draw_tinted(context, { opacity: 0.25, width_px: 1.5 });

  const unit = Math.max(11 / view.scale_px_per_m, Math.min(front_m, width_m) * 0.5);
  const arrow = [
    { x: unit, y: 0 },
    { x: -0.7 * unit, y: 0.6 * unit },
    { x: -0.35 * unit, y: 0 },
    { x: -0.7 * unit, y: -0.6 * unit },
  ].map((corner) => moved_by(pose, corner));
  context.beginPath();
  trace(context, view, arrow, true);
  context.fillStyle = colour("accent");
  context.fill();
}

/** A ring about a point that the user looks at. */
export function draw_ring(context: Context, view: PlanView, at: Point): void {
  const { x, y } = view.to_screen(at);
  apply_stroke(context, { colour: colour("trouble"), width_px: 2.5 });
  context.beginPath();
  context.arc(x, y, 10, 0, 2 * Math.PI);
  context.stroke();
}

/** Cross hairs, where the keys point to. */
export function draw_cross(context: Context, view: PlanView, at: Point): void {
  const { x, y } = view.to_screen(at);
  apply_stroke(context, { colour: colour("accent"), width_px: 1 });
  context.beginPath();
  context.moveTo(x - 10, y);
  context.lineTo(x + 10, y);
  context.moveTo(x, y - 10);
  context.lineTo(x, y + 10);
  context.stroke();
}

/** The scale bar, of a round length, in the lower left corner. */
export function draw_scale(context: Context, view: PlanView): void {
  const px_per_unit = view.scale_px_per_m * metres_per_unit();
  const length = round_length(px_per_unit, 90);
  const length_px = length * px_per_unit;
  const y = view.height_px - 14;
  apply_stroke(context, { colour: colour("muted"), width_px: 1.5 });
  context.beginPath();
  context.moveTo(14, y - 4);
  context.lineTo(14, y);
  context.lineTo(14 + length_px, y);
  context.lineTo(14 + length_px, y - 4);
  context.stroke();
  context.font = "11px system-ui, sans-serif";
  context.textBaseline = "alphabetic";
  context.fillStyle = colour("muted");
  const is_in_cm = unit.value === "m" && length < 1;
  context.fillText(is_in_cm ? `${Math.round(length * 100)} cm` : `${length} ${unit.value}`, 18, y - 5);
}
