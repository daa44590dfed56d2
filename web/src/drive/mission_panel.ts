import type { BuildingStore } from "../building/building_store";
import type { App, Choice } from "../page/app";
import { button, element, panel, set_text, select } from "../page/element";
import { notify_switch } from "../page/elsewhere";
import { Signal } from "../page/signal";
import { short_duration } from "../page/status";
import { length_text } from "../page/units";
import type { SessionStore } from "../sessions/session_store";
import { text } from "../text";
import { mission_forms, start_request } from "./mission_forms";
import type { MissionForm } from "./mission_forms";
import { MissionFields } from "./mission_fields";

/** The form of the mission that is chosen; while one runs, how far it is, and how to pause and end it. */
export function mission_panel(
  app: App,
  store: BuildingStore,
  sessions: SessionStore,
): { panel: HTMLElement; choice: Choice } {
  const about = element("p", { class: "about" });
  const place = element("div", { class: "fields" });
  const keeps_buildings = () => app.state.value?.keeps_buildings ?? false;
  let form = mission_forms[0] as MissionForm;
  const chosen = new Signal(form.mission);
  let fields = new MissionFields(form, store, sessions, keeps_buildings);
  const needs_building = () => form.fields.some(({ kind }) => kind === "building");

  const choose = (mission: string) => {
    form = mission_forms.find((candidate) => candidate.mission === mission) ?? form;
    chooser.list.value = form.mission;
    chosen.value = form.mission;
    fields = new MissionFields(form, store, sessions, keeps_buildings);
    set_text(about, form.about);
    set_text(start, form.begin);
    place.replaceChildren(...fields.elements);
    store.is_shown.value = needs_building();
    store.takes_goals.value = form.mission === "go";
  };
  const chooser = select(
    text.mission.title,
    mission_forms.map(({ mission, label }) => ({ value: mission, label })),
    choose,
  );
  const start = element("button", { type: "submit", class: "primary" });
  const begin = () =>
    void app.notices.attempt(app.lease.call("mission/start", start_request(form, fields.values())));
  const choice = element(
    "form",
    {
      class: "fields",
      onsubmit: (event: SubmitEvent) => {
        event.preventDefault();
        begin();
      },
    },
    chooser.field,
    about,
    place,
    element("div", { class: "buttons" }, start),
  );

  const progress = element("p", { class: "progress" });
  const pause = button(text.mission.pause, () => void app.notices.attempt(app.lease.call("mission/pause")));
  const end = button(text.mission.end, () => void app.notices.attempt(app.lease.call("mission/stop")));
  const running = element(
    "div",
    { class: "fields" },
    progress,
    element("div", { class: "buttons" }, pause, end),
    notify_switch(app.notices),
  );

  app.state.watch((state) => {
    const is_idle = state?.mode === "idle";
    choice.hidden = state !== undefined && !is_idle;
    running.hidden = !state || is_idle || state.mode === "ended";
    start.disabled = !is_idle;
    pause.disabled = state?.mode !== "mission" || state.paused;
    if (!state || is_idle) return;
    const { mode, mission, task, done, total, distance_m = 0, stamp_s } = state;
    const area = mode === "mission" ? app.plan.free_floor_text() : "";
    const way =
      mode === "mission"
        ? text.mission.progress(length_text(distance_m, 1), short_duration(stamp_s))
        : text.mission.computing(done, total);
    set_text(progress, [mission || mode, task, way, area].filter(Boolean).join(" · "));
  });
  let known = "";
  app.state.watch((state) => {
    const is_idle = state?.mode === "idle";
    const news = `${state?.mode} ${state?.keeps_buildings}`;
    if (news === known) return;
    known = news;
    fields.refill();
    store.is_shown.value = is_idle && needs_building();
  });
  const refill = () => {
    fields.refill();
  };
  store.names.watch(refill);
  store.building.watch(refill);
  sessions.sessions.watch(refill);
  choose(form.mission);

  return {
    panel: panel(text.mission.title, "mission-panel", choice, running),
    choice: { name: chosen, choose },
  };
}
