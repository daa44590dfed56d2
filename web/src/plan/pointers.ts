import { distance } from "./geometry";
import type { Point } from "./geometry";

const click_within_px = 6;

/** Gestures of mouse and touch on a canvas, in its pixels. */
export interface PointerActions {
  pan(right: number, down: number): void;
  zoom(factor: number, at: Point): void;
  click(at: Point): void;
  /** @returns false: the drag is not handled, so it pans */
  drag(from: Point, to: Point, ended: boolean): boolean;
}

export function watch_pointers(canvas: HTMLCanvasElement, actions: PointerActions): void {
  const down = new Map<number, Point>();
  let began: Point | undefined;
  let moved = false;

  const place = (event: MouseEvent): Point => {
    const box = canvas.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  };
  const pinch = (id: number, to: Point) => {
    const from = down.get(id);
    const other = [...down].find(([key]) => key !== id)?.[1];
    if (from && other) actions.zoom(distance(to, other) / Math.max(1, distance(from, other)), other);
  };

  canvas.addEventListener("pointerdown", (event) => {
    canvas.setPointerCapture(event.pointerId);
    down.set(event.pointerId, place(event));
    if (down.size === 1) began = place(event);
    moved = down.size > 1;
  });
  canvas.addEventListener("pointermove", (event) => {
    const from = down.get(event.pointerId);
    if (!from) return;
    const to = place(event);
    if (down.size > 1) pinch(event.pointerId, to);
    else if (began && (moved || distance(began, to) > click_within_px)) {
      moved = true;
      if (!actions.drag(began, to, false)) actions.pan(to.x - from.x, to.y - from.y);
    } else return;
    down.set(event.pointerId, to);
  });
  canvas.addEventListener("pointerup", (event) => {
    if (!down.delete(event.pointerId) || down.size > 0 || !began) return;
    if (moved) actions.drag(began, place(event), true);
    else actions.click(place(event));
    began = undefined;
  });
  canvas.addEventListener("pointercancel", (event) => {
    down.delete(event.pointerId);
    began = undefined;
  });
  canvas.addEventListener(
    "wheel",
    (event) => {
      event.preventDefault();
      actions.zoom(Math.exp(-event.deltaY * (event.deltaMode === 0 ? 0.0015 : 0.05)), place(event));
    },
    { passive: false },
  );
}
