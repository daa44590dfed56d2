import { json_of } from "../connection/live_state";
import type { PoseWithCovarianceStamped } from "../connection/messages";
import type { App } from "../page/app";
import { Age } from "../page/age";
import { element, set_text } from "../page/element";
import { position_text, speed_text } from "../page/units";
import { text } from "../text";
import { plot } from "./plot";
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

interface Row {
  term: HTMLElement;
  cell: HTMLElement;
  value: HTMLElement;
  age: HTMLElement;
}

function row(label: string): Row {
  const value = element("span", {}, "–");
  const age = element("span", { class: "age", hidden: true });
  return { term: element("dt", {}, label), cell: element("dd", {}, value, " ", age), value, age };
}

/** Folded away: state and reason, pose with its uncertainty, the transducer's stack, and the plan's layers. */
export function details_panel(app: App, layers: HTMLElement): HTMLElement {
  const words = text.details;
  const rows = {
    task: row(words.task),
    clock: row(words.clock),
    state: row(words.state),
    why: row(words.why),
    command: row(words.command),
    pose: row(words.pose),
    match: row(words.match),
  };
  const stands = () => {
    const state = app.state.value;
    return state?.mode === "replay" && !state.replay?.playing;
  };
  const age_of = ({ cell, age }: Row) => new Age(cell, age, stands, text.ago);
  const decided = [rows.state, rows.why, rows.command].map(age_of);
  const [pose_age, match_age] = [age_of(rows.pose), age_of(rows.match)];
  const stack = element("ol", { class: "stack", "aria-label": words.stack });
  const rule = element("p", { class: "rule" });
  const transducer = element(
    "div",
    { class: "transducer", hidden: true },
    element("h3", {}, words.transducer),
    rule,
    stack,
  );

  const show_match = (is_known: boolean) => {
    for (const part of [rows.match.term, rows.match.cell]) part.hidden = !is_known;
  };
  show_match(false);

  app.state.watch((state) => {
    set_text(
      rows.task.value,
      state ? [state.mode, state.mission, state.task].filter(Boolean).join(" · ") : "–",
    );
    set_text(rows.clock.value, state ? `${state.stamp_s.toFixed(1)} s` : "–");
    if (state?.paused) set_text(rows.command.value, words.stands(speed_text(0)));
  });
  app.connection.listen("/decision", (message) => {
    const { command, state, why, status } = json_of<Decision>(message);
    for (const age of decided) age.renew();
    set_text(rows.state.value, status === "going" ? state : `${state} (${status})`);
    set_text(rows.why.value, why === "" ? "–" : why);
    const turn = command.turn_rate_rad_s !== 0 ? command.turn_rate_rad_s : command.steering_rad;
    const per = command.turn_rate_rad_s !== 0 ? "°/s" : "°";
    set_text(rows.command.value, `${speed_text(command.speed_mps)}, ${(turn * degrees).toFixed(1)}${per}`);
  });
  app.connection.listen("/pose", (message) => {
    pose_age.renew();
    const { pose, covariance } = (message as PoseWithCovarianceStamped).pose;
    const { a_m } = ellipse_of(covariance[0] ?? 0, covariance[1] ?? 0, covariance[7] ?? 0);
    const heading = Math.sqrt(Math.max(0, covariance[35] ?? 0)) * degrees;
    const sigma = a_m > 0 ? ` · σ ${(a_m * 100).toFixed(1)} cm, ${heading.toFixed(1)}°` : "";
    set_text(rows.pose.value, `${position_text(pose.position, 2)}${sigma}`);
  });
  app.connection.listen("/match", (message) => {
    const { quality, text: words_of } = json_of<Match>(message);
    show_match(true);
    match_age.renew();
    set_text(rows.match.value, `${Math.round(quality * 100)} % · ${words_of}`);
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
    for (const age of [...decided, pose_age, match_age]) age.forget();
    for (const { value } of [rows.state, rows.why, rows.command, rows.pose, rows.match]) set_text(value, "–");
  });

  const list = element("dl", {}, ...Object.values(rows).flatMap(({ term, cell }) => [term, cell]));
  return element(
    "details",
    { class: "panel details-panel" },
    element("summary", {}, words.title),
    list,
    transducer,
    element("h3", {}, text.plot.title),
    plot(app),
    element("h3", {}, words.layers),
    layers,
  );
}
