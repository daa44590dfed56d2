import assert from "node:assert/strict";
import { test } from "node:test";

import type { Floor } from "../../src/building/building_file";
import type { LivePlan } from "../../src/plan/live_plan";
import { PlanView } from "../../src/plan/plan_view";

// The browser's functions that drawing uses.
class Path2D {
  rect() {}
}
Object.assign(globalThis, {
  document: { documentElement: {} },
  getComputedStyle: () => ({ getPropertyValue: () => "black" }),
  matchMedia: () => ({ matches: true }),
  Path2D,
});
const { live_layers } = await import("../../src/plan/live_layers");

/** A hall of 6 m by 6 m. */
const floor: Floor = { cell_m: 0.1, low_cell: [0, 0], rows: Array<string>(60).fill("60.") };

/** How many corners the floor's layer traces. */
function corners(plan: Partial<LivePlan>): number {
  let count = 0;
  const count_it = () => (count += 1);
  const drawn = new Set(["moveTo", "lineTo"]);
  const context = new Proxy(
    {},
    { get: (_, name) => (drawn.has(String(name)) ? count_it : () => {}), set: () => true },
  );
  const layer = live_layers(plan as LivePlan).floor;
  layer?.(context as CanvasRenderingContext2D, new PlanView());
  return count;
}

test("A mission's plan shows the named rooms of its building", () => {
  const hall = { name: "hall", x: 2.95, y: 2.95 };
  assert.equal(corners({ floor, places: () => [hall] }), 4);
  assert.equal(corners({ floor, places: () => [{ ...hall, name: "home" }] }), 0);
  assert.equal(corners({ floor: undefined, places: () => [hall] }), 0);
});
