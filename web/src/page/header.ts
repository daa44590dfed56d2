import type { App, Tab } from "./app";
import { button, element, set_text } from "./element";
import { status_of } from "./status";
import { present_theme, toggle_theme } from "./theme";

function tab_bar(app: App, tabs: Tab[]): HTMLElement {
  const links = tabs.map(({ name, title }) => element("a", { href: `#${name}` }, title));
  app.tab.watch((shown) => {
    links.forEach((link, index) => {
      if (tabs[index]?.name === shown) link.setAttribute("aria-current", "page");
      else link.removeAttribute("aria-current");
    });
  });
  return element("nav", { "aria-label": "Tabs" }, ...links);
}

/** Connection, age of the data, who drives: always visible. */
function status_line(app: App): HTMLElement {
  const text = element("span", {});
  const line = element(
    "p",
    { class: "status-line", role: "status" },
    element("span", { class: "lamp" }),
    text,
  );
  const show = () => {
    const { lamp, text: status_text } = status_of({
      connection: app.connection.state.value,
      silent_s: (performance.now() - app.connection.last_message_ms) / 1000,
      state: app.state.value,
      drives_here: app.lease.token.value !== undefined,
    });
    line.dataset["lamp"] = lamp;
    document.documentElement.dataset["lamp"] = lamp;
    set_text(text, status_text);
  };
  app.connection.state.watch(show);
  app.state.watch(show);
  app.lease.token.watch(show);
  setInterval(show, 500);
  return line;
}

function theme_button(): HTMLElement {
  const made = button("", toggle_theme, { class: "theme" });
  const show = () => {
    const other = present_theme() === "dark" ? "light" : "dark";
    made.setAttribute("aria-label", `Switch to ${other} colours`);
    made.title = made.getAttribute("aria-label") ?? "";
    set_text(made, other === "dark" ? "☾" : "☀");
  };
  addEventListener("aisle-theme", show);
  show();
  return made;
}

/** The only control that needs no lease; visible in every tab. */
function emergency_stop(app: App): HTMLElement {
  const stop = () => void app.notices.attempt(app.connection.call("mission/emergency_stop"));
  const stop_button = button("STOP", stop, { class: "emergency", title: "Emergency stop (Escape)" });
  stop_button.setAttribute("aria-label", "Emergency stop");
  const release = button(
    "Release",
    () => void app.notices.attempt(app.lease.call("mission/emergency_release")),
    {
      class: "release",
      hidden: true,
    },
  );
  addEventListener("keydown", (event) => {
    if (event.key === "Escape") stop();
  });
  app.connection.state.watch((connection) => (stop_button.disabled = connection !== "connected"));
  app.state.watch((state) => {
    const stopped = state?.emergency ?? false;
    stop_button.classList.toggle("stopped", stopped);
    set_text(stop_button, stopped ? "STOPPED" : "STOP");
    release.hidden = !stopped;
  });
  return element("div", { class: "stopper" }, release, stop_button);
}

export function header(app: App, tabs: Tab[]): HTMLElement {
  return element(
    "header",
    {},
    element("strong", { class: "brand" }, "aisle"),
    tab_bar(app, tabs),
    status_line(app),
    theme_button(),
    emergency_stop(app),
  );
}
