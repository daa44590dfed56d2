import type { BuildingShelf } from "../building/building_shelf";
import type { App } from "../page/app";
import { button, element, panel, say, tick } from "../page/element";
import { building_points } from "../plan/building_geometry";
import { building_layer } from "../plan/building_layer";
import { draw_dots } from "../plan/draw";
import { bounds_of } from "../plan/geometry";
import type { Point } from "../plan/geometry";
import { live_layers } from "../plan/live_layers";
import { LivePlan } from "../plan/live_plan";
import { PlanCanvas } from "../plan/plan_canvas";
import type { Layer } from "../plan/plan_canvas";
import { colour } from "../page/theme";

/** The plan of what the vehicle knows and does; a click on it picks a place to go to. */
export function plan_panel(app: App, shelf: BuildingShelf): HTMLElement {
  const canvas = new PlanCanvas("Plan of the building and the vehicle");
  const plan = new LivePlan(app.connection, () => canvas.redraw());
  const layers = live_layers(plan);
  const hidden = new Set<string>();
  let goal: Point | undefined;
  let background: Layer | undefined;

  /** The chosen building's file; while a mission shows what it knows itself, that stands alone. */
  const chosen_building = () => (plan.marks.size === 0 ? shelf.building.value : undefined);
  const goal_layer: Layer = (context, view) => {
    if (goal) draw_dots(context, view, [goal], colour("path"), 7);
  };
  canvas.extent = () => {
    const building = chosen_building();
    return bounds_of(building ? [...building_points(building), ...plan.points()] : plan.points());
  };
  canvas.followed = () => plan.pose;
  const arrange = () => {
    const live = Object.entries(layers).flatMap(([name, layer]) => (hidden.has(name) ? [] : [layer]));
    const under: Layer = (context, view) => {
      if (chosen_building()) background?.(context, view);
    };
    canvas.layers = [under, ...live, goal_layer];
    canvas.redraw();
  };
  shelf.building.watch((building) => {
    background = building ? building_layer(building) : undefined;
    canvas.redraw();
  });

  const toggles = Object.keys(layers).map((name) =>
    tick(name, true, (shown) => {
      if (shown) hidden.delete(name);
      else hidden.add(name);
      arrange();
    }),
  );
  arrange();

  const where = element("span", { class: "goal-text" });
  const go = button("Go there", () => void send(), { class: "primary" });
  const cancel = button("Forget it", () => pick(undefined));
  const goal_bar = element("div", { class: "goal-bar", hidden: true }, where, go, cancel);
  const pick = (at: Point | undefined) => {
    goal = at;
    goal_bar.hidden = at === undefined;
    if (at) say(where, `x ${at.x.toFixed(2)} m, y ${at.y.toFixed(2)} m in ${shelf.chosen.value}`);
    canvas.redraw();
  };
  const send = async () => {
    if (!goal) return;
    const request = { building: shelf.chosen.value, x_m: goal.x, y_m: goal.y };
    if (await app.notices.attempt(app.lease.call("mission/go", request), "On the way")) pick(undefined);
  };
  canvas.tool = {
    click: (at) => {
      if (shelf.chosen.value === "")
        app.notices.tell("Choose a building under Mission to go to a place in it");
      else pick(at);
    },
  };

  return panel(
    "Plan",
    "plan-panel",
    canvas.element,
    goal_bar,
    element("div", { class: "toggles", role: "group", "aria-label": "Layers of the plan" }, ...toggles),
  );
}
