import { CameraView } from "../camera/camera_view";
import type { App, Tab } from "../page/app";
import { button, element, panel } from "../page/element";
import { file_address } from "../page/server_files";
import { Signal } from "../page/signal";
import { bounds_of } from "../plan/geometry";
import { live_layers } from "../plan/live_layers";
import { PlanCanvas } from "../plan/plan_canvas";
import { text } from "../text";
import { replay_bar } from "./replay_bar";
import { figure_lines } from "./session_figures";
import { session_table } from "./session_list";
import type { SessionStore } from "./session_store";

function download_links(name: string, files: string[]): HTMLElement {
  const link = (file: string) =>
    element("a", { class: "button", href: file_address(`sessions/${name}/${file}`), download: file }, file);
  return element("div", { class: "buttons" }, ...files.map(link));
}

function plan_of(app: App): HTMLElement {
  const canvas = new PlanCanvas(text.sessions.plan);
  app.plan.watch(() => canvas.redraw());
  canvas.layers = Object.values(live_layers(app.plan));
  canvas.extent = () => bounds_of(app.plan.points());
  canvas.followed = () => app.plan.pose;
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
  chosen.watch((name) => {
    show_table();
    about.hidden = name === "";
    none.hidden = name !== "";
    if (name === "") return;
    const file = store.sessions.value?.find((session) => session.name === name)?.file;
    figures.replaceChildren();
    about.replaceChildren(
      element("div", { class: "buttons" }, replay(name)),
      download_links(name, file ? ["metadata.yaml", file] : ["metadata.yaml"]),
      figures,
    );
    void show_figures(name);
  });
  wanted.watch(show_table);
  store.sessions.watch(show_table);
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
      replay_bar(app),
    ),
    panel(text.sessions.figures, "sessions-figures", none, about),
  );
  return { name: "sessions", title: text.tabs.sessions, element: tab };
}
