import assert from "node:assert/strict";
import { test } from "node:test";

import {
  nearest_part,
  with_cleared,
  with_glass,
  with_keep_out,
  with_place,
  without_part,
  without_place,
} from "../../src/building/building_edits";
import type { Building } from "../../src/building/building_file";
import { pack_row, unpack_row } from "../../src/building/floor_cells";
import { UndoList } from "../../src/page/undo_list";

const building: Building = {
  format: "aisle.building",
  version: 1,
  walls: [
    { start_m: [0, 0], end_m: [4, 0] },
    { start_m: [4, 0], end_m: [4, 3] },
  ],
  landmarks: [{ at_m: [2, 0.1] }],
  floor: { cell_m: 0.5, low_cell: [-1, 0], rows: ["1#6.1#", "1#3.1#", "4-1."] },
};

test("A row of the floor comes back as it was", () => {
  for (const row of ["5#", "1#3.1#", "1#1.2-1#", "", "4-1."]) assert.equal(pack_row(unpack_row(row)), row);
});

test("A keep-out line blocks every cell that it passes, and nothing else", () => {
  const made = with_keep_out(building, { x: 0.25, y: 0.25 }, { x: 1.75, y: 0.25 });
  assert.deepEqual(made.floor?.rows, ["5#2.1#", "1#3.1#", "4-1."]);
  assert.deepEqual(building.floor?.rows[0], "1#6.1#");
});

test("A line that goes beyond the known floor is cut there", () => {
  const made = with_keep_out(building, { x: 0.25, y: -5 }, { x: 0.25, y: 9 });
  assert.deepEqual(made.floor?.rows, ["2#5.1#", "2#2.1#", "1-1#2-1."]);
});

test("Clearing frees what is blocked and invents no floor", () => {
  const made = with_cleared(building, { x: -0.25, y: 0.25 }, { x: -0.25, y: 1.25 });
  assert.deepEqual(made.floor?.rows, ["7.1#", "4.1#", "4-1."]);
});

test("Glass is a wall with two faces", () => {
  const made = with_glass(
    { format: "", version: 1, walls: building.walls ?? [] },
    { x: 1, y: 1 },
    { x: 2.0004, y: 1 },
  );
  assert.deepEqual(made.walls?.slice(2), [
    { start_m: [1, 1], end_m: [2, 1] },
    { start_m: [2, 1], end_m: [1, 1] },
  ]);
});

test("Without a floor there is nothing to keep out of", () => {
  assert.throws(() => with_keep_out({ format: "", version: 1 }, { x: 0, y: 0 }, { x: 1, y: 0 }), /no floor/);
});

test("A place has a name of its own", () => {
  const made = with_place(building, "desk", { x: 1, y: 2 }, 90);
  assert.deepEqual(made.places, [{ name: "desk", at_m: [1, 2], heading_deg: 90 }]);
  assert.throws(() => with_place(made, "desk", { x: 0, y: 0 }, 0), /already/);
  assert.throws(() => with_place(made, "", { x: 0, y: 0 }, 0), /needs a name/);
  assert.deepEqual(without_place(made, "desk").places, []);
});

test("What lies nearest is deleted, and only when it is near", () => {
  const landmark = nearest_part(building, { x: 2, y: 0.08 }, 0.3);
  assert.equal(landmark?.kind, "landmark");
  const wall = nearest_part(building, { x: 4.1, y: 2 }, 0.3);
  assert.ok(wall);
  assert.equal(without_part(building, wall).walls?.length, 1);
  assert.equal(nearest_part(building, { x: 2, y: 2 }, 0.3), undefined);
});

test("Undo goes back a stroke, redo on, and a new stroke forgets what was undone", () => {
  const history = new UndoList("a");
  history.put("b");
  history.put("bb", false);
  history.put("c");
  history.undo();
  assert.equal(history.present, "bb");
  history.undo();
  assert.equal(history.present, "a");
  history.redo();
  history.put("d");
  assert.equal(history.can_redo, false);
  assert.equal(history.present, "d");
});
