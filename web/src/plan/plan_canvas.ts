import { button, element } from "../page/element";
import { text } from "../text";
import { Sheet } from "../page/sheet";
import type { Bounds, Point } from "./geometry";
import { draw_scale } from "./draw";
import { PlanView } from "./plan_view";
import { watch_pointers } from "./pointers";

export type Layer = (context: CanvasRenderingContext2D, view: PlanView) => void;

/** What clicks and drags on the plan do, in map coordinates [m]; without `drag`, a drag moves the plan. */
export interface PlanTool {
  click?(at: Point): void;
  /** undefined: the mouse leaves. */
  hover?(at: Point | undefined): void;
  drag?(from: Point, to: Point, ended: boolean): void;
  /** The drag did not happen. */
  cancel?(): void;
}

/** What the arrow keys pan, right and down; while the page drives they steer and do not arrive here. */
const pan_keys: Record<string, [number, number]> = {
  ArrowLeft: [60, 0],
  ArrowRight: [-60, 0],
  ArrowUp: [0, 60],
  ArrowDown: [0, -60],
};

/** A plan of several layers; mouse, touch and keys move and zoom it. */
export class PlanCanvas {
  readonly view = new PlanView();
  readonly element: HTMLElement;
  tool: PlanTool = {};
  layers: Layer[] = [];
  /** The area to fit into the canvas; undefined: nothing yet. */
  extent: () => Bounds | undefined = () => undefined;
  /** The point that stays in the middle while the plan follows the vehicle; undefined: nothing to follow. */
  followed: () => Point | undefined = () => undefined;

  /** How much of its left side something else covers. */
  covered_left_px: () => number = () => 0;

  readonly #canvas: HTMLCanvasElement;
  readonly #sheet: Sheet;
  readonly #follow: HTMLButtonElement;
  #follows = false;
  #is_moved = false;

  constructor(label: string) {
    this.#canvas = element("canvas", { tabindex: 0, role: "img", "aria-label": label });
    this.#canvas.title = text.plan.keys;
    this.#follow = button(text.plan.follow, () => this.#set_following(!this.#follows), {
      "aria-pressed": "false",
    });
    const tools = element(
      "div",
      { class: "plan-tools", role: "toolbar", "aria-label": text.plan.view },
      button("+", () => this.#zoom_middle(1.4), { "aria-label": text.plan.zoom_in }),
      button("−", () => this.#zoom_middle(1 / 1.4), { "aria-label": text.plan.zoom_out }),
      button(text.plan.fit, () => this.#fit_again()),
      this.#follow,
    );
    this.element = element("div", { class: "plan" }, this.#canvas, tools);
    this.#sheet = new Sheet(this.#canvas, (context) => this.#draw(context));
    this.#canvas.addEventListener("keydown", (event) => this.#key(event));
    watch_pointers(this.#canvas, {
      pan: (right, down) => this.#pan(right, down),
      zoom: (factor, at) => this.#zoom(factor, at),
      click: (at) => this.tool.click?.(this.view.to_map(at)),
      hover: (at) => this.tool.hover?.(at && this.view.to_map(at)),
      cancel_drag: () => this.tool.cancel?.(),
      drag: (from, to, ended) => {
        if (!this.tool.drag) return false;
        this.tool.drag(this.view.to_map(from), this.view.to_map(to), ended);
        return true;
      },
    });
  }

  hide_follow(): void {
    this.#follow.hidden = true;
  }

  redraw(): void {
    this.#sheet.redraw();
  }

  /** Fits the whole extent into the canvas again. */
  refit(): void {
    this.#is_moved = false;
    this.redraw();
  }

  #draw(context: CanvasRenderingContext2D): void {
    this.view.width_px = this.#sheet.width_px;
    this.view.height_px = this.#sheet.height_px;
    this.#place();
    for (const layer of this.layers) {
      context.save();
      layer(context, this.view);
      context.restore();
    }
    draw_scale(context, this.view);
  }

  #place(): void {
    const middle = this.#follows ? this.followed() : undefined;
    if (middle) this.view.middle = middle;
    else if (!this.#is_moved) {
      const extent = this.extent();
      if (extent) this.view.fit(extent, this.covered_left_px());
    }
  }

  #set_following(follows: boolean): void {
    this.#follows = follows;
    this.#is_moved = true;
    this.#follow.setAttribute("aria-pressed", String(follows));
    this.redraw();
  }

  #fit_again(): void {
    this.#set_following(false);
    this.refit();
  }

  #pan(right: number, down: number): void {
    if (this.#follows) this.#set_following(false);
    this.#is_moved = true;
    this.view.pan_px(right, down);
    this.redraw();
  }

  #zoom(factor: number, at: Point): void {
    this.#is_moved = true;
    this.view.zoom(factor, at);
    this.redraw();
  }

  /** Zooms about the vehicle where that is in sight, else about the middle. */
  #zoom_middle(factor: number): void {
    const { width_px, height_px } = this.view;
    const followed = this.followed();
    const at = followed && this.view.to_screen(followed);
    const is_seen = at && at.x >= 0 && at.y >= 0 && at.x <= width_px && at.y <= height_px;
    this.#zoom(factor, is_seen ? at : { x: width_px / 2, y: height_px / 2 });
  }

  #key(event: KeyboardEvent): void {
    if (event.key === "+" || event.key === "=") this.#zoom_middle(1.4);
    else if (event.key === "-") this.#zoom_middle(1 / 1.4);
    else if (event.key === "0") this.#fit_again();
    else if (event.key in pan_keys) this.#pan(...(pan_keys[event.key] as [number, number]));
    else return;
    event.preventDefault();
  }
}
