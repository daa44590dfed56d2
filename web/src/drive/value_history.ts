import type { LiveConnection } from "../connection/live_connection";
import { json_of } from "../connection/live_state";
import type { Odometry, PoseWithCovarianceStamped } from "../connection/messages";
import { ellipse_of, heading_of } from "../plan/geometry";
import type { text } from "../text";

export type ValueName = keyof typeof text.plot.values;

export interface Sample {
  stamp_s: number;
  value: number;
}

const kept_s = 120;
const degrees = 180 / Math.PI;

/** The values of the last two minutes by the vehicle's clock. Lengths in metres, angles in degrees. */
export class ValueHistory {
  readonly #samples = new Map<ValueName, Sample[]>();

  /** @param changed called after each new value */
  constructor(
    connection: Pick<LiveConnection, "listen">,
    private readonly changed: () => void,
  ) {
    connection.listen("/decision", (message, stamp_ns) => {
      const { command } = json_of<{ command: { speed_mps: number } }>(message);
      this.#put("command", stamp_ns, command.speed_mps);
    });
    connection.listen("/odom", (message, stamp_ns) => {
      const { linear, angular } = (message as Odometry).twist.twist;
      this.#put("speed", stamp_ns, linear.x);
      this.#put("turn_rate", stamp_ns, angular.z * degrees);
    });
    connection.listen("/pose", (message, stamp_ns) => {
      const { pose, covariance } = (message as PoseWithCovarianceStamped).pose;
      this.#put("x", stamp_ns, pose.position.x);
      this.#put("y", stamp_ns, pose.position.y);
      this.#put("heading", stamp_ns, heading_of(pose.orientation) * degrees);
      const { a_m } = ellipse_of(covariance[0] ?? 0, covariance[1] ?? 0, covariance[7] ?? 0);
      this.#put("sigma", stamp_ns, a_m);
    });
    connection.listen("/match", (message, stamp_ns) =>
      this.#put("match", stamp_ns, json_of<{ quality: number }>(message).quality * 100),
    );
    connection.listen("/session", () => this.#samples.clear());
  }

  of(name: ValueName): readonly Sample[] {
    return this.#samples.get(name) ?? [];
  }

  /** A clock that goes back, as in a replay, begins again. */
  #put(name: ValueName, stamp_ns: bigint, value: number): void {
    if (!Number.isFinite(value)) return;
    const stamp_s = Number(stamp_ns) / 1e9;
    const before = this.of(name);
    const goes_on = (before.at(-1)?.stamp_s ?? -Infinity) <= stamp_s;
    const kept = goes_on ? before.filter((sample) => sample.stamp_s > stamp_s - kept_s) : [];
    this.#samples.set(name, [...kept, { stamp_s, value }]);
    this.changed();
  }
}

export interface Range {
  low: number;
  high: number;
}

/** The range of the values, never empty: a constant lies in its middle. */
export function range_of(samples: readonly Sample[]): Range {
  const values = samples.map(({ value }) => value);
  const [low, high] = [Math.min(...values), Math.max(...values)];
  return high > low ? { low, high } : { low: low - 1, high: high + 1 };
}
