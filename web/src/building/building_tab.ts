import type { App, Tab } from "../page/app";
import { text } from "../text";
import { watch_undo_keys } from "../page/undo_keys";
import { button, element, panel, set_text, select } from "../page/element";
import { post_text } from "../page/server_files";
import { UndoList } from "../page/undo_list";
import { building_points } from "../plan/building_geometry";
import { building_layer } from "../plan/building_layer";
import { bounds_of } from "../plan/geometry";
import { shown_of_building } from "../plan/legend";
import { PlanCanvas } from "../plan/plan_canvas";
import { renamed_place, with_place, without_place } from "./building_edits";
import type { Building } from "./building_file";
import { BuildingStore } from "./building_store";
import { BuildingTools, tool_labels } from "./building_tools";
import type { ToolName } from "./building_tools";

/** The contents of a building in words. */
function summary(building: Building): string {
  const known = Object.entries(text.building.counted).flatMap(([key, [one, many]]) => {
    const count = (building[key as keyof Building] as unknown[] | undefined)?.length ?? 0;
    return count === 0 ? [] : [`${count} ${count === 1 ? one : many}`];
  });
  if (building.floor) known.push(text.building.floor);
  return known.join(", ") || text.building.nothing;
}

/**
 * Shows a building and edits it; saving makes a new version. What is not saved stays when another building or tab is
 * chosen, is marked, and is not lost on leaving the page without a question.
 */
export function building_tab(app: App): Tab {
  const store = new BuildingStore(app);
  const words = text.building;
  const canvas = new PlanCanvas(words.plan);
  canvas.hide_follow();
  canvas.subject = () => store.chosen.value;
  canvas.shown = () => (history ? shown_of_building(history.present) : new Set());
  const histories = new Map<string, UndoList<Building>>();
  let history: UndoList<Building> | undefined;

  const tools = new BuildingTools(canvas, {
    building: () => history?.present,
    edit: (change) => edit(change),
    marked: (part) => set_text(hint, part ? words.again(words.parts[part.list]) : tool_hint),
    zone_speed_mps: () => Number(zone_speed.value),
    miss_room: () => app.notices.show(words.no_room, "trouble"),
    pick_place: (heading_deg) => {
      heading.value = heading_deg === undefined ? "" : String(heading_deg);
      begin_naming(undefined);
    },
  });
  const edit = (change: (building: Building) => Building): boolean => {
    if (!history) return false;
    try {
      const changed = change(history.present);
      if (changed !== history.present) history.put(changed);
    } catch (problem) {
      app.notices.show((problem as Error).message, "trouble");
      return false;
    }
    show();
    return true;
  };

  const about = element("p", { class: "about", role: "status" });
  const hint = element("p", { class: "about" });
  const name = element("input", {
    type: "text",
    maxlength: 200,
    autocomplete: "off",
    "aria-label": words.name,
  });
  const heading = element("input", {
    type: "number",
    min: -360,
    max: 360,
    step: "any",
    placeholder: words.any_heading,
    class: "size",
  });
  heading.setAttribute("aria-label", words.heading);
  const zone_speed = element("input", {
    type: "number",
    min: 0.01,
    max: 20,
    step: 0.01,
    value: 0.2,
    class: "size",
    "aria-label": words.zone_speed,
  });
  const slow = element("label", { class: "tick", hidden: true }, zone_speed, element("span", {}, "m/s"));
  /** The place that gets another name; undefined: a new one is named. */
  let renamed: string | undefined;
  const begin_naming = (place: string | undefined) => {
    renamed = place;
    naming.hidden = false;
    facing.hidden = place !== undefined;
    name.focus();
  };
  const named = (building: Building): Building => {
    const word = name.value.trim();
    if (renamed === word) return building;
    if (renamed !== undefined) return renamed_place(building, renamed, word);
    const heading_deg = heading.value === "" ? undefined : Number(heading.value);
    return tools.place ? with_place(building, word, tools.place, heading_deg) : building;
  };
  const put_name = () => {
    if (!edit(named)) return;
    tools.place = undefined;
    naming.hidden = true;
    name.value = "";
    canvas.redraw();
  };
  const facing = element("label", { class: "tick" }, heading, element("span", {}, "°"));
  const naming = element(
    "form",
    {
      class: "buttons",
      hidden: true,
      onsubmit: (event: SubmitEvent) => {
        event.preventDefault();
        put_name();
      },
    },
    name,
    facing,
    element("button", { type: "submit", class: "primary" }, words.name_it),
  );
  const places = element("ul", { class: "places" });

  const choose = (chosen: string) => void app.notices.attempt(store.choose(chosen));
  const building_list = select(words.building, [], choose);
  const tool_list = select(words.tool, tool_labels, (tool) => {
    naming.hidden = true;
    slow.hidden = tool !== "slow_zone";
    tools.choose(tool as ToolName);
    tool_hint = tool_labels.find(({ value }) => value === tool)?.hint ?? "";
    set_text(hint, tool_hint);
  });
  let tool_hint = tool_labels[0]?.hint ?? "";
  set_text(hint, tool_hint);
  const step = (by: "undo" | "redo") => {
    history?.[by]();
    show();
  };
  const undo = button(words.undo, () => step("undo"), { "aria-keyshortcuts": "Control+Z" });
  const redo = button(words.redo, () => step("redo"), { "aria-keyshortcuts": "Control+Shift+Z Control+Y" });
  watch_undo_keys(() => app.tab.value === "building", step);
  addEventListener("beforeunload", (event) => {
    if ([...histories.values()].some(({ can_undo }) => can_undo)) event.preventDefault();
  });
  const save = button(words.save, () => void save_version(), { class: "primary" });
  const save_version = async () => {
    if (!history) return;
    const text = JSON.stringify(history.present);
    const stored = app.lease
      .take()
      .then((lease) =>
        post_text<{ building: string }>(`buildings/${encodeURIComponent(store.chosen.value)}`, text, lease),
      );
    if (!(await app.notices.attempt(stored))) return;
    const { building } = await stored;
    histories.delete(store.chosen.value);
    app.notices.show(words.saved(building));
    await app.notices.attempt(store.refresh().then(() => store.choose(building)));
  };

  const show = () => {
    const building = history?.present;
    canvas.layers = building ? [building_layer(building), tools.layer] : [];
    const extent = building && bounds_of(building_points(building));
    canvas.extent = () => extent;
    undo.disabled = !history?.can_undo;
    redo.disabled = !history?.can_redo;
    save.disabled = !history?.can_undo;
    name_buildings();
    set_text(about, building ? summary(building) : words.none);
    places.replaceChildren(...(building?.places ?? []).map((place) => place_line(place.name)));
    canvas.redraw();
  };
  const ask_name = (place: string) => {
    tools.place = undefined;
    canvas.redraw();
    begin_naming(place);
    name.value = place;
    name.select();
  };
  const place_line = (place: string) =>
    element(
      "li",
      {},
      element("span", {}, place),
      button(words.rename, () => ask_name(place), { "aria-label": words.rename_place(place) }),
      button(words.remove, () => void edit((building) => without_place(building, place)), {
        "aria-label": words.remove_place(place),
      }),
    );

  const name_buildings = () => {
    for (const option of building_list.list.options) {
      const is_unsaved = histories.get(option.value)?.can_undo ?? false;
      set_text(option, is_unsaved ? words.unsaved(option.value) : option.value);
    }
  };
  store.names.watch((names) => {
    building_list.list.replaceChildren(...names.map((value) => element("option", { value }, value)));
    building_list.list.value = store.chosen.value;
    name_buildings();
  });
  store.chosen.watch((chosen) => (building_list.list.value = chosen));
  store.building.watch((building) => {
    const name_of = store.chosen.value;
    history = building && (histories.get(name_of) ?? new UndoList(building));
    if (history) histories.set(name_of, history);
    canvas.refit();
    show();
  });

  const tab = element(
    "div",
    { class: "tab building-tab" },
    panel(words.plan, "building-plan", canvas.element),
    panel(
      words.title,
      "building-tools",
      building_list.field,
      about,
      tool_list.field,
      hint,
      naming,
      slow,
      element("div", { class: "buttons" }, undo, redo, save),
      element("h3", {}, words.places),
      places,
    ),
  );
  return {
    name: "building",
    title: text.tabs.building,
    element: tab,
    choice: { name: store.chosen, choose },
  };
}
