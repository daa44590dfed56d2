import { button, element, set_text } from "../page/element";
import { Kept } from "../page/kept";
import { unit } from "../page/units";
import { text } from "../text";

const words = text.plan;

/** Whether every plan shows its grid, and its legend. */
export const grid = new Kept("aisle.grid", ["off", "on"]);
export const legend = new Kept("aisle.legend", ["off", "on"]);

function kept_switch(label: string, shown: Kept<"off" | "on">): HTMLButtonElement {
  const made = button(label, () => shown.choose_next());
  shown.watch((value) => made.setAttribute("aria-pressed", String(value === "on")));
  return made;
}

function unit_button(): HTMLButtonElement {
  const made = button("", () => unit.choose_next());
  unit.watch((chosen) => {
    const other = chosen === "m" ? "ft" : "m";
    set_text(made, other);
    made.title = `${other}: ${words.unit[chosen]}`;
    made.setAttribute("aria-label", made.title);
  });
  return made;
}

/**
 * The buttons that are used now and then, behind a button of their own.
 * @param measure switches measuring on and off
 * @param save saves the plan as a picture
 */
export function more_tools(measure: (on: boolean) => void, save: () => void): HTMLElement[] {
  const measuring = button(words.measure, () => set_measuring(measuring.ariaPressed !== "true"), {
    "aria-pressed": "false",
    title: words.measure_keys,
  });
  const set_measuring = (on: boolean) => {
    measuring.setAttribute("aria-pressed", String(on));
    measure(on);
  };
  const tools = element(
    "div",
    { class: "more-tools", hidden: true },
    measuring,
    kept_switch(words.grid, grid),
    kept_switch(words.legend, legend),
    unit_button(),
    button(words.picture, save, { title: words.save_picture }),
  );
  const more = button(
    words.more,
    () => {
      tools.hidden = !tools.hidden;
      more.setAttribute("aria-expanded", String(!tools.hidden));
      if (tools.hidden) set_measuring(false);
    },
    { "aria-expanded": "false" },
  );
  return [more, tools];
}
