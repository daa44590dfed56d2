import { text } from "../text";
import type { App } from "./app";
import { button, element, hold_button, set_text } from "./element";

/** The only control that needs no lease: visible in every tab, and always at the same place in the same size. */
export function emergency_stop(app: App): HTMLElement {
  const stop = () => void app.notices.attempt(app.connection.call("mission/emergency_stop"));
  const made = button(text.stop.stop, stop, { class: "emergency", title: text.stop.hint });
  addEventListener(
    "keydown",
    (event) => {
      if (event.key === "Escape") stop();
    },
    { capture: true },
  );
  app.connection.state.watch((connection) => (made.disabled = connection !== "connected"));
  app.state.watch((state) => {
    const is_stopped = state?.emergency ?? false;
    made.classList.toggle("stopped", is_stopped);
    made.setAttribute("aria-pressed", String(is_stopped));
    made.setAttribute("aria-label", is_stopped ? `${text.stop.name}: ${text.stop.stopped}` : text.stop.name);
    set_text(made, is_stopped ? text.stop.stopped : text.stop.stop);
  });
  return made;
}

/** What can be done with a vehicle that was stopped or paused; never near the stop button, and only by a long press. */
export function held_bar(app: App): HTMLElement {
  const { lease, notices } = app;
  const release = () => lease.call("mission/emergency_release");
  const is_stopped = () => app.state.value?.emergency ?? false;
  const release_if_stopped = async () => {
    if (is_stopped()) await release();
  };
  const words = element("span", {});
  const resume = hold_button(
    text.held.resume,
    () => void notices.attempt(release_if_stopped().then(() => lease.call("mission/resume"))),
  );
  const take_over = hold_button(text.held.take_over, () => {
    location.hash = "drive";
    void notices.attempt(lease.call("mission/stop").then(release_if_stopped));
  });
  const end = button("", () => void notices.attempt(lease.call("mission/stop")));
  const release_button = hold_button(text.held.release, () => void notices.attempt(release()));
  const bar = element(
    "section",
    { class: "held-bar", "aria-label": text.held.title, hidden: true },
    words,
    resume,
    take_over,
    end,
    release_button,
  );
  app.state.watch((state) => {
    const in_mission = state?.mode === "mission";
    const is_held = in_mission && state.paused;
    bar.hidden = !is_held && !is_stopped();
    for (const choice of [resume, take_over, end]) choice.hidden = !is_held;
    release_button.hidden = is_held;
    set_text(words, is_stopped() ? text.held.stopped : text.held.paused);
    set_text(
      end,
      state?.mission === "explore" && state.keeps_buildings ? text.held.end : text.held.end_other,
    );
  });
  return bar;
}
