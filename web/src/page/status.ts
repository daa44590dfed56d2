import type { ConnectionState } from "../connection/live_connection";
import type { LiveState } from "../connection/live_state";
import type { Point } from "../plan/geometry";
import { text } from "../text";
import { length_text, position_text } from "./units";

/** The server sends its state twice a second; data are old after this time without a message. */
const old_after_s = 1.6;

export interface Status {
  lamp: "good" | "busy" | "trouble";
  text: string;
}

interface StatusInput {
  connection: ConnectionState;
  silent_s: number;
  /** The last known state, also after the connection was lost. */
  state: LiveState | undefined;
  drives_here: boolean;
  at: Point | undefined;
  /** How long the server took to answer the page that drives. */
  delay_ms?: number | undefined;
}

/** Minutes and seconds: 3:07. */
export function short_duration(seconds: number): string {
  const whole = Math.round(seconds);
  return `${Math.floor(whole / 60)}:${String(whole % 60).padStart(2, "0")}`;
}

function doing({ mode, mission, paused, task, replay, done, total }: LiveState): string {
  if (mode === "mission") return paused ? `${mission}, ${text.status.held}` : mission;
  if (mode === "work") return total > 0 ? `${task} ${text.mission.computing(done, total)}` : task;
  if (mode === "replay") return text.status.replay(replay?.session ?? "");
  return text.status.waiting;
}

function driver(state: LiveState, drives_here: boolean): string {
  if (drives_here) return text.status.you;
  return state.lease_held ? text.status.other : text.status.nobody;
}

/** Where, how far and how long. */
function measures({ mode, distance_m = 0, stamp_s }: LiveState, at: Point | undefined): string[] {
  const where = at ? [position_text(at, 1)] : [];
  if (mode !== "mission") return where;
  return [length_text(distance_m, 1), short_duration(stamp_s), ...where];
}

/** One line: what, who drives, how far, how long, where; or that what is shown is not current. */
export function status_of({ connection, silent_s, state, drives_here, at, delay_ms }: StatusInput): Status {
  if (connection === "connecting") return { lamp: "busy", text: text.status.connecting };
  if (connection === "lost" && state?.mode === "ended")
    return { lamp: "busy", text: text.status.ended(state.mission) };
  if (connection === "lost") return { lamp: "trouble", text: text.status.lost };
  if (!state) return { lamp: "busy", text: text.status.no_state };
  if (silent_s > old_after_s) return { lamp: "trouble", text: text.status.old(silent_s.toFixed(0)) };
  const who = driver(state, drives_here);
  const world = state.world === "" ? "" : `${state.world}: `;
  const parts = [`${world}${doing(state)}; ${who}`, ...measures(state, at)];
  if (delay_ms !== undefined) parts.push(text.status.delay(delay_ms.toFixed(0)));
  if (state.emergency) parts.unshift(text.status.emergency);
  return { lamp: state.emergency ? "trouble" : state.paused ? "busy" : "good", text: parts.join(" · ") };
}
