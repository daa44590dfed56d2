import assert from "node:assert/strict";
import { test } from "node:test";

import { rgba_of } from "../../src/camera/image";
import { fresh_name, mission_forms, start_request } from "../../src/drive/mission_forms";
import { vehicle_shape } from "../../src/drive/vehicle_text";
import { command_of, strongest } from "../../src/drive/drive_request";
import { short_duration, status_of } from "../../src/page/status";
import { figure_lines, short_bytes } from "../../src/sessions/session_figures";
import type { LiveState } from "../../src/connection/live_state";
import idle_state from "../idle_state.json";

const differential = vehicle_shape(
  "is_differential: true\nlimits:\n  speed_max_mps: 0.3\n  turn_rate_max_deg_s: 45\n",
);
const front_steered = vehicle_shape(
  "is_differential: false\nlimits:\n  speed_max_mps: 0.5\n  reverse_speed_max_mps: 0.3\n  steering_max_deg: 40\n",
);

test("The vehicle's limits are read from the text of its file", () => {
  assert.equal(differential.is_differential, true);
  assert.equal(differential.speed_max_mps, 0.3);
  assert.equal(front_steered.reverse_speed_max_mps, 0.3);
  assert.ok(Math.abs(front_steered.steering_max_rad - 0.698) < 0.001);
});

test("Left is positive for both kinds of vehicle", () => {
  assert.ok(command_of({ ahead: 0, left: 1 }, 0.5, differential).turn_rate_rad_s > 0);
  assert.ok(command_of({ ahead: 1, left: 1 }, 0.5, front_steered).steering_rad > 0);
});

test("Reversing has its own speed limit", () => {
  assert.equal(command_of({ ahead: -1, left: 0 }, 1, front_steered).speed_mps, -0.3);
});

test("Two arrow keys together drive a curve", () => {
  assert.deepEqual(
    strongest([
      { ahead: 1, left: 0 },
      { ahead: 0, left: -1 },
    ]),
    { ahead: 1, left: -1 },
  );
});

test("Empty fields are not in the request", () => {
  const teach = mission_forms.find(({ mission }) => mission === "teach");
  assert.ok(teach);
  const request = start_request(teach, { session: "taught-1", route: "", method: "", scripted: false });
  assert.deepEqual(request, { mission: "teach", session: "taught-1" });
});

test("A proposed name is unused", () => {
  assert.equal(fresh_name("taught-", ["taught-1", "taught-2"]), "taught-3");
});

test("Grey and colour images become RGBA pixels, row by row", () => {
  const grey = { width: 2, height: 1, encoding: "mono8", step: 4, data: Uint8Array.of(7, 9, 0, 0) };
  assert.deepEqual([...rgba_of({ ...grey, width: 2 } as never)], [7, 7, 7, 255, 9, 9, 9, 255]);
  const colour = { width: 1, height: 2, encoding: "rgb8", step: 3, data: Uint8Array.of(1, 2, 3, 4, 5, 6) };
  assert.deepEqual([...rgba_of(colour as never)], [1, 2, 3, 255, 4, 5, 6, 255]);
});

const state = idle_state as LiveState;
const input = { connection: "connected" as const, silent_s: 0.2, state, drives_here: false, at: undefined };

test("The status line says when the shown data are old", () => {
  assert.equal(status_of(input).lamp, "good");
  assert.match(status_of({ ...input, silent_s: 4 }).text, /no message for 4 s/);
  assert.match(status_of({ ...input, connection: "lost" }).text, /Not connected/);
});

test("The status line says how far, how long and where, and that a program has ended", () => {
  const driving = { ...state, mode: "mission" as const, mission: "explore", distance_m: 12.34, stamp_s: 75 };
  const { text } = status_of({ ...input, state: driving, at: { x: 3.21, y: -1 } });
  assert.match(text, /explore; nobody holds the controls · 12\.3 m · 1:15 · 3\.2, -1\.0 m$/);
  const gone = status_of({ ...input, connection: "lost", state: { ...driving, mode: "ended" } });
  assert.deepEqual(gone, { lamp: "busy", text: "explore has ended and its program is gone" });
});

test("The status line says who drives", () => {
  assert.match(status_of({ ...input, drives_here: true }).text, /you hold the controls/);
  assert.match(status_of({ ...input, delay_ms: 12.4 }).text, / · answers in 12 ms$/);
  assert.match(status_of({ ...input, state: { ...state, lease_held: true } }).text, /somebody else/);
});

test("Figures are shown as lines with rounded numbers", () => {
  assert.deepEqual(figure_lines({ path_m: 12.3456789, topics: [{ name: "/odom" }] }), [
    ["path_m", "12.346"],
    ["topics 1 name", "/odom"],
  ]);
  assert.equal(short_bytes(1234567), "1.23 MB");
  assert.equal(short_duration(187.4), "3:07");
});
