import { CameraView } from "../camera/camera_view";
import type { App, Tab } from "../page/app";
import { button, element, panel } from "../page/element";
import { file_address } from "../page/server_files";
import { Signal } from "../page/signal";
import { bounds_of } from "../plan/geometry";
import { shown_live } from "../plan/legend";
import { live_layers } from "../plan/live_layers";
import { PlanCanvas } from "../plan/plan_canvas";
import { text } from "../text";
import { timeline } from "../timeline/timeline";
import { replay_bar } from "./replay_bar";
import { session_changes } from "./session_changes";
import { figure_lines } from "./session_figures";
import { session_table } from "./session_list";
import type { SessionStore } from "./session_store";

function download_links(name: string, files: string[]): HTMLElement[] {
  const address = (file: string) => file_address(`sessions/${encodeURIComponent(name)}/${file}`);
  return files.map((file) => element("a", { class: "button", href: address(file), download: file }, file));
}

function plan_of(app: App): HTMLElement {
  const canvas = new PlanCanvas(text.sessions.plan);
  app.plan.watch(() => canvas.redraw());
  canvas.layers = Object.values(live_layers(app.plan));
  canvas.extent = () => bounds_of(app.plan.points());
  canvas.followed = () => app.plan.pose;
  canvas.shown = () => shown_live(app.plan, () => false);
  canvas.subject = () => app.state.value?.replay?.session ?? app.state.value?.world ?? "";
  return canvas.element;
}

/** Recorded sessions: figures, download, and replay on the same topics as a drive. */
export function sessions_tab(app: App, store: SessionStore): Tab {
  const chosen = new Signal("");
  const wanted = new Signal("");
  const table = element("div", {
    class: "table",
    tabindex: 0,
    role: "region",
    "aria-label": text.sessions.list,
  });
  const filter = element("input", { type: "search", oninput: () => (wanted.value = filter.value.trim()) });
  const figures = element("dl", { class: "figures", tabindex: 0 });
  const about = element("div", { class: "player", hidden: true });
  const none = element("p", { class: "about" }, text.sessions.choose);

  const show_table = () => {
    const choose = (name: string) => (chosen.value = name);
    table.replaceChildren(session_table(store.sessions.value, wanted.value, chosen.value, choose));
  };
  const show_figures = async (name: string) => {
    const asked = app.connection.call("sessions/info", { session: name });
    if (!(await app.notices.attempt(asked)) || chosen.value !== name) return;
    const lines = figure_lines(await asked);
    figures.replaceChildren(
      ...lines.flatMap(([key, value]) => [element("dt", {}, key), element("dd", {}, value)]),
    );
  };
  const replay = (name: string) =>
    button(
      text.sessions.replay,
      () => void app.notices.attempt(app.lease.call("replay/start", { session: name })),
      { class: "primary" },
    );
  const changes = session_changes(app, store, chosen);
  const files = element("div", { class: "buttons" });
  const show_files = () => {
    const file = store.sessions.value?.find(({ name }) => name === chosen.value)?.file;
    files.replaceChildren(
      ...download_links(chosen.value, file ? ["metadata.yaml", file] : ["metadata.yaml"]),
    );
  };
  chosen.watch((name) => {
    show_table();
    about.hidden = name === "";
    none.hidden = name !== "";
    if (name === "") return;
    figures.replaceChildren();
    about.replaceChildren(element("div", { class: "buttons" }, replay(name)), files, figures, changes);
    show_files();
    void show_figures(name);
  });
  wanted.watch(show_table);
  store.sessions.watch(() => {
    show_table();
    show_files();
  });
  const stands = () => app.state.value?.mode === "replay" && !app.state.value.replay?.playing;

  const tab = element(
    "div",
    { class: "tab sessions-tab" },
    panel(
      text.sessions.title,
      "sessions-list",
      element("label", { class: "field" }, element("span", {}, text.sessions.filter), filter),
      table,
    ),
    panel(
      text.sessions.replay,
      "sessions-replay",
      element("div", { class: "replay-views" }, new CameraView(app.connection, stands).element, plan_of(app)),
      timeline(app),
      replay_bar(app),
    ),
    panel(text.sessions.figures, "sessions-figures", none, about),
  );
  return {
    name: "sessions",
    title: text.tabs.sessions,
    element: tab,
    choice: { name: chosen, choose: (name) => (chosen.value = name) },
  };
}
