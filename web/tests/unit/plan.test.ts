import assert from "node:assert/strict";
import { test } from "node:test";

import { floor_runs, route_points } from "../../src/plan/building_geometry";
import { distance_to_segment, ellipse_of, heading_of, moved_by } from "../../src/plan/geometry";
import { PlanView, round_length } from "../../src/plan/plan_view";

const near = (a: number, b: number, within = 1e-9) =>
  assert.ok(Math.abs(a - b) <= within, `${a} is not ${b}`);

test("The map's y axis points up on the screen, and the transform is invertible", () => {
  const view = new PlanView();
  Object.assign(view, { width_px: 400, height_px: 200, scale_px_per_m: 10, middle: { x: 1, y: 2 } });
  assert.deepEqual(view.to_screen({ x: 2, y: 5 }), { x: 210, y: 70 });
  assert.deepEqual(view.to_map({ x: 210, y: 70 }), { x: 2, y: 5 });
});

test("Zooming keeps the point under the pointer fixed", () => {
  const view = new PlanView();
  Object.assign(view, { width_px: 400, height_px: 200 });
  const before = view.to_map({ x: 37, y: 150 });
  view.zoom(2.5, { x: 37, y: 150 });
  near(view.to_map({ x: 37, y: 150 }).x, before.x);
  near(view.to_map({ x: 37, y: 150 }).y, before.y);
});

test("A fitted area is centred on the screen", () => {
  const view = new PlanView();
  Object.assign(view, { width_px: 400, height_px: 200 });
  view.fit({ low: { x: -10, y: 4 }, high: { x: 30, y: 6 } });
  assert.deepEqual(view.middle, { x: 10, y: 5 });
  assert.ok(view.to_screen({ x: -10, y: 4 }).x >= 0);
});

test("The scale bar has round lengths", () => {
  assert.equal(round_length(40, 90), 2);
  assert.equal(round_length(100, 90), 0.5);
});

test("The heading of a quaternion", () => {
  near(heading_of({ x: 0, y: 0, z: Math.sin(0.7), w: Math.cos(0.7) }), 1.4);
});

test("A point ahead of a vehicle that faces along y has a larger y", () => {
  const moved = moved_by({ x: 1, y: 2, heading_rad: Math.PI / 2 }, { x: 3, y: 0 });
  near(moved.x, 1);
  near(moved.y, 5);
});

test("The ellipse of a covariance has the right axes and direction", () => {
  const { a_m, b_m, heading_rad } = ellipse_of(5, 4, 5);
  near(a_m, 3);
  near(b_m, 1);
  near(heading_rad, Math.PI / 4);
});

test("Beyond a segment's end, the distance is the one to the end point", () => {
  near(distance_to_segment({ x: 4, y: 4 }, { x: 0, y: 0 }, { x: 1, y: 0 }), 5);
  near(distance_to_segment({ x: 0.5, y: 2 }, { x: 0, y: 0 }, { x: 1, y: 0 }), 2);
});

test("A route of a line, a left quarter circle and a turn on the spot ends at the right point", () => {
  const points = route_points({
    name: "",
    start: { at_m: [0, 0], heading_deg: 0 },
    pieces: [{ length_m: 2 }, { length_m: Math.PI / 2, turn_deg: 90 }, { turn_deg: -90 }, { length_m: 1 }],
  });
  near(points.at(-1)?.x ?? 0, 4, 1e-6);
  near(points.at(-1)?.y ?? 0, 1, 1e-6);
});

test("The documented floor has its runs at the right positions", () => {
  const runs = floor_runs({ cell_m: 0.05, low_cell: [-2, 7], rows: ["5#", "1#3.1#"] });
  assert.equal(runs.length, 4);
  near(runs[0]?.low.x ?? 0, -0.1);
  near(runs[2]?.low.x ?? 0, -0.05);
  near(runs[2]?.low.y ?? 0, 0.4);
  assert.equal(runs[2]?.is_free, true);
});
