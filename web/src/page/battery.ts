import { json_of } from "../connection/live_state";
import { text } from "../text";
import type { App } from "./app";
import { element, set_text } from "./element";

/** The server says it again every two seconds while it is true. */
const old_after_s = 10;
const look_every_ms = 500;

/** The charge of the robot's battery: dimmed when it is old, hidden where no robot speaks of one. */
export function battery_mark(app: App): HTMLElement {
  const percent = element("span");
  const mark = element(
    "span",
    { class: "battery", hidden: true },
    element("span", { class: "battery-word" }, `${text.status.battery} `),
    percent,
  );
  let charge: number | undefined;
  let since_ms = 0;
  const show = () => {
    mark.hidden = charge === undefined;
    if (charge === undefined) return;
    const age_s = (performance.now() - since_ms) / 1000;
    const is_old = age_s > old_after_s;
    const words = `${Math.round(100 * charge)} %`;
    mark.classList.toggle("old", is_old);
    mark.title = `${text.status.battery} ${is_old ? `${words}, ${text.ago(text.age(age_s))}` : words}`;
    set_text(percent, words);
  };
  app.connection.listen("/battery", (message) => {
    ({ charge } = json_of<{ charge: number }>(message));
    since_ms = performance.now();
    show();
  });
  setInterval(show, look_every_ms);
  return mark;
}
