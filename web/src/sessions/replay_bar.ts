import type { App } from "../page/app";
import { button, element, set_text, select } from "../page/element";
import { text } from "../text";

const rates = ["0.5", "1", "2", "5", "20"].map((value) => ({ value, label: `${value} x` }));

/** Controls of the running replay: play, pause, seek, rate, end. While the slider moves, the views follow it. */
export function replay_bar(app: App): HTMLElement {
  const words = text.sessions;
  const ask = (service: string, request: object = {}) =>
    app.notices.attempt(app.lease.call(service, request));
  const play = button(
    words.pause,
    () => void ask(app.state.value?.replay?.playing ? "replay/pause" : "replay/play"),
  );
  const clock = element("span", { class: "position" });
  const rate = select(words.rate, rates, (value) => void ask("replay/rate", { rate: Number(value) }));
  rate.list.value = "1";
  const slider = element("input", {
    type: "range",
    min: 0,
    max: 1,
    step: 0.1,
    value: 0,
    "aria-label": words.time,
  });

  /** The newest time that was asked for; one seek is on its way at a time. */
  let wanted_s: number | undefined;
  let is_seeking = false;
  const seek = async () => {
    wanted_s = Number(slider.value) - Number(slider.min);
    if (is_seeking) return;
    is_seeking = true;
    while (wanted_s !== undefined) {
      const to_s: number = wanted_s;
      if (!(await ask("replay/seek", { to_s }))) wanted_s = undefined;
      if (wanted_s === to_s) wanted_s = undefined;
    }
    is_seeking = false;
    await app.plan.fetch_trail();
  };
  slider.addEventListener("input", () => void seek());

  const bar = element(
    "div",
    { class: "replay", hidden: true },
    play,
    slider,
    clock,
    rate.field,
    button(words.end, () => void ask("replay/stop")),
  );
  const none = element("p", { class: "about" }, words.live);
  app.state.watch((state) => {
    const replay = state?.mode === "replay" ? state.replay : undefined;
    bar.hidden = replay === undefined;
    none.hidden = replay !== undefined;
    if (!replay) return;
    set_text(play, replay.playing ? words.pause : words.play);
    set_text(
      clock,
      words.of((replay.at_s - replay.from_s).toFixed(1), (replay.to_s - replay.from_s).toFixed(1)),
    );
    slider.min = String(replay.from_s);
    slider.max = String(replay.to_s);
    slider.setAttribute("aria-valuetext", clock.textContent);
    if (!is_seeking && !slider.matches(":active")) slider.value = String(replay.at_s);
  });
  return element("div", {}, none, bar);
}
