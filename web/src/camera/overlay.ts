import { colour } from "../page/theme";

/** What the navigator detected in an image: the JSON of /overlay/CAMERA, in pixels. */
export interface Overlay {
  stamp_s: number;
  lines: { kind: string; u0: number; v0: number; u1: number; v1: number }[];
}

/** An overlay that differs more than this from the image's stamp belongs to another view. */
const same_view_s = 0.35;

export function kinds_of({ lines }: Overlay): string[] {
  return [...new Set(lines.map(({ kind }) => kind))];
}

/** Name of the colour for lines of a kind; `foot` marks a floor point. */
export function colour_of(kind: string): string {
  const named = ["vertical", "foot", "stripe", "region", "base", "scan"].find((name) =>
    kind.startsWith(name),
  );
  return `line-${named ?? "other"}`;
}

export function draw_overlay(
  context: CanvasRenderingContext2D,
  { stamp_s, lines }: Overlay,
  image_s: number,
  hidden: ReadonlySet<string>,
): void {
  if (Math.abs(stamp_s - image_s) > same_view_s) return;
  context.lineWidth = Math.max(1.5, context.canvas.width / 320);
  context.lineCap = "round";
  for (const { kind, u0, v0, u1, v1 } of lines) {
    if (hidden.has(kind)) continue;
    context.strokeStyle = colour(colour_of(kind));
    context.beginPath();
    // Integer coordinates are pixel centres; a canvas counts from pixel corners.
    context.moveTo(u0 + 0.5, v0 + 0.5);
    context.lineTo(u1 + 0.5, v1 + 0.5);
    context.stroke();
  }
}
