import { button, element } from "../page/element";
import { short_bytes, short_duration } from "./session_figures";
import type { SessionEntry } from "./session_store";

function head(...columns: [string, boolean][]): HTMLElement {
  const cells = columns.map(([label, is_number]) =>
    element("th", { scope: "col", class: is_number ? "number" : undefined }, label),
  );
  return element("thead", {}, element("tr", {}, ...cells));
}

/** All sessions as a table; a click on a name chooses one. */
export function session_table(
  sessions: readonly SessionEntry[],
  chosen: string,
  choose: (name: string) => void,
): HTMLElement {
  if (sessions.length === 0) {
    return element(
      "p",
      { class: "about" },
      "No sessions yet: give a drive or a taught run a name to record it.",
    );
  }
  const rows = sessions.map((session) =>
    element(
      "tr",
      { "aria-selected": session.name === chosen },
      element(
        "td",
        {},
        button(session.name, () => choose(session.name), { title: session.name }),
      ),
      element("td", {}, session.navigator),
      element("td", {}, session.route),
      element("td", { class: "number" }, short_duration(session.duration_s)),
      element("td", { class: "number" }, short_bytes(session.bytes)),
    ),
  );
  return element(
    "div",
    { class: "table" },
    element(
      "table",
      {},
      head(["Name", false], ["By", false], ["Route", false], ["Length", true], ["Size", true]),
      element("tbody", {}, ...rows),
    ),
  );
}
