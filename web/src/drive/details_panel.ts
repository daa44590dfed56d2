import { json_of } from "../connection/live_state";
import type { LiveState } from "../connection/live_state";
import type { PoseWithCovarianceStamped } from "../connection/messages";
import type { App } from "../page/app";
import { element, panel, set_text } from "../page/element";
import { ellipse_of } from "../plan/geometry";

interface Decision {
  command: { speed_mps: number; steering_rad: number; turn_rate_rad_s: number };
  status: string;
  state: string;
  why: string;
}

interface Match {
  quality: number;
  text: string;
}

/** The last step of the exploring navigator's transducer: the JSON of /transducer. */
interface TransducerView {
  state: string;
  input: string;
  output: string;
  stack: string[];
}

const degrees = 180 / Math.PI;

function row(label: string): { term: HTMLElement; value: HTMLElement } {
  return { term: element("dt", {}, label), value: element("dd", {}, "–") };
}

function progress_text(state: LiveState): string {
  if (state.mode === "work") return state.total > 0 ? `${state.done} of ${state.total}` : "working";
  return `${state.stamp_s.toFixed(1)} s`;
}

/** State and reason, pose with its uncertainty, the transducer's stack, and how the last mission ended. */
export function state_panel(app: App): HTMLElement {
  const rows = {
    task: row("Task"),
    clock: row("Clock"),
    state: row("State"),
    why: row("Why"),
    command: row("Command"),
    pose: row("Pose"),
    match: row("Match"),
  };
  const stack = element("ol", { class: "stack", "aria-label": "Stack, top first" });
  const rule = element("p", { class: "rule" });
  const transducer = element(
    "div",
    { class: "transducer", hidden: true },
    element("h3", {}, "Transducer"),
    rule,
    stack,
  );
  const last = element("p", { class: "last", hidden: true });

  const show_match = (is_known: boolean) => {
    for (const part of Object.values(rows.match)) part.hidden = !is_known;
  };
  show_match(false);

  app.state.watch((state) => {
    set_text(
      rows.task.value,
      state ? [state.mode, state.mission, state.task].filter(Boolean).join(" · ") : "–",
    );
    set_text(rows.clock.value, state ? progress_text(state) : "–");
    last.hidden = !state?.last;
    if (!state?.last) return;
    const { mission, ok, text, problems } = state.last;
    last.dataset["ok"] = String(ok);
    set_text(
      last,
      `Last: ${mission} ${ok ? "done" : "not done"}. ${[text, ...problems].filter(Boolean).join("\n")}`,
    );
  });
  app.connection.listen("/decision", (message) => {
    const { command, state, why, status } = json_of<Decision>(message);
    set_text(rows.state.value, status === "going" ? state : `${state} (${status})`);
    set_text(rows.why.value, why === "" ? "–" : why);
    const turn = command.turn_rate_rad_s !== 0 ? command.turn_rate_rad_s : command.steering_rad;
    const unit = command.turn_rate_rad_s !== 0 ? "°/s" : "°";
    set_text(
      rows.command.value,
      `${command.speed_mps.toFixed(2)} m/s, ${(turn * degrees).toFixed(1)}${unit}`,
    );
  });
  app.connection.listen("/pose", (message) => {
    const { pose, covariance } = (message as PoseWithCovarianceStamped).pose;
    const { a_m } = ellipse_of(covariance[0] ?? 0, covariance[1] ?? 0, covariance[7] ?? 0);
    const heading = Math.sqrt(Math.max(0, covariance[35] ?? 0)) * degrees;
    const { x, y } = pose.position;
    const sigma = a_m > 0 ? ` · σ ${(a_m * 100).toFixed(1)} cm, ${heading.toFixed(1)}°` : "";
    set_text(rows.pose.value, `${x.toFixed(2)}, ${y.toFixed(2)} m${sigma}`);
  });
  app.connection.listen("/match", (message) => {
    const { quality, text } = json_of<Match>(message);
    show_match(true);
    set_text(rows.match.value, `${Math.round(quality * 100)} % · ${text}`);
  });
  app.connection.listen("/transducer", (message) => {
    const { state, input, output, stack: symbols } = json_of<TransducerView>(message);
    transducer.hidden = false;
    set_text(rule, `${state}: ${input} → ${output}`);
    stack.replaceChildren(...symbols.toReversed().map((symbol) => element("li", {}, symbol)));
  });
  app.connection.listen("/session", () => {
    transducer.hidden = true;
    show_match(false);
    for (const { value } of [rows.state, rows.why, rows.command, rows.pose, rows.match]) set_text(value, "–");
  });

  const list = element("dl", {}, ...Object.values(rows).flatMap(({ term, value }) => [term, value]));
  return panel("State", "state-panel", list, transducer, last);
}
