import assert from "node:assert/strict";
import { test } from "node:test";

import {
  nearest_part,
  part_points,
  renamed_place,
  with_barrier,
  with_cleared,
  with_place,
  with_zone,
  without_part,
  without_place,
} from "../../src/building/building_edits";
import { building_of } from "../../src/building/building_file";
import type { Building, Floor, Pair } from "../../src/building/building_file";
import { pack_row, unpack_row } from "../../src/building/floor_cells";
import { named_rooms } from "../../src/building/named_rooms";
import { room_middle } from "../../src/building/room_middle";
import { UndoList } from "../../src/page/undo_list";

const building: Building = {
  format: "aisle.building",
  version: 3,
  walls: [
    { start_m: [0, 0], end_m: [4, 0] },
    { start_m: [4, 0], end_m: [4, 3] },
  ],
  landmarks: [{ at_m: [2, 0.1] }],
  floor: { cell_m: 0.5, low_cell: [-1, 0], rows: ["1#6.1#", "1#3.1#", "4-1."] },
};

test("Landmarks are read from a table and from a list", () => {
  const landmarks = { columns: ["at_m", "seen_from_m"], rows: [[[2, 0.1], null]] };
  assert.deepEqual(building_of({ ...building, landmarks }), building);
  assert.deepEqual(building_of({ ...building, version: 1 }), building);
});

test("A building without landmarks and corridors gets none", () => {
  const { format, version } = building;
  assert.deepEqual(building_of({ format, version: 2 }), { format, version });
});

test("The polyline of a corridor is read from version 3 and from the versions before it", () => {
  const nodes = [{ kind: "end", at_m: [0.5, 0] as Pair }];
  const others = { from: 0, to: 0, width_m: 2 };
  const points: Pair[] = [
    [0.5, 0],
    [4, 0],
  ];
  const corridors = { nodes, corridors: [{ ...others, path_m: points }] };
  const former = { nodes, corridors: [{ ...others, way_m: points }] };
  const expected = { ...building, corridors };
  assert.deepEqual(building_of(expected), expected);
  for (const version of [1, 2]) {
    assert.deepEqual(building_of({ ...building, version, corridors: former }), expected);
  }
});

test("Packing an unpacked floor row gives the same row", () => {
  for (const row of ["5#", "1#3.1#", "1#1.2-1#", "", "4-1."]) assert.equal(pack_row(unpack_row(row)), row);
});

test("A line is clipped to the known floor", () => {
  const made = with_cleared(building, { x: -0.25, y: -5 }, { x: -0.25, y: 9 });
  assert.deepEqual(made.floor?.rows, ["7.1#", "4.1#", "4-1."]);
  assert.deepEqual(building.floor?.rows[0], "1#6.1#");
});

test("Keep-out lines and glass are stored apart from walls, to the millimetre", () => {
  const made = with_barrier(building, "keep_out", { x: 1, y: 1 }, { x: 2.0004, y: 1 });
  const both = with_barrier(made, "glass", { x: 0, y: 0 }, { x: 0, y: 3 });
  assert.deepEqual(both.barriers, [
    { kind: "keep_out", start_m: [1, 1], end_m: [2, 1] },
    { kind: "glass", start_m: [0, 0], end_m: [0, 3] },
  ]);
  assert.deepEqual(both.walls, building.walls);
  assert.equal(building.barriers, undefined);
});

test("Zones are rectangles; one-way ones lead the way they were drawn", () => {
  const at = (x: number, y: number) => ({ x, y });
  const slow = with_zone(building, "slow", at(0, 0), at(2, 1), 0.3).zones?.[0];
  assert.deepEqual(slow, {
    kind: "slow",
    outline_m: [
      [0, 0],
      [2, 0],
      [2, 1],
      [0, 1],
    ],
    speed_max_mps: 0.3,
  });
  const direction = (to: { x: number; y: number }) =>
    with_zone(building, "one_way", at(0, 0), to, 0.3).zones?.[0]?.direction_deg;
  assert.deepEqual([at(3, 1), at(-3, 1), at(1, 3), at(1, -3)].map(direction), [0, 180, 90, -90]);
  assert.throws(() => with_zone(building, "keep_out", at(0, 0), at(2, 0.01), 0.3), /at least 5 cm/);
  for (const speed of [0, 21, NaN])
    assert.throws(() => with_zone(building, "slow", at(0, 0), at(2, 1), speed), /speed is 0.01 to 20/);
  const drawn = with_zone(building, "keep_out", at(0, 5), at(2, 7), 0.3);
  const edge = nearest_part(drawn, at(2.1, 6), 0.3);
  assert.ok(edge);
  assert.equal(edge.list, "zones");
  assert.equal(part_points(drawn, edge).length, 5);
  assert.deepEqual(without_part(drawn, edge).zones, []);
});

test("Clearing frees occupied cells and leaves unknown cells unknown", () => {
  const made = with_cleared(building, { x: -0.25, y: 0.25 }, { x: -0.25, y: 1.25 });
  assert.deepEqual(made.floor?.rows, ["7.1#", "4.1#", "4-1."]);
});

test("Every place needs a unique name", () => {
  const made = with_place(building, "desk", { x: 1, y: 2 }, 90);
  assert.deepEqual(made.places, [{ name: "desk", at_m: [1, 2], heading_deg: 90 }]);
  const with_lab = with_place(made, "lab", { x: 0, y: 0 }, undefined);
  assert.deepEqual(with_lab.places?.[1], { name: "lab", at_m: [0, 0] });
  assert.throws(() => with_place(made, "desk", { x: 0, y: 0 }, 0), /already/);
  assert.throws(() => with_place(made, "", { x: 0, y: 0 }, 0), /needs a name/);
  assert.deepEqual(without_place(made, "desk").places, []);
});

test("The nearest part is found, if it is near enough", () => {
  const landmark = nearest_part(building, { x: 2, y: 0.08 }, 0.3);
  assert.equal(landmark?.list, "landmarks");
  const drawn = with_barrier(building, "glass", { x: 0, y: 2 }, { x: 3, y: 2 });
  const glass = nearest_part(drawn, { x: 2, y: 2 }, 0.3);
  assert.ok(glass);
  assert.deepEqual(without_part(drawn, glass).barriers, []);
  const wall = nearest_part(building, { x: 4.1, y: 2 }, 0.3);
  assert.ok(wall);
  assert.equal(without_part(building, wall).walls?.length, 1);
  assert.equal(nearest_part(building, { x: 2, y: 2 }, 0.3), undefined);
});

test("Undo takes back a stroke, redo restores it, and a new stroke drops what was undone", () => {
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

test("A place gets another name, which nothing else has", () => {
  const made = with_place(with_place(building, "desk", { x: 1, y: 2 }, 90), "lift", { x: 2, y: 2 }, 0);
  const renamed = renamed_place(made, "desk", "office");
  assert.deepEqual(renamed.places?.[0], { name: "office", at_m: [1, 2], heading_deg: 90 });
  assert.throws(() => renamed_place(made, "desk", "lift"), /already/);
  assert.throws(() => renamed_place(made, "desk", ""), /needs a name/);
});

/** Two rooms of 4 m by 3 m with a door of 1 m between, over a corridor of 1 m; cells of 0.1 m from (-1, 2) on. */
function two_rooms(): Floor {
  const corridor = Array<string>(10).fill("81.");
  const wall = "81#";
  const rooms = Array.from({ length: 30 }, (_, row) => (row < 10 ? "81." : "40.1#40."));
  return { cell_m: 0.1, low_cell: [-10, 20], rows: [...corridor, wall, ...rooms] };
}

test("A room's middle is where it has most space, wherever in the room it was asked for", () => {
  const floor = two_rooms();
  for (const at of [
    { x: -0.95, y: 3.15 },
    { x: 0.5, y: 5.5 },
    { x: 2.8, y: 5.9 },
  ]) {
    const middle = room_middle(floor, at);
    assert.ok(middle && middle.x > 0 && middle.x < 2.2, JSON.stringify(middle));
    assert.ok(Math.abs(middle.y - 4.6) < 0.15, JSON.stringify(middle));
  }
  const right = room_middle(floor, { x: 7, y: 5.9 });
  assert.ok(right && right.x > 4.1);
  const corridor = room_middle(floor, { x: 5, y: 2.05 });
  assert.ok(corridor && Math.abs(corridor.x - 5) < 0.6 && Math.abs(corridor.y - 2.5) < 0.11);
});

/** The area within outlines that go round it counter-clockwise, those of holes clockwise. */
function area_m2(outlines: { x: number; y: number }[][]): number {
  const doubled = outlines.flatMap((outline) =>
    outline.map(({ x, y }, index) => {
      const next = outline[(index + 1) % outline.length] ?? { x, y };
      return x * next.y - next.x * y;
    }),
  );
  return doubled.reduce((sum, part) => sum + part, 0) / 2;
}

/** As an editor names it: the name is in the room's middle. */
function named(floor: Floor, name: string, at: { x: number; y: number }): Building {
  const middle = room_middle(floor, at);
  assert.ok(middle);
  return with_place({ ...building, floor }, name, middle, undefined);
}

test("A named room is shown as far as its walls, and half-way into its door", () => {
  const floor = two_rooms();
  const [left, ...others] = named_rooms(named(floor, "left", { x: 0.5, y: 5.5 }));
  assert.deepEqual(others, []);
  assert.equal(left?.name, "left");
  const [outline = []] = left.outlines;
  const xs = outline.map(({ x }) => x);
  assert.ok(Math.abs(Math.min(...xs) + 1) < 1e-6 && Math.max(...xs) < 3.5, "not the room behind the door");
  assert.ok(Math.min(...outline.map(({ y }) => y)) > 3.09, "not the corridor behind the wall");
  assert.ok(Math.abs(area_m2(left.outlines) - 4 * 3) < 0.5, `${area_m2(left.outlines)} m2`);
});

test("What stands in a named room is left out of it", () => {
  const open = (rows: number) => Array<string>(rows).fill("60.");
  const floor = {
    cell_m: 0.1,
    low_cell: [0, 0] as Pair,
    rows: [...open(20), "20.5#35.", "20.5#35.", ...open(38)],
  };
  const [hall] = named_rooms(named(floor, "hall", { x: 3, y: 4 }));
  assert.equal(hall?.outlines.length, 2);
  assert.ok(Math.abs(area_m2(hall.outlines) - (36 - 0.1)) < 1e-6);
});

test("A corridor that has two names is shown once", () => {
  const corridor: Floor = { cell_m: 0.1, low_cell: [0, 0], rows: Array<string>(20).fill("200.") };
  const once = named(corridor, "west", { x: 5, y: 1 });
  const middle = room_middle(corridor, { x: 15, y: 1 });
  assert.ok(middle);
  const rooms = named_rooms(with_place(once, "east", middle, undefined));
  assert.equal(rooms.length, 1);
  assert.ok(Math.abs(area_m2(rooms[0]?.outlines ?? []) - 40) < 1e-6);
});

test("Home, and a place beside the middle of a room, name no room", () => {
  const floor = two_rooms();
  assert.deepEqual(named_rooms(named(floor, "home", { x: 0.5, y: 5.5 })), []);
  const beside = with_place({ ...building, floor }, "desk", { x: -0.5, y: 5.5 }, 90);
  assert.deepEqual(named_rooms(beside), []);
  assert.deepEqual(named_rooms(building), []);
});

test("Where no free floor is known there is no room", () => {
  const floor = two_rooms();
  for (const at of [
    { x: 5, y: 3.05 },
    { x: -1.05, y: 2.5 },
    { x: -9, y: 2.5 },
    { x: 0, y: 1.9 },
    { x: 0, y: 60 },
  ])
    assert.equal(room_middle(floor, at), undefined, JSON.stringify(at));
});
