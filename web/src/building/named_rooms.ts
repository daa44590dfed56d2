/** The rooms that have names, as far as their walls and doors. */

import { once_for_each } from "../page/once";
import { point_of } from "../plan/building_geometry";
import { distance } from "../plan/geometry";
import type { Point } from "../plan/geometry";
import type { Building, Floor } from "./building_file";
import { clearances_of } from "./clearances";
import type { Clearances } from "./clearances";
import { room_middle } from "./room_middle";

/** Half as wide as a door: what has more space on both sides is no door. */
const half_door_m = 0.55;
/** How far corners, and niches between furniture, are from where there is that much space. */
const niche_m = 2;
/** A name is in the middle of its room, to the rounding of its coordinates and of cells. */
const middle_within_m = 0.1;
/** Where missions begin: it may well be in the middle of a corridor, and names no room. */
const home_place = "home";

export interface NamedRoom {
  /** If it has several, one of them. */
  name: string;
  /** Closed outlines: the room's, and those of what stands in it. */
  outlines: Point[][];
}

/** Which part of a floor each cell belongs to: parts are numbered from 1, and joined by doors only. */
type Parts = Int32Array;

/** Numbers all that is joined to a cell by cells with more space than in a door. @returns these cells */
function number_core(clearances: Clearances, parts: Parts, start: number, part: number, more_than: number) {
  const core = [start];
  parts[start] = part;
  for (const cell of core) {
    for (const offset of clearances.offsets) {
      const next = cell + offset;
      if (parts[next] !== 0 || clearances.at(next) <= more_than) continue;
      parts[next] = part;
      core.push(next);
    }
  }
  return core;
}

/** Parts grow into the cells about them at the same speed, so they meet in the middle of a door. */
function grow(clearances: Clearances, parts: Parts, cores: number[], steps: number): void {
  let edge = cores;
  for (let step = 0; step < steps; step += 1) {
    const grown: number[] = [];
    for (const cell of edge) {
      for (const offset of clearances.offsets) {
        const next = cell + offset;
        if (parts[next] !== 0 || clearances.at(next) === 0) continue;
        parts[next] = parts[cell] ?? 0;
        grown.push(next);
      }
    }
    edge = grown;
  }
}

const parts_of = once_for_each((floor: Floor): Parts => {
  const clearances = clearances_of(floor);
  const parts = new Int32Array(clearances.size);
  const more_than = half_door_m / floor.cell_m;
  const cores: number[] = [];
  for (let cell = 0, part = 1; cell < clearances.size; cell += 1) {
    if (parts[cell] !== 0 || clearances.at(cell) <= more_than) continue;
    for (const joined of number_core(clearances, parts, cell, part, more_than)) cores.push(joined);
    part += 1;
  }
  grow(clearances, parts, cores, Math.ceil(niche_m / floor.cell_m));
  return parts;
});

/** The sides of a cell, counter-clockwise: the neighbour beyond it, and the corners at its ends, in cells. */
const sides = [
  { beyond: [0, -1], from: [0, 0], to: [1, 0] },
  { beyond: [1, 0], from: [1, 0], to: [1, 1] },
  { beyond: [0, 1], from: [1, 1], to: [0, 1] },
  { beyond: [-1, 0], from: [0, 1], to: [0, 0] },
] as const;

/** The outlines of one part as cells whose low corners they pass through, counter-clockwise. */
function corners_about(parts: Parts, part: number, columns: number): number[][] {
  const offset = ([right, up]: readonly [number, number]) => up * columns + right;
  /** Where the sides that begin at a corner end. */
  const ends = new Map<number, number[]>();
  parts.forEach((own, cell) => {
    if (own !== part) return;
    for (const { beyond, from, to } of sides) {
      if (parts[cell + offset(beyond)] === part) continue;
      const begin = cell + offset(from);
      ends.set(begin, [...(ends.get(begin) ?? []), cell + offset(to)]);
    }
  });
  const outlines: number[][] = [];
  for (const [first, following] of ends) {
    while (following.length > 0) {
      const outline: number[] = [];
      for (let at: number | undefined = first; at !== undefined; at = ends.get(at)?.pop()) outline.push(at);
      outlines.push(outline.slice(0, -1));
    }
  }
  return outlines;
}

/** Without the corners between which it goes straight on. */
function straightened(corners: number[]): number[] {
  return corners.filter((corner, index) => {
    const before = corners.at(index - 1) ?? corner;
    const after = corners[(index + 1) % corners.length] ?? corner;
    return corner - before !== after - corner;
  });
}

/** The part in whose middle a name is; 0: it names a place. */
function part_named(floor: Floor, parts: Parts, name_at: Point): number {
  const middle = room_middle(floor, name_at);
  if (!middle || distance(middle, name_at) > middle_within_m) return 0;
  return parts[clearances_of(floor).cell_at(name_at) ?? 0] ?? 0;
}

function outlines_of(floor: Floor, parts: Parts, part: number): Point[][] {
  const clearances = clearances_of(floor);
  const outlines = corners_about(parts, part, clearances.columns);
  return outlines.map((corners) => straightened(corners).map((corner) => clearances.low_corner(corner)));
}

export const named_rooms = once_for_each(
  ({ floor, places = [] }: Pick<Building, "floor" | "places">): NamedRoom[] => {
    const candidates = places.filter(({ name }) => name !== home_place);
    if (!floor || candidates.length === 0) return [];
    const parts = parts_of(floor);
    const names = new Map(
      candidates.map(({ name, at_m }) => [part_named(floor, parts, point_of(at_m)), name] as const),
    );
    names.delete(0);
    return [...names].map(([part, name]) => ({ name, outlines: outlines_of(floor, parts, part) }));
  },
);
