import type { BuildingStore } from "../building/building_store";
import type { GoalRequest } from "../connection/live_state";
import type { App } from "../page/app";
import { button, element, set_text } from "../page/element";
import { position_text } from "../page/units";
import { text } from "../text";
import { point_of } from "../plan/building_geometry";
import { draw_goal } from "../plan/draw";
import { direction_deg, distance } from "../plan/geometry";
import type { Point } from "../plan/geometry";
import type { Layer } from "../plan/plan_canvas";

const near_px = 14;
const arrow_px = 34;

/** A point of the chosen building to which the vehicle is sent. */
interface Goal extends Point {
  /** Of a named place. */
  place?: string;
  heading_deg?: number;
}

function request_of({ x, y, place, heading_deg }: Goal): GoalRequest {
  if (place !== undefined && heading_deg === undefined) return { place };
  return { x_m: x, y_m: y, ...(heading_deg === undefined ? {} : { heading_deg }) };
}

function words_of({ place, heading_deg, ...at }: Goal): string {
  const heading = heading_deg === undefined ? [] : [text.plan.facing(heading_deg)];
  return [place ?? position_text(at, 2), ...heading].join(", ");
}

/**
 * Where the vehicle is sent in the chosen building. A clicked point is confirmed before it drives there; a drag gives the
 * heading, too, and it drives when the drag ends. Several goals make a queue, which is driven in order.
 */
export class Goals {
  readonly element: HTMLElement;
  readonly layer: Layer;
  readonly #where = element("span", { class: "goal-text" });
  readonly #picking: HTMLElement;
  readonly #list = element("ol", { class: "goal-list", "aria-label": text.plan.queue });
  readonly #queueing: HTMLElement;
  #picked: Goal | undefined;
  /** Where the drag for the heading is. */
  #turning: Point | undefined;
  #queue: Goal[] = [];

  /** @param scale_px_per_m  of the plan now */
  constructor(
    private readonly app: App,
    private readonly store: BuildingStore,
    private readonly scale_px_per_m: () => number,
    private readonly changed: () => void,
  ) {
    this.#picking = element(
      "div",
      { class: "goal-bar goal-pick" },
      this.#where,
      button(text.plan.go, () => void this.#send(this.#picked ? [this.#picked] : []), { class: "primary" }),
      button(text.plan.add, () => this.#add(), { title: text.plan.add_hint }),
      button(text.plan.cancel, () => this.#pick(undefined)),
    );
    this.#queueing = element(
      "div",
      { class: "goal-bar goal-queue" },
      this.#list,
      button(text.plan.drive_queue, () => void this.#send(this.#queue), { class: "primary" }),
      button(text.plan.clear_queue, () => this.clear(), { class: "goal-clear" }),
    );
    this.element = element("div", { class: "goals" }, this.#queueing, this.#picking);
    this.layer = (context, view) => {
      this.#queue.forEach((goal, index) => draw_goal(context, view, goal, String(index + 1), arrow_px));
      if (!this.#picked) return;
      const drawn_px = this.#turning && distance(this.#picked, this.#turning) * view.scale_px_per_m;
      draw_goal(context, view, this.#picked, "", Math.max(arrow_px, drawn_px ?? 0));
    };
    this.clear();
  }

  /** @param adds  to the queue, at once */
  click(at: Point, adds: boolean): void {
    if (!this.store.is_shown.value || !this.store.building.value) {
      this.app.notices.show(text.plan.no_building);
      return;
    }
    this.#pick(this.#goal_at(at));
    if (adds) this.#add();
  }

  /** A drag as short as the dot is a click. Where there is a queue, the goal joins it. */
  drag(from: Point, to: Point, ended: boolean, adds: boolean): void {
    const goal = this.#goal_at(from);
    const is_turned = distance(from, to) * this.scale_px_per_m() > near_px;
    this.#picked = is_turned ? { ...goal, heading_deg: direction_deg(goal, to) } : goal;
    this.#turning = ended || !is_turned ? undefined : to;
    if (!ended) return this.changed(); // without the bar, which would move the plan under the pointer
    this.#pick(this.#picked);
    if (adds || (is_turned && this.#queue.length > 0)) this.#add();
    else if (is_turned) void this.#send([this.#picked]);
  }

  cancel(): void {
    this.#turning = undefined;
    this.#pick(undefined);
  }

  clear(): void {
    this.#queue = [];
    this.#show_queue();
    this.cancel();
  }

  #goal_at(at: Point): Goal {
    const within_m = near_px / this.scale_px_per_m();
    const place = (this.store.building.value?.places ?? []).find(
      ({ at_m }) => distance(point_of(at_m), at) <= within_m,
    );
    return place ? { ...point_of(place.at_m), place: place.name } : { x: at.x, y: at.y };
  }

  #pick(goal: Goal | undefined): void {
    this.#picked = goal;
    this.#picking.hidden = goal === undefined;
    if (goal) set_text(this.#where, text.plan.goal(words_of(goal), this.store.chosen.value));
    this.changed();
  }

  #add(): void {
    if (this.#picked) this.#queue.push(this.#picked);
    this.#show_queue();
    this.cancel();
  }

  #remove(goal: Goal): void {
    this.#queue = this.#queue.filter((kept) => kept !== goal);
    this.#show_queue();
    this.changed();
  }

  #show_queue(): void {
    this.#queueing.hidden = this.#queue.length === 0;
    const rows = this.#queue.map((goal, index) =>
      element(
        "li",
        {},
        element("span", {}, words_of(goal)),
        button("×", () => this.#remove(goal), { "aria-label": text.plan.remove_goal(index + 1) }),
      ),
    );
    this.#list.replaceChildren(...rows);
  }

  async #send(goals: Goal[]): Promise<void> {
    const [first, ...more] = goals.map(request_of);
    if (!first) return;
    const where = more.length === 0 ? first : { goals: [first, ...more] };
    const request = { building: this.store.chosen.value, ...where };
    if (await this.app.notices.attempt(this.app.lease.call("mission/go", request))) this.clear();
  }
}
