import type { App } from "../page/app";
import { button, element, panel, set_text } from "../page/element";
import { text } from "../text";
import { drive_pad } from "./pad";
import { vehicle_shape } from "./vehicle_text";

/** Set marks while teaching a route, and finish the drive. */
function mark_fields(app: App): HTMLFieldSetElement {
  const { lease, notices } = app;
  const words = text.hand;
  const label = element("input", {
    type: "text",
    maxlength: 64,
    placeholder: words.name_or_number,
    autocomplete: "off",
    "aria-label": words.mark_name,
  });
  const mark = (kind: string, name: () => string) => () =>
    void notices.attempt(lease.call("mission/mark", { kind, label: name() }), words.marked(kind));
  const named = () => label.value.trim();
  return element(
    "fieldset",
    { class: "marks" },
    element("legend", {}, words.marks),
    label,
    button(words.place, mark("place", named)),
    button(words.turning_begins, mark("turning begins", named)),
    button(words.turning_ends, mark("turning ends", named)),
    button(
      words.route_ends,
      mark("stop", () => ""),
    ),
    button(words.finish, () => void notices.attempt(lease.call("mission/finish"), words.finished)),
  );
}

/** Take the controls and drive. @returns the panel, and the pad with the speed, which have a place of their own */
export function hand_panel(app: App): { panel: HTMLElement; steering: HTMLElement } {
  const { driver, lease, notices } = app;
  const words = text.hand;
  const take = button(
    words.take,
    () => void notices.attempt(lease.token.value === undefined ? lease.take() : lease.release()),
    { class: "primary" },
  );
  const hint = element("p", { class: "about" });
  const pad = drive_pad((request) => driver.press("pad", request));
  const pace = element("input", {
    type: "range",
    min: 0.1,
    max: 1,
    step: 0.1,
    value: driver.pace,
    oninput: () => (driver.pace = Number(pace.value)),
  });
  const marks = mark_fields(app);

  const show = () => {
    const { driven_by_hand = false, mode, emergency = false } = app.state.value ?? {};
    const drives = lease.token.value !== undefined;
    const can_drive = drives && driven_by_hand && !emergency;
    set_text(take, drives ? words.give : words.take);
    take.classList.toggle("primary", !drives);
    set_text(
      hint,
      !drives ? words.watch : !driven_by_hand ? words.refused : emergency ? words.stopped : words.how,
    );
    document.documentElement.toggleAttribute("data-drives", can_drive);
    pad.classList.toggle("off", !can_drive);
    marks.hidden = !(driven_by_hand && mode === "mission");
    marks.disabled = !drives;
  };
  lease.token.watch(show);
  app.state.watch(show);
  app.connection.listen("/vehicle_description", (message) => {
    driver.vehicle = vehicle_shape((message as { data: string }).data);
  });

  return {
    panel: panel(words.title, "hand-panel", element("div", { class: "buttons" }, take), hint, marks),
    steering: element(
      "div",
      { class: "steering" },
      pad,
      element("label", { class: "field pace" }, element("span", {}, words.speed), pace),
    ),
  };
}
