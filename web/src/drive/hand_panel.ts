import type { App } from "../page/app";
import { button, element, panel, set_text } from "../page/element";
import { vehicle_shape } from "./vehicle_text";
import { drive_pad } from "./pad";

/** Take the controls and drive; while teaching a route, set marks. */
export function hand_panel(app: App): HTMLElement {
  const { driver, lease, notices } = app;
  const take = button(
    "Take the controls",
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
  const label = element("input", {
    type: "text",
    maxlength: 64,
    placeholder: "name or number",
    autocomplete: "off",
  });
  label.setAttribute("aria-label", "Name or number of the mark");
  const mark = (kind: string, text: string) => () =>
    void notices.attempt(lease.call("mission/mark", { kind, label: text }), `Marked: ${kind}`);
  const marks = element(
    "fieldset",
    { class: "marks" },
    element("legend", {}, "Marks"),
    label,
    button("Place", () => mark("place", label.value.trim())()),
    button("Turning begins", () => mark("turning begins", label.value.trim())()),
    button("Turning ends", () => mark("turning ends", label.value.trim())()),
    button("Route ends", () => mark("stop", "")()),
  );
  const finish = button("Finish", () => void notices.attempt(lease.call("mission/finish"), "Finished"));

  const show = () => {
    const drives = lease.token.value !== undefined;
    const accepts_commands = app.state.value?.driven_by_hand ?? false;
    const in_mission = app.state.value?.mode === "mission";
    set_text(take, drives ? "Give the controls back" : "Take the controls");
    take.classList.toggle("primary", !drives);
    const refused = "The mission is driving. Stop it to drive by hand.";
    const how = "Hold the arrow keys, drag on the pad or use a gamepad. The vehicle stops when you let go.";
    set_text(
      hint,
      !drives
        ? "One client at a time holds the controls; all others can watch."
        : accepts_commands
          ? how
          : refused,
    );
    pad.classList.toggle("off", !drives || !accepts_commands);
    marks.disabled = !drives || !accepts_commands || !in_mission;
    finish.disabled = !drives || !accepts_commands || !in_mission;
  };
  lease.token.watch(show);
  app.state.watch(show);
  app.connection.listen("/vehicle_description", (message) => {
    driver.vehicle = vehicle_shape((message as { data: string }).data);
  });

  return panel(
    "By hand",
    "hand-panel",
    element("div", { class: "buttons" }, take, finish),
    hint,
    element(
      "div",
      { class: "steering" },
      pad,
      element("label", { class: "field pace" }, element("span", {}, "Speed"), pace),
    ),
    marks,
  );
}
