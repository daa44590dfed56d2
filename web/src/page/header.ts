import { choose_language, language, languages, text } from "../text";
import type { App, Tab } from "./app";
import { battery_mark } from "./battery";
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

/** What, where, how far, how long and who drives, and whether that is current: always visible. */
function status_line(app: App): HTMLElement {
  const words = element("span", { class: "status-words" });
  const line = element(
    "p",
    { class: "status-line" },
    element("span", { class: "lamp" }),
    words,
    battery_mark(app),
  );
  const show = () => {
    const { lamp, text: status_text } = status_of({
      connection: app.connection.state.value,
      silent_s: (performance.now() - app.connection.last_message_ms) / 1000,
      state: app.state.value ?? app.last_state,
      drives_here: app.lease.token.value !== undefined,
      at: app.plan.pose,
      delay_ms: app.lease.delay_ms.value,
    });
    line.dataset["lamp"] = lamp;
    line.title = status_text;
    document.documentElement.dataset["lamp"] = lamp;
    set_text(words, status_text);
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
    made.setAttribute("aria-label", text.theme[other]);
    made.title = text.theme[other];
    set_text(made, other === "dark" ? "☾" : "☀");
  };
  addEventListener("aisle-theme", show);
  show();
  return made;
}

function language_button(): HTMLElement {
  const other = language === "en" ? "de" : "en";
  const code = other.toUpperCase();
  return button(code, () => choose_language(other), {
    class: "theme",
    lang: other,
    title: languages[other],
    "aria-label": `${code}: ${languages[other]}`,
  });
}

export function header(app: App, tabs: Tab[]): HTMLElement {
  return element(
    "header",
    {},
    element("h1", { class: "brand" }, "aisle"),
    tab_bar(app, tabs),
    status_line(app),
    app.notices.opener,
    language_button(),
    theme_button(),
  );
}
