import type { Bounds, Point } from "./geometry";

/** The transform from the map to the screen: x to the right, y up, `scale_px_per_m` pixels per metre. */
export class PlanView {
  middle: Point = { x: 0, y: 0 };
  scale_px_per_m = 40;
  width_px = 1;
  height_px = 1;

  to_screen({ x, y }: Point): Point {
    return {
      x: this.width_px / 2 + (x - this.middle.x) * this.scale_px_per_m,
      y: this.height_px / 2 - (y - this.middle.y) * this.scale_px_per_m,
    };
  }

  to_map({ x, y }: Point): Point {
    return {
      x: this.middle.x + (x - this.width_px / 2) / this.scale_px_per_m,
      y: this.middle.y - (y - this.height_px / 2) / this.scale_px_per_m,
    };
  }

  pan_px(right: number, down: number): void {
    this.middle = {
      x: this.middle.x - right / this.scale_px_per_m,
      y: this.middle.y + down / this.scale_px_per_m,
    };
  }

  /** Zooms about the screen position `at`, which stays fixed. */
  zoom(factor: number, at: Point): void {
    const fixed = this.to_map(at);
    this.scale_px_per_m = Math.min(2000, Math.max(0.5, this.scale_px_per_m * factor));
    const moved = this.to_map(at);
    this.middle = { x: this.middle.x + fixed.x - moved.x, y: this.middle.y + fixed.y - moved.y };
  }

  /** @param left_px of the screen's left side that something else covers */
  fit({ low, high }: Bounds, left_px = 0, margin_px = 32): void {
    const scale_for = (size_px: number, size_m: number) =>
      Math.max(1, size_px - 2 * margin_px) / Math.max(1, size_m);
    this.scale_px_per_m = Math.min(
      200,
      scale_for(this.width_px - left_px, high.x - low.x),
      scale_for(this.height_px, high.y - low.y),
    );
    const shift_m = left_px / 2 / this.scale_px_per_m;
    this.middle = { x: (low.x + high.x) / 2 - shift_m, y: (low.y + high.y) / 2 };
  }
}

/** A round length of at most `wanted_px` on the screen: 1, 2 or 5 times a power of ten, in the unit of the scale. */
export function round_length(px_per_unit: number, wanted_px: number): number {
  const wanted = wanted_px / px_per_unit;
  const power = 10 ** Math.floor(Math.log10(wanted));
  const step = [1, 2, 5].findLast((candidate) => candidate * power <= wanted) ?? 1;
  return step * power;
}
