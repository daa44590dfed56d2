import { button, element } from "../page/element";
import { Sheet } from "../page/sheet";
import type { Bounds, Point } from "./geometry";
import { draw_scale } from "./draw";
import { PlanView } from "./plan_view";
import { watch_pointers } from "./pointers";

export type Layer = (context: CanvasRenderingContext2D, view: PlanView) => void;

/** What clicks and drags on the plan do, in map coordinates [m]; without `drag`, a drag moves the plan. */
export interface PlanTool {
  click?(at: Point): void;
  drag?(from: Point, to: Point, ended: boolean): void;
}

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

  readonly #canvas: HTMLCanvasElement;
  readonly #sheet: Sheet;
  readonly #follow: HTMLButtonElement;
  #follows = false;
  #is_moved = false;

  constructor(label: string) {
    this.#canvas = element("canvas", { tabindex: 0, role: "img", "aria-label": label });
    this.#follow = button("Follow", () => this.#set_following(!this.#follows), { "aria-pressed": "false" });
    const tools = element(
      "div",
      { class: "plan-tools", role: "toolbar", "aria-label": "View" },
      button("+", () => this.#zoom_middle(1.4), { "aria-label": "Zoom in" }),
      button("−", () => this.#zoom_middle(1 / 1.4), { "aria-label": "Zoom out" }),
      button("Fit", () => this.#fit_again()),
      this.#follow,
    );
    this.element = element("div", { class: "plan" }, this.#canvas, tools);
    this.#sheet = new Sheet(this.#canvas, (context) => this.#draw(context));
    this.#canvas.addEventListener("keydown", (event) => this.#key(event));
    watch_pointers(this.#canvas, {
      pan: (right, down) => this.#pan(right, down),
      zoom: (factor, at) => this.#zoom(factor, at),
      click: (at) => this.tool.click?.(this.view.to_map(at)),
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
      if (extent) this.view.fit(extent);
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

  #zoom_middle(factor: number): void {
    this.#zoom(factor, { x: this.view.width_px / 2, y: this.view.height_px / 2 });
  }

  #key(event: KeyboardEvent): void {
    if (event.key === "+" || event.key === "=") this.#zoom_middle(1.4);
    else if (event.key === "-") this.#zoom_middle(1 / 1.4);
    else if (event.key === "0") this.#fit_again();
    else return;
    event.preventDefault();
  }
}
