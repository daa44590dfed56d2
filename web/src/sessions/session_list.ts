import { button, element } from "../page/element";
import { short_duration } from "../page/status";
import { text } from "../text";
import { short_bytes } from "./session_figures";
import type { SessionEntry } from "./session_store";

const numeric = [false, false, false, false, true, true];

function head(): HTMLElement {
  const cells = text.sessions.columns.map((label, column) =>
    element("th", { scope: "col", class: numeric[column] ? "number" : undefined }, label),
  );
  return element("thead", {}, element("tr", {}, ...cells));
}

function date_text(seconds: number | undefined): string {
  return seconds
    ? new Date(seconds * 1000).toLocaleString(undefined, { dateStyle: "short", timeStyle: "short" })
    : "";
}

function row(session: SessionEntry, is_chosen: boolean, choose: () => void): HTMLElement {
  const cells = [
    button(session.name, choose),
    session.navigator,
    session.route,
    date_text(session.recorded_s),
    short_duration(session.duration_s),
    short_bytes(session.bytes),
  ];
  return element(
    "tr",
    { class: is_chosen ? "chosen" : undefined },
    ...cells.map((cell, column) => element("td", { class: numeric[column] ? "number" : undefined }, cell)),
  );
}

/**
 * The sessions whose names contain `wanted` as a table; a click on a name chooses one.
 * @param sessions undefined: they were not read yet
 */
export function session_table(
  sessions: readonly SessionEntry[] | undefined,
  wanted: string,
  chosen: string,
  choose: (name: string) => void,
): HTMLElement {
  const about = (words: string) => element("p", { class: "about" }, words);
  if (!sessions) return about(text.sessions.loading);
  if (sessions.length === 0) return about(text.sessions.none);
  const found = sessions.filter(({ name }) => name.toLowerCase().includes(wanted.toLowerCase()));
  if (found.length === 0) return about(text.sessions.no_match);
  const rows = found.map((session) => row(session, session.name === chosen, () => choose(session.name)));
  return element("table", {}, head(), element("tbody", {}, ...rows));
}
