import { button, element, set_text } from "../page/element";
import { download } from "../page/server_files";
import { Sheet } from "../page/sheet";
import { colour } from "../page/theme";
import { position_text, unit } from "../page/units";
import { text } from "../text";
import { draw_cross, draw_scale } from "./draw";
import type { Bounds, Point } from "./geometry";
import { draw_grid } from "./grid";
import { draw_legend } from "./legend";
import type { Shown } from "./legend";
import { grid, legend, more_tools } from "./more_tools";
import { PlanView } from "./plan_view";
import { watch_pointers } from "./pointers";
import { Ruler } from "./ruler";

export type Layer = (context: CanvasRenderingContext2D, view: PlanView) => void;

/** What clicks and drags on the plan do, in map coordinates [m]; without `drag`, a drag moves the plan. */
export interface PlanTool {
  /** @param adds  with Shift: to what was clicked before */
  click?(at: Point, adds: boolean): void;
  /** undefined: the mouse leaves. */
  hover?(at: Point | undefined): void;
  /** @returns false: this drag moves the plan, too */
  drag?(from: Point, to: Point, ended: boolean, adds: boolean): false | void;
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
  /** What the legend explains. */
  shown: () => ReadonlySet<Shown> = () => new Set();
  /** What the plan shows, for the name of its picture. */
  subject: () => string = () => "";

  readonly #canvas: HTMLCanvasElement;
  readonly #sheet: Sheet;
  readonly #follow: HTMLButtonElement;
  readonly #position = element("span", { hidden: true });
  readonly #measured = element("span", { role: "status", hidden: true });
  readonly #ruler = new Ruler(() => this.#show_measured());
  #measures = false;
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
      ...more_tools(
        (on) => this.#set_measuring(on),
        () => this.#save_picture(),
      ),
    );
    const readout = element("p", { class: "plan-readout" }, this.#measured, this.#position);
    this.element = element("div", { class: "plan" }, this.#canvas, tools, readout);
    this.#sheet = new Sheet(this.#canvas, (context) => this.#draw(context));
    this.#canvas.addEventListener("keydown", (event) => this.#key(event));
    watch_pointers(this.#canvas, {
      pan: (right, down) => this.#pan(right, down),
      zoom: (factor, at) => this.#zoom(factor, at),
      click: (at, adds) => this.#tool.click?.(this.view.to_map(at), adds),
      hover: (at) => this.#point(at && this.view.to_map(at)),
      cancel_drag: () => this.#tool.cancel?.(),
      drag: (from, to, ended, adds) => {
        if (!this.#tool.drag) return false;
        return this.#tool.drag(this.view.to_map(from), this.view.to_map(to), ended, adds) !== false;
      },
    });
    for (const change of ["focus", "blur"]) this.#canvas.addEventListener(change, () => this.redraw());
    for (const setting of [grid, legend, unit]) setting.watch(() => this.redraw());
    unit.watch(() => this.#show_measured());
  }

  get #tool(): PlanTool {
    return this.#measures ? this.#ruler : this.tool;
  }

  /** The keys act on the plan, in its middle. */
  get #is_by_keys(): boolean {
    return this.#canvas.matches(":focus-visible");
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
    if (grid.value === "on") draw_grid(context, this.view);
    if (legend.value === "on") draw_legend(context, this.view, this.shown());
    if (this.#measures) this.#ruler.layer(context, this.view);
    draw_scale(context, this.view);
    if (!this.#is_by_keys) return;
    draw_cross(context, this.view, this.view.middle);
    this.#show_position(this.view.middle);
  }

  /** The mouse points there; undefined: it leaves. */
  #point(at: Point | undefined): void {
    this.#tool.hover?.(at);
    this.#show_position(at);
  }

  #show_position(at: Point | undefined): void {
    this.#position.hidden = at === undefined;
    if (at) set_text(this.#position, position_text(at, 2));
  }

  #set_measuring(on: boolean): void {
    this.#measures = on;
    this.#measured.hidden = !on;
    this.#ruler.clear();
  }

  #show_measured(): void {
    set_text(this.#measured, this.#ruler.text());
    this.redraw();
  }

  /** Saves what is seen, on the colour of the page's ground, as a PNG file. */
  #save_picture(): void {
    const { width, height } = this.#canvas;
    const copy = element("canvas", { width, height });
    const context = copy.getContext("2d");
    if (!context) return;
    context.fillStyle = colour("ground");
    context.fillRect(0, 0, width, height);
    context.drawImage(this.#canvas, 0, 0);
    copy.toBlob((bytes) => {
      const name = ["aisle", this.subject()].filter(Boolean).join("-");
      if (bytes) download(`${name}.png`, bytes);
    });
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
    else if (event.key === "Enter") this.#tool.click?.(this.view.middle, event.shiftKey);
    else if (event.key === "Backspace" && this.#measures) this.#ruler.take_back();
    else if (event.key in pan_keys) this.#pan(...(pan_keys[event.key] as [number, number]));
    else return;
    event.preventDefault();
  }
}
