import type { BuildingStore } from "../building/building_store";
import type { App } from "../page/app";
import { button, element, set_text } from "../page/element";
import { position_text } from "../page/units";
import { text } from "../text";
import { colour } from "../page/theme";
import { draw_dots } from "../plan/draw";
import type { Point } from "../plan/geometry";
import type { Layer } from "../plan/plan_canvas";

/** A clicked point of the chosen building: the user confirms it before the vehicle drives there. */
export class Goal {
  readonly element: HTMLElement;
  readonly layer: Layer;
  readonly #where = element("span", { class: "goal-text" });
  #at: Point | undefined;

  constructor(
    private readonly app: App,
    private readonly store: BuildingStore,
    private readonly changed: () => void,
  ) {
    this.element = element(
      "div",
      { class: "goal-bar", hidden: true },
      this.#where,
      button(text.plan.go, () => void this.#send(), { class: "primary" }),
      button(text.plan.cancel, () => this.clear()),
    );
    this.layer = (context, view) => {
      if (this.#at) draw_dots(context, view, [this.#at], colour("path"), 7);
    };
  }

  pick(at: Point): void {
    if (!this.store.is_shown.value || !this.store.building.value) {
      this.app.notices.show(text.plan.no_building);
      return;
    }
    this.#at = at;
    this.element.hidden = false;
    set_text(this.#where, text.plan.goal(position_text(at, 2), this.store.chosen.value));
    this.changed();
  }

  clear(): void {
    this.#at = undefined;
    this.element.hidden = true;
    this.changed();
  }

  async #send(): Promise<void> {
    if (!this.#at) return;
    const request = { building: this.store.chosen.value, x_m: this.#at.x, y_m: this.#at.y };
    if (await this.app.notices.attempt(this.app.lease.call("mission/go", request))) this.clear();
  }
}
