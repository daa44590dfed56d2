// An independent client that watches the vehicle while the page is tested.
import assert from "node:assert/strict";
import { spawn } from "node:child_process";
import { rmSync } from "node:fs";
import { parse } from "@foxglove/rosmsg";
import { MessageReader } from "@foxglove/rosmsg2-serialization";
import protocol from "@foxglove/ws-protocol";
import { WebSocket } from "ws";

import { until } from "./browser.mjs";

export class Watcher {
  /** All received messages of the watched topics: {topic, stamp_s, message}. */
  received = [];
  now_s = 0;
  state;
  #socket;

  /** @param topics to watch; undefined: all */
  constructor(address, topics) {
    this.#socket = new WebSocket(address.replace("http", "ws"), ["foxglove.sdk.v1"]);
    const client = new protocol.FoxgloveClient({ ws: this.#socket });
    const readers = new Map();
    client.on("advertise", (channels) => {
      for (const { id, topic, schema } of channels) {
        if (topics && !topics.includes(topic) && topic !== "/live/state") continue;
        readers.set(client.subscribe(id), {
          topic,
          reader: new MessageReader(parse(schema, { ros2: true })),
        });
      }
    });
    client.on("message", ({ subscriptionId, timestamp, data }) => {
      const { topic, reader } = readers.get(subscriptionId);
      const received = { topic, stamp_s: Number(timestamp) / 1e9, message: reader.readMessage(data) };
      if (topic === "/live/state") this.state = JSON.parse(received.message.data);
      else this.received.push(received);
    });
    client.on("time", ({ timestamp }) => (this.now_s = Number(timestamp) / 1e9));
  }

  latest(topic) {
    return this.received.findLast((received) => received.topic === topic);
  }

  speed_mps() {
    return this.latest("/cmd_vel")?.message.linear.x ?? 0;
  }

  /** The vehicle's time of the first stop command from `from_s` on. */
  async stop_commanded_s(from_s) {
    const is_stop = ({ topic, stamp_s, message }) =>
      topic === "/cmd_vel" && stamp_s >= from_s && message.linear.x === 0 && message.angular.z === 0;
    await until(() => this.received.some(is_stop), "a stop command");
    return this.received.find(is_stop).stamp_s;
  }

  close() {
    this.#socket.close();
  }
}

/** Presses a button until it has acted and is gone. */
export async function hold(page, name) {
  const button = page.getByRole("button", { name, exact: true });
  await button.hover();
  await page.mouse.down();
  await button.waitFor({ state: "hidden" });
  await page.mouse.up();
}

async function start(program_arguments) {
  const process_of = spawn(process.env.AISLE, program_arguments);
  let log = "";
  process_of.stderr.on("data", (data) => (log += data));
  process_of.stdout.resume();
  await until(() => /live: (\S+)/.test(log) || process_of.exitCode !== null, "the server's address");
  const address = /live: (\S+)/.exec(log)?.[1];
  if (!address) throw new Error(`aisle ended: ${log}`);
  const ended = async () => {
    await until(() => process_of.exitCode !== null || process_of.signalCode !== null, "the server's end");
    return process_of.exitCode;
  };
  const stop = () => {
    process_of.kill("SIGINT");
    return ended();
  };
  return { address, stop, ended };
}

/** Starts `aisle live WORLD` on a free port. @returns {address, stop, ended} */
export function start_live(world, directory, ...options) {
  return start(["live", world, "--port", "0", "--out", directory, ...options]);
}

/** Interrupts what `start_live` started, if it did, and removes its directory. */
export async function end_live(server, directory) {
  if (server) assert.equal(await server.stop(), 130);
  rmSync(directory, { recursive: true });
}

/** Starts a verb with `--live` on a free port. @returns {address, stop, ended} */
export function start_watched(program_arguments) {
  return start([...program_arguments, "--live", "--port", "0"]);
}
