import type { App } from "../page/app";
import { element, hold_button } from "../page/element";
import { name_pattern } from "../page/names";
import type { Signal } from "../page/signal";
import { text } from "../text";
import type { SessionStore } from "./session_store";

/** Renames the chosen session or, after a long press, deletes it. */
export function session_changes(app: App, store: SessionStore, chosen: Signal<string>): HTMLElement {
  const words = text.sessions;
  const name = element("input", {
    type: "text",
    required: true,
    pattern: name_pattern,
    autocomplete: "off",
    spellcheck: "false",
    "aria-label": words.new_name,
    placeholder: words.new_name,
  });
  const change = async (service: string, request: object, done: string, then: string) => {
    if (!(await app.notices.attempt(app.lease.call(service, request), done))) return;
    name.value = "";
    chosen.value = then;
    await app.notices.attempt(store.refresh());
  };
  const rename = (to: string) =>
    change("sessions/rename", { session: chosen.value, to }, words.renamed(to), to);
  const remove = (session: string) => change("sessions/delete", { session }, words.removed(session), "");
  return element(
    "form",
    {
      class: "buttons",
      onsubmit: (event: SubmitEvent) => {
        event.preventDefault();
        void rename(name.value);
      },
    },
    name,
    element("button", { type: "submit" }, words.rename),
    hold_button(words.remove, () => void remove(chosen.value)),
  );
}
