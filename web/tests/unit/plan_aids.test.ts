import assert from "node:assert/strict";
import { afterEach, test } from "node:test";

import { hash_of, named_in } from "../../src/page/address";
import { area_text, length_text, position_text, speed_text, unit } from "../../src/page/units";
import { direction_deg } from "../../src/plan/geometry";

// The browser's function that the colours use.
Object.assign(globalThis, { matchMedia: () => ({ matches: true }) });
const { grid_lines } = await import("../../src/plan/grid");
const { shown_of_building } = await import("../../src/plan/legend");
const { Ruler } = await import("../../src/plan/ruler");

afterEach(() => (unit.value = "m"));

test("Lengths, areas and speeds are in the unit that was chosen", () => {
  assert.equal(position_text({ x: -0.001, y: 2 }, 2), "0.00, 2.00 m");
  assert.equal(area_text(100), "100 m²");
  unit.value = "ft";
  assert.equal(length_text(3.048, 1), "10.0 ft");
  assert.equal(area_text(0.3048 ** 2 * 7), "7 ft²");
  assert.equal(speed_text(0.3048), "1.00 ft/s");
});

test("The grid's lines are a round length of the unit apart, and lie where they say", () => {
  const labels = () => grid_lines(-1.2, 2.3, 100).map(({ label }) => label);
  assert.deepEqual(labels(), ["-1.0", "-0.5", "0.0", "0.5", "1.0", "1.5", "2.0"]);
  unit.value = "ft";
  assert.deepEqual(labels(), ["-2", "0", "2", "4", "6"]);
  for (const { at_m, label } of grid_lines(-1.2, 2.3, 100))
    assert.ok(Math.abs(at_m - Number(label) * 0.3048) < 1e-12);
  assert.deepEqual(grid_lines(0.1, 0.2, 100), []);
});

test("Directions are counter-clockwise from the x axis", () => {
  const from = { x: 1, y: 1 };
  assert.equal(direction_deg(from, { x: 2, y: 1 }), 0);
  assert.equal(direction_deg(from, { x: 1, y: 2 }), 90);
  assert.equal(direction_deg(from, { x: 1, y: 0 }), 270);
  assert.equal(direction_deg(from, { x: 2, y: 0.999 }), 0);
});

test("The ruler adds up its pieces, on to where the mouse points", () => {
  const ruler = new Ruler(() => undefined);
  assert.match(ruler.text(), /^Click points/);
  ruler.hover({ x: 9, y: 9 });
  ruler.click({ x: 0, y: 0 });
  ruler.hover({ x: 3, y: 4 });
  assert.equal(ruler.text(), "5.00 m, 53°");
  ruler.click({ x: 3, y: 4 });
  ruler.hover(undefined);
  ruler.click({ x: 3, y: 2 });
  assert.equal(ruler.text(), "2.00 m, 270° · 7.00 m in all");
  ruler.take_back();
  assert.equal(ruler.text(), "5.00 m, 53°");
  ruler.clear();
  assert.match(ruler.text(), /^Click points/);
});

test("The legend explains what a building has, and nothing else", () => {
  const corner: [number, number] = [0, 0];
  const barrier = { kind: "glass" as const, start_m: corner, end_m: corner };
  const building = { format: "aisle.building", version: 3, walls: [], landmarks: [{ at_m: corner }] };
  assert.deepEqual([...shown_of_building({ ...building, barriers: [barrier] })], ["landmarks", "glass"]);
});

test("An address names a tab and what is chosen in it", () => {
  for (const named of [
    { tab: "sessions", chosen: "run-2" },
    { tab: "building", chosen: "a/b #1 ü" },
    { tab: "maze", chosen: "" },
  ])
    assert.deepEqual(named_in(hash_of(named)), named);
  assert.deepEqual(named_in("#sessions/%E0%A4%A"), { tab: "sessions", chosen: "" });
  assert.deepEqual(named_in(""), { tab: "", chosen: "" });
});
