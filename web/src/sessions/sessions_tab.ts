import { CameraView } from "../camera/camera_view";
import type { App, Tab } from "../page/app";
import { button, element, panel } from "../page/element";
import { file_address } from "../page/server_files";
import { Signal } from "../page/signal";
import { bounds_of } from "../plan/geometry";
import { live_layers } from "../plan/live_layers";
import { LivePlan } from "../plan/live_plan";
import { PlanCanvas } from "../plan/plan_canvas";
import { replay_bar } from "./replay_bar";
import { figure_lines } from "./session_figures";
import { session_table } from "./session_list";
import { SessionStore } from "./session_store";

function download_links(name: string): HTMLElement {
  const link = (file: string) =>
    element("a", { class: "button", href: file_address(`sessions/${name}/${file}`), download: file }, file);
  return element("div", { class: "buttons" }, link("metadata.yaml"), link(`${name}_0.db3`));
}

function plan_of(app: App): HTMLElement {
  const canvas = new PlanCanvas("Plan of the session");
  const plan = new LivePlan(app.connection, () => canvas.redraw());
  canvas.layers = Object.values(live_layers(plan));
  canvas.extent = () => bounds_of(plan.points());
  canvas.followed = () => plan.pose;
  return canvas.element;
}

/** Recorded sessions: figures, download, and replay on the same topics as a drive. */
export function sessions_tab(app: App): Tab {
  const store = new SessionStore(app);
  const chosen = new Signal("");
  const table = element("div", {});
  const figures = element("dl", { class: "figures" });
  const about = element("div", { class: "player", hidden: true });
  const none = element("p", { class: "about" }, "Choose a session.");

  const show_table = () =>
    table.replaceChildren(session_table(store.sessions.value, chosen.value, (name) => (chosen.value = name)));
  const show_figures = async (name: string) => {
    const asked = app.connection.call("sessions/info", { session: name });
    if (!(await app.notices.attempt(asked)) || chosen.value !== name) return;
    const lines = figure_lines(await asked);
    figures.replaceChildren(
      ...lines.flatMap(([key, value]) => [element("dt", {}, key), element("dd", {}, value)]),
    );
  };
  const replay = (name: string) =>
    button("Replay", () => void app.notices.attempt(app.lease.call("replay/start", { session: name })), {
      class: "primary",
    });
  chosen.watch((name) => {
    show_table();
    about.hidden = name === "";
    none.hidden = name !== "";
    if (name === "") return;
    figures.replaceChildren();
    about.replaceChildren(element("div", { class: "buttons" }, replay(name)), download_links(name), figures);
    void show_figures(name);
  });
  store.sessions.watch(show_table);

  const tab = element(
    "div",
    { class: "tab sessions-tab" },
    panel("Sessions", "sessions-list", table),
    panel(
      "Replay",
      "sessions-replay",
      replay_bar(app),
      element("div", { class: "replay-views" }, new CameraView(app.connection).element, plan_of(app)),
    ),
    panel("Figures and files", "sessions-figures", none, about),
  );
  return { name: "sessions", title: "Sessions", element: tab };
}
