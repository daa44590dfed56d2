import { distance } from "./geometry";
import type { Point } from "./geometry";

const click_within_px = 6;

/** Gestures of mouse and touch on a canvas, in its pixels. */
export interface PointerActions {
  pan(right: number, down: number): void;
  zoom(factor: number, at: Point): void;
  /** @param adds  Shift is held */
  click(at: Point, adds: boolean): void;
  /** The mouse moves without a button; undefined: it leaves. */
  hover(at: Point | undefined): void;
  /** @returns false: the drag is not handled, so it pans until it ends */
  drag(from: Point, to: Point, ended: boolean, adds: boolean): boolean;
  /** The drag became a gesture of two fingers: it did not happen. */
  cancel_drag(): void;
}

function middle(points: Point[]): Point {
  const [a, b] = points as [Point, Point];
  return { x: (a.x + b.x) / 2, y: (a.y + b.y) / 2 };
}

const middle_button = 1;

/** One pointer clicks or drags; two, and the mouse's middle button, always move, until all are lifted. */
export function watch_pointers(canvas: HTMLCanvasElement, actions: PointerActions): void {
  const down = new Map<number, Point>();
  let began: Point | undefined;
  let moved = false;
  let pans = false;
  /** Who lets go of Shift before the button still adds. */
  let adds = false;

  const place = (event: MouseEvent): Point => {
    const box = canvas.getBoundingClientRect();
    return { x: event.clientX - box.left, y: event.clientY - box.top };
  };
  const move_both = (id: number, to: Point) => {
    const before = [...down.values()].slice(0, 2);
    down.set(id, to);
    const after = [...down.values()].slice(0, 2);
    const [from, at] = [middle(before), middle(after)];
    actions.pan(at.x - from.x, at.y - from.y);
    const spread = (points: Point[]) => Math.max(1, distance(points[0] as Point, points[1] as Point));
    actions.zoom(spread(after) / spread(before), at);
  };
  const cancel_drag = () => {
    if (began && moved && !pans) actions.cancel_drag();
  };
  const end = (event: PointerEvent, is_cancelled: boolean) => {
    if (!down.delete(event.pointerId) || down.size > 0) return;
    adds ||= event.shiftKey;
    if (is_cancelled) cancel_drag();
    else if (began && moved && !pans) actions.drag(began, place(event), true, adds);
    else if (began && !pans) actions.click(place(event), adds);
    began = undefined;
  };

  canvas.addEventListener("pointerdown", (event) => {
    canvas.setPointerCapture(event.pointerId);
    down.set(event.pointerId, place(event));
    if (down.size > 1) {
      cancel_drag();
      began = undefined;
    } else {
      began = place(event);
      moved = false;
      pans = event.button === middle_button;
      adds = event.shiftKey;
    }
  });
  canvas.addEventListener("pointermove", (event) => {
    const from = down.get(event.pointerId);
    const to = place(event);
    if (!from) {
      if (event.pointerType === "mouse") actions.hover(to);
      return;
    }
    if (down.size > 1) move_both(event.pointerId, to);
    else if (began && (moved || distance(began, to) > click_within_px)) {
      moved = true;
      down.set(event.pointerId, to);
      adds ||= event.shiftKey;
      pans ||= !actions.drag(began, to, false, adds);
      if (pans) actions.pan(to.x - from.x, to.y - from.y);
    } else if (!began) down.set(event.pointerId, to);
  });
  canvas.addEventListener("pointerleave", ({ pointerType }) => {
    if (pointerType === "mouse") actions.hover(undefined);
  });
  canvas.addEventListener("pointerup", (event) => end(event, false));
  canvas.addEventListener("pointercancel", (event) => end(event, true));
  canvas.addEventListener(
    "wheel",
    (event) => {
      event.preventDefault();
      actions.zoom(Math.exp(-event.deltaY * (event.deltaMode === 0 ? 0.0015 : 0.05)), place(event));
    },
    { passive: false },
  );
}
