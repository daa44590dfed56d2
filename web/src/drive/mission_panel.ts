import type { BuildingStore } from "../building/building_store";
import type { App } from "../page/app";
import { button, element, panel, set_text, select } from "../page/element";
import { SessionStore } from "../sessions/session_store";
import { mission_forms, start_request } from "./mission_forms";
import type { MissionForm } from "./mission_forms";
import { MissionFields } from "./mission_fields";

/** Choose, start, pause and stop a mission. */
export function mission_panel(app: App, store: BuildingStore): HTMLElement {
  const sessions = new SessionStore(app);
  const about = element("p", { class: "about" });
  const place = element("div", { class: "fields" });
  let form = mission_forms[0] as MissionForm;
  let fields = new MissionFields(form, store, sessions);

  const choose = (mission: string) => {
    form = mission_forms.find((candidate) => candidate.mission === mission) ?? form;
    fields = new MissionFields(form, store, sessions);
    set_text(about, form.about);
    set_text(start, form.begin);
    place.replaceChildren(...fields.elements);
    store.is_shown.value = form.fields.some(({ kind }) => kind === "building");
  };
  const chooser = select(
    "Mission",
    mission_forms.map(({ mission, label }) => ({ value: mission, label })),
    choose,
  );
  const start = button(
    "",
    () => void app.notices.attempt(app.lease.call("mission/start", start_request(form, fields.values()))),
    { class: "primary" },
  );
  const pause = button("Pause", () => {
    const service = app.state.value?.paused ? "mission/resume" : "mission/pause";
    void app.notices.attempt(app.lease.call(service));
  });
  const stop = button("Stop", () => void app.notices.attempt(app.lease.call("mission/stop")));
  app.state.watch((state) => {
    const is_running = state?.mode === "mission";
    start.disabled = !state || state.mode !== "idle";
    pause.disabled = !is_running;
    stop.disabled = !state || state.mode === "idle";
    set_text(pause, state?.paused ? "Resume" : "Pause");
  });
  const refill = () => {
    fields.refill();
  };
  store.names.watch(refill);
  store.building.watch(refill);
  sessions.sessions.watch(refill);
  choose(form.mission);

  return panel(
    "Mission",
    "mission-panel",
    chooser.field,
    about,
    place,
    element("div", { class: "buttons" }, start, pause, stop),
  );
}
