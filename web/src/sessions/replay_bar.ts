import type { App } from "../page/app";
import { button, element, set_text, select } from "../page/element";

const rates = ["0.5", "1", "2", "5", "20"].map((value) => ({ value, label: `${value} x` }));

/** Controls of the running replay: play, pause, seek, rate, end. */
export function replay_bar(app: App): HTMLElement {
  const ask = (service: string, request: object = {}) =>
    void app.notices.attempt(app.lease.call(service, request));
  const play = button("Pause", () => ask(app.state.value?.replay?.playing ? "replay/pause" : "replay/play"));
  const clock = element("span", { class: "position" });
  const rate = select("Rate", rates, (value) => ask("replay/rate", { rate: Number(value) }));
  rate.list.value = "1";
  let is_scrubbing = false;
  const slider = element("input", {
    type: "range",
    min: 0,
    max: 1,
    step: 0.1,
    value: 0,
    "aria-label": "Time",
  });
  slider.addEventListener("input", () => (is_scrubbing = true));
  slider.addEventListener("change", () => {
    is_scrubbing = false;
    ask("replay/seek", { to_s: Number(slider.value) - Number(slider.min) });
  });
  const bar = element(
    "div",
    { class: "replay", hidden: true },
    play,
    slider,
    clock,
    rate.field,
    button("End the replay", () => ask("replay/stop")),
  );
  const none = element("p", { class: "about" }, "No replay is running: this shows the vehicle as it is now.");
  app.state.watch((state) => {
    const replay = state?.mode === "replay" ? state.replay : undefined;
    bar.hidden = replay === undefined;
    none.hidden = replay !== undefined;
    if (!replay) return;
    set_text(play, replay.playing ? "Pause" : "Play");
    set_text(
      clock,
      `${(replay.at_s - replay.from_s).toFixed(1)} of ${(replay.to_s - replay.from_s).toFixed(1)} s`,
    );
    slider.min = String(replay.from_s);
    slider.max = String(replay.to_s);
    if (!is_scrubbing) slider.value = String(replay.at_s);
  });
  return element("div", {}, none, bar);
}
