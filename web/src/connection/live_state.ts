import type { LiveConnection } from "./live_connection";
import { Signal } from "../page/signal";

/** Where a vehicle is sent: an item of `goals` of `mission/go`. */
export type GoalRequest = { place: string } | { x_m: number; y_m: number; heading_deg?: number };

/** What the server is doing: the JSON of /live/state. */
export interface LiveState {
  /** `ended`: the watched mission is over, and its program will be gone. */
  mode: "idle" | "mission" | "work" | "replay" | "ended";
  mission: string;
  world: string;
  vehicle: string;
  paused: boolean;
  emergency: boolean;
  driven_by_hand: boolean;
  lease_held: boolean;
  stamp_s: number;
  /** Driven on the map that is shown. */
  distance_m?: number;
  /** How many events the mission has had. */
  events?: number;
  /** Where the odometry of the waiting vehicle began on the map of the last mission. */
  map_origin?: { x_m: number; y_m: number; heading_deg: number };
  rate: number;
  task: string;
  done: number;
  total: number;
  session: string;
  /** There is a folder for what missions learn. */
  keeps_buildings?: boolean;
  /** Of the mission, in order; absent: it has none. */
  goals?: GoalRequest[];
  /** So many of them, from the first on. */
  goals_reached?: number;
  last?: { mission: string; ok: boolean; text: string; problems: string[] };
  replay?: { session: string; from_s: number; to_s: number; at_s: number; playing: boolean; rate: number };
}

/** std_msgs/String, which carries the JSON texts of docs/formats/session.md and docs/reference/live-server.md. */
interface StringMessage {
  data: string;
}

export function json_of<T>(message: unknown): T {
  return JSON.parse((message as StringMessage).data) as T;
}

/** The server's state; undefined while not connected. */
export function follow_state(connection: LiveConnection): Signal<LiveState | undefined> {
  const state = new Signal<LiveState | undefined>(undefined);
  connection.listen("/live/state", (message) => (state.value = json_of<LiveState>(message)));
  connection.state.watch((connected) => {
    if (connected !== "connected") state.value = undefined;
  });
  return state;
}
