import assert from "node:assert/strict";
import { test } from "node:test";

import { building_of } from "../../src/building/building_file";
import type { BuildingFile, Pair } from "../../src/building/building_file";
import { PlanView } from "../../src/plan/plan_view";

// The browser's functions that looking up a colour uses.
Object.assign(globalThis, {
  document: { documentElement: {} },
  getComputedStyle: () => ({ getPropertyValue: () => "black" }),
  matchMedia: () => ({ matches: true }),
});
const { building_layer } = await import("../../src/plan/building_layer");

/** The points of the lines that the building's layer draws, in pixels. */
function line_points(file: BuildingFile): [number, number][] {
  const points: [number, number][] = [];
  const add = (x: number, y: number) => points.push([x, y]);
  const context = {
    beginPath() {},
    stroke() {},
    setLineDash() {},
    fill() {},
    moveTo: add,
    lineTo: add,
  };
  const view = new PlanView();
  Object.assign(view, { width_px: 200, height_px: 100, scale_px_per_m: 10 });
  building_layer(building_of(file))(context as unknown as CanvasRenderingContext2D, view);
  return points;
}

test("Corridors of all file versions are drawn the same", () => {
  const points: Pair[] = [
    [0, 0],
    [4, 0],
    [4, 3],
  ];
  const file = (version: number, corridor: { path_m: Pair[] } | { way_m: Pair[] }): BuildingFile => {
    return { format: "aisle.building", version, corridors: { nodes: [], corridors: [corridor] } };
  };
  const drawn = [
    [100, 50],
    [140, 50],
    [140, 20],
  ];
  assert.deepEqual(line_points(file(3, { path_m: points })), drawn);
  assert.deepEqual(line_points(file(2, { way_m: points })), drawn);
  assert.deepEqual(line_points(file(1, { way_m: points })), drawn);
});
