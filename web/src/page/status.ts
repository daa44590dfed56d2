import type { ConnectionState } from "../connection/live_connection";
import type { LiveState } from "../connection/live_state";

/** The server sends its state twice a second; data are old after this time without a message. */
const old_after_s = 1.6;

export interface Status {
  lamp: "good" | "busy" | "trouble";
  text: string;
}

interface StatusInput {
  connection: ConnectionState;
  silent_s: number;
  state: LiveState | undefined;
  drives_here: boolean;
}

function doing({ mode, mission, paused, task, replay }: LiveState): string {
  if (mode === "mission") return paused ? `${mission}, paused` : mission;
  if (mode === "work") return task;
  if (mode === "replay") return `replay of ${replay?.session ?? "a session"}`;
  return "waiting";
}

function driver(state: LiveState, drives_here: boolean): string {
  if (drives_here) return "you hold the controls";
  return state.lease_held ? "somebody else holds the controls" : "nobody holds the controls";
}

/** One line: whether the shown data are current, what the vehicle is doing, and who may drive. */
export function status_of({ connection, silent_s, state, drives_here }: StatusInput): Status {
  if (connection === "connecting") return { lamp: "busy", text: "Connecting" };
  if (connection === "lost") return { lamp: "trouble", text: "Not connected: reconnecting" };
  if (!state) return { lamp: "busy", text: "Connected, no state received yet" };
  if (silent_s > old_after_s)
    return { lamp: "trouble", text: `Old data: no message for ${silent_s.toFixed(0)} s` };
  if (state.emergency) return { lamp: "trouble", text: "Emergency stop" };
  return { lamp: "good", text: `${state.world}: ${doing(state)}; ${driver(state, drives_here)}` };
}
