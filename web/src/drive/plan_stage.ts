import type { BuildingStore } from "../building/building_store";
import type { App } from "../page/app";
import { element, tick } from "../page/element";
import { building_points } from "../plan/building_geometry";
import { building_layer } from "../plan/building_layer";
import { bounds_of } from "../plan/geometry";
import type { Bounds, Point } from "../plan/geometry";
import { shown_live, shown_of_building } from "../plan/legend";
import { live_layers } from "../plan/live_layers";
import { PlanCanvas } from "../plan/plan_canvas";
import type { Layer } from "../plan/plan_canvas";
import { text } from "../text";
import { Goals } from "./goal";
import { goals_layer } from "./goals_layer";

/**
 * The plan of the vehicle's map and motion, and the switches of its layers. While a mission in a building is being
 * chosen, the plan shows that building, and clicks pick goals. The two are never mixed: a waiting vehicle does not
 * know its pose in the building.
 */
export function plan_stage(app: App, store: BuildingStore): { plan: HTMLElement; layers: HTMLElement } {
  const canvas = new PlanCanvas(text.plan.name);
  const plan = app.plan;
  plan.watch(() => canvas.redraw());
  const goals = new Goals(
    app,
    store,
    () => canvas.view.scale_px_per_m,
    () => canvas.redraw(),
  );
  const layers = { ...live_layers(plan), goals: goals_layer(app) };
  const hidden = new Set<string>();
  let building: Layer | undefined;
  let building_extent: Bounds | undefined;

  const is_building = () => store.is_shown.value && building !== undefined;
  const click = (at: Point, adds: boolean) => goals.click(at, adds);
  const drag = (...drawn: Parameters<Goals["drag"]>) => goals.drag(...drawn);
  const cancel = () => goals.cancel();
  canvas.tool = { click, drag, cancel };
  const arrange = () => {
    const live = Object.entries(layers).flatMap(([name, layer]) => (hidden.has(name) ? [] : [layer]));
    canvas.layers = is_building() && building ? [building, goals.layer] : [...live, goals.layer];
    canvas.redraw();
  };
  canvas.extent = () => (is_building() ? building_extent : bounds_of(plan.points()));
  canvas.followed = () => (is_building() ? undefined : plan.pose);
  canvas.covered_left_px = () => {
    const inset = canvas.element.closest<HTMLElement>(".stage[data-main=plan]")?.querySelector(".camera-box");
    const covered_px = (inset?.clientWidth ?? 0) + 12;
    return covered_px < canvas.element.clientWidth / 2 ? covered_px : 0;
  };
  canvas.shown = () => {
    const chosen = is_building() && store.building.value;
    return chosen ? shown_of_building(chosen) : shown_live(plan, (layer) => hidden.has(layer));
  };
  canvas.subject = () => (is_building() ? store.chosen.value : (app.state.value?.world ?? ""));

  const toggles = Object.keys(layers).map((name) =>
    tick(name, true, (shown) => {
      if (shown) hidden.delete(name);
      else hidden.add(name);
      arrange();
    }),
  );
  const building_toggle = tick(text.details.building, false, (shown) => (store.is_shown.value = shown));
  store.building.watch((chosen) => {
    building = chosen && building_layer(chosen);
    building_extent = chosen && bounds_of(building_points(chosen));
    building_toggle.hidden = chosen === undefined;
    goals.clear();
    canvas.refit();
    arrange();
  });
  store.is_shown.watch((shown) => {
    (building_toggle.firstElementChild as HTMLInputElement).checked = shown;
    if (!shown) goals.clear();
    canvas.refit();
    arrange();
  });
  app.state.watch((state) => {
    if (state?.goals) canvas.redraw();
  });
  const switches = element(
    "div",
    { class: "toggles", role: "group", "aria-label": text.details.layers },
    ...toggles,
    building_toggle,
  );
  return { plan: element("div", { class: "plan-box" }, canvas.element, goals.element), layers: switches };
}
