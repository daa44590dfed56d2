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

/** @param request  of the mission that runs */
function words_of_request(request: GoalRequest): string {
  if ("place" in request) return request.place;
  const { x_m, y_m, ...heading } = request;
  return words_of({ x: x_m, y: y_m, ...heading });
}

/**
 * Where the vehicle is sent in the chosen building. A clicked point is confirmed before it drives there; a drag gives the
 * heading, too, and it drives when the drag ends. Several goals make a queue, which is driven in order: with Shift a click
 * or a drag adds one. While it drives to its goals, what is added and removed are those of its mission.
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
  readonly #only_waiting: HTMLElement[];
  #is_changing = false;
  /** What the list shows of the mission's goals. */
  #shown = "";

  /** @param scale_px_per_m  of the plan now */
  constructor(
    private readonly app: App,
    private readonly store: BuildingStore,
    private readonly scale_px_per_m: () => number,
    private readonly changed: () => void,
  ) {
    const go = button(text.plan.go, () => void this.#send(this.#picked ? [this.#picked] : []), {
      class: "primary",
    });
    const drive = button(text.plan.drive_queue, () => void this.#send(this.#queue), { class: "primary" });
    const clear = button(text.plan.clear_queue, () => this.clear(), { class: "goal-clear" });
    this.#only_waiting = [go, drive, clear];
    this.#picking = element(
      "div",
      { class: "goal-bar goal-pick" },
      this.#where,
      go,
      button(text.plan.add, () => this.#add(), { title: text.plan.add_hint }),
      button(text.plan.cancel, () => this.#pick(undefined)),
    );
    this.#queueing = element("div", { class: "goal-bar goal-queue" }, this.#list, drive, clear);
    this.element = element("div", { class: "goals" }, this.#queueing, this.#picking);
    this.layer = (context, view) => {
      this.#queue.forEach((goal, index) => draw_goal(context, view, goal, String(index + 1)));
      if (!this.#picked) return;
      const drawn_px = this.#turning && distance(this.#picked, this.#turning) * view.scale_px_per_m;
      draw_goal(context, view, this.#picked, "", drawn_px);
    };
    this.clear();
    app.state.watch(() => this.#follow());
    store.is_shown.watch(() => this.#follow());
  }

  /** Of the mission, in the map that the plan shows; undefined: it drives to none, or another building is shown. */
  get #under_way(): { goals: GoalRequest[]; reached: number } | undefined {
    const { mode, goals, goals_reached = 0 } = this.app.state.value ?? {};
    if (mode !== "mission" || !goals || this.store.is_shown.value) return undefined;
    return { goals, reached: goals_reached };
  }

  /** The mission's goals have changed, or it has begun or ended. */
  #follow(): void {
    const shown = JSON.stringify(this.#under_way ?? "");
    if (shown === this.#shown) return;
    const begins_or_ends = (shown === '""') !== (this.#shown === '""');
    this.#shown = shown;
    for (const made of this.#only_waiting) made.hidden = this.#under_way !== undefined;
    this.#show_queue();
    if (begins_or_ends) this.cancel();
  }

  /** @param adds  to the queue, at once */
  click(at: Point, adds: boolean): void {
    if (this.#under_way) {
      this.#pick(this.#goal_at(at));
      if (adds) this.#add();
      return;
    }
    if (!this.store.is_shown.value || !this.store.building.value) {
      this.app.notices.show(text.plan.no_building);
      return;
    }
    this.#pick(this.#goal_at(at));
    if (adds) this.#add();
  }

  /**
   * A drag as short as the dot is a click. Where there is a queue, the goal joins it.
   * @returns false: the drag gives no goal
   */
  drag(from: Point, to: Point, ended: boolean, adds: boolean): false | void {
    if (!this.#takes_drag(adds)) return false;
    const goal = this.#goal_at(from);
    const is_turned = distance(from, to) * this.scale_px_per_m() > near_px;
    this.#picked = is_turned ? { ...goal, heading_deg: direction_deg(goal, to) } : goal;
    this.#turning = ended || !is_turned ? undefined : to;
    if (!ended) return this.changed(); // without the bar, which would move the plan under the pointer
    this.#pick(this.#picked);
    if (adds || (is_turned && this.#queue.length > 0)) this.#add();
    else if (is_turned) void this.#send([this.#picked]);
  }

  /** On the way the plan is moved by a drag, and only Shift makes it a goal. */
  #takes_drag(adds: boolean): boolean {
    if (this.#under_way) return adds;
    return this.store.is_shown.value && this.store.takes_goals.value && !!this.store.building.value;
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
    return this.#places().find((place) => distance(place, at) <= within_m) ?? { x: at.x, y: at.y };
  }

  #places(): Goal[] {
    if (!this.#under_way)
      return (this.store.building.value?.places ?? []).map(({ at_m, name }) => ({
        ...point_of(at_m),
        place: name,
      }));
    return this.app.plan.places().map(({ x, y, name }) => ({ x, y, place: name }));
  }

  #pick(goal: Goal | undefined): void {
    this.#picked = goal;
    this.#picking.hidden = goal === undefined;
    const words = goal && words_of(goal);
    if (words)
      set_text(this.#where, this.#under_way ? words : text.plan.goal(words, this.store.chosen.value));
    this.changed();
  }

  #add(): void {
    if (this.#picked && this.#under_way) return void this.#change({ add: request_of(this.#picked) });
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
    const under_way = this.#under_way;
    const first = under_way?.reached ?? 0;
    const rows = under_way
      ? under_way.goals
          .slice(first)
          .map((goal, index) =>
            this.#row(words_of_request(goal), first + index + 1, () =>
              this.#change({ remove: first + index + 1 }),
            ),
          )
      : this.#queue.map((goal, index) => this.#row(words_of(goal), index + 1, () => this.#remove(goal)));
    this.#list.style.counterReset = `goal ${first}`;
    this.#list.replaceChildren(...rows);
    // The last goal of a mission cannot be removed, and the plan shows it.
    this.#queueing.hidden = rows.length <= (under_way ? 1 : 0);
  }

  #row(words: string, number: number, remove: () => void): HTMLElement {
    return element(
      "li",
      {},
      element("span", {}, words),
      button("×", remove, { "aria-label": text.plan.remove_goal(number) }),
    );
  }

  /** Until the server has said what the goals are now, their numbers are not known: none can be removed. */
  async #change(change: { add: GoalRequest } | { remove: number }): Promise<void> {
    if (this.#is_changing) return;
    this.#is_changing = true;
    const rows = [...this.#list.querySelectorAll("button")];
    for (const row of rows) row.disabled = true;
    const done = await this.app.notices.attempt(this.app.lease.call("mission/goals", change));
    this.#is_changing = false;
    if (!done) for (const row of rows) row.disabled = false;
    else if ("add" in change) this.cancel();
  }

  async #send(goals: Goal[]): Promise<void> {
    const [first, ...more] = goals.map(request_of);
    if (!first) return;
    const where = more.length === 0 ? first : { goals: [first, ...more] };
    const request = { building: this.store.chosen.value, ...where };
    if (await this.app.notices.attempt(this.app.lease.call("mission/go", request))) this.clear();
  }
}
