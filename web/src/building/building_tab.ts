import type { App, Tab } from "../page/app";
import { button, element, panel, set_text, select } from "../page/element";
import { post_text } from "../page/server_files";
import { UndoList } from "../page/undo_list";
import { building_points } from "../plan/building_geometry";
import { building_layer } from "../plan/building_layer";
import { bounds_of } from "../plan/geometry";
import { PlanCanvas } from "../plan/plan_canvas";
import { with_place, without_place } from "./building_edits";
import type { Building } from "./building_file";
import { BuildingStore } from "./building_store";
import { BuildingTools, tool_labels } from "./building_tools";
import type { ToolName } from "./building_tools";

/** The contents of a building in words. */
function summary({ walls, landmarks, routes, places, barriers, floor }: Building): string {
  const count = (parts: unknown[] | undefined, one: string, many: string) =>
    parts?.length ? `${parts.length} ${parts.length === 1 ? one : many}` : "";
  const known = [
    count(walls, "wall", "walls"),
    count(landmarks, "landmark", "landmarks"),
    count(routes, "route", "routes"),
    count(places, "place", "places"),
    count(barriers, "drawn line", "drawn lines"),
    floor ? "floor" : "",
  ].filter(Boolean);
  return known.join(", ") || "nothing yet";
}

/** Shows a building and edits it; saving makes a new version. */
export function building_tab(app: App): Tab {
  const store = new BuildingStore(app);
  const canvas = new PlanCanvas("Plan of the building");
  canvas.hide_follow();
  let history: UndoList<Building> | undefined;

  const tools = new BuildingTools(canvas, {
    building: () => history?.present,
    edit: (change) => edit(change),
    pick_place: () => {
      naming.hidden = false;
      name.focus();
    },
  });
  const edit = (change: (building: Building) => Building): boolean => {
    if (!history) return false;
    try {
      history.put(change(history.present));
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
    "aria-label": "Name of the place",
  });
  const heading = element("input", { type: "number", min: -360, max: 360, step: 5, value: 0, class: "size" });
  heading.setAttribute("aria-label", "Heading in degrees");
  const put_place = () => {
    const at = tools.place;
    if (!at || !edit((building) => with_place(building, name.value.trim(), at, Number(heading.value))))
      return;
    tools.place = undefined;
    naming.hidden = true;
    name.value = "";
    canvas.redraw();
  };
  const naming = element(
    "form",
    {
      class: "buttons",
      hidden: true,
      onsubmit: (event: SubmitEvent) => {
        event.preventDefault();
        put_place();
      },
    },
    name,
    element("label", { class: "tick" }, heading, element("span", {}, "°")),
    element("button", { type: "submit", class: "primary" }, "Name it"),
  );
  const places = element("ul", { class: "places" });

  const building_list = select("Building", [], (chosen) => void app.notices.attempt(store.choose(chosen)));
  const tool_list = select("Tool", tool_labels, (tool) => {
    naming.hidden = true;
    tools.choose(tool as ToolName);
    set_text(hint, tool_labels.find(({ value }) => value === tool)?.hint ?? "");
  });
  set_text(hint, tool_labels[0]?.hint ?? "");
  const undo = button("Undo", () => {
    history?.undo();
    show();
  });
  const redo = button("Redo", () => {
    history?.redo();
    show();
  });
  const save = button("Save as a new version", () => void save_version(), { class: "primary" });
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
    app.notices.show(`Saved as ${building}`);
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
    set_text(
      about,
      building ? summary(building) : "No building yet: explore one, or teach and learn a route.",
    );
    places.replaceChildren(...(building?.places ?? []).map((place) => place_line(place.name)));
    canvas.redraw();
  };
  const place_line = (place: string) =>
    element(
      "li",
      {},
      element("span", {}, place),
      button("Delete", () => void edit((building) => without_place(building, place)), {
        "aria-label": `Delete the place ${place}`,
      }),
    );

  store.names.watch((names) => {
    building_list.list.replaceChildren(...names.map((value) => element("option", { value }, value)));
    building_list.list.value = store.chosen.value;
  });
  store.chosen.watch((chosen) => (building_list.list.value = chosen));
  store.building.watch((building) => {
    history = building && new UndoList(building);
    canvas.refit();
    show();
  });

  const tab = element(
    "div",
    { class: "tab building-tab" },
    panel("Plan", "building-plan", canvas.element),
    panel(
      "Edit",
      "building-tools",
      building_list.field,
      about,
      tool_list.field,
      hint,
      naming,
      element("div", { class: "buttons" }, undo, redo, save),
      element("h3", {}, "Places"),
      places,
    ),
  );
  return { name: "building", title: "Building", element: tab };
}
