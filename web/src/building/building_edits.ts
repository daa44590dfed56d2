/** Changes of a building: each makes a new one and leaves the old as it was. */

import { distance, distance_to_segment } from "../plan/geometry";
import type { Point } from "../plan/geometry";
import { point_of } from "../plan/building_geometry";
import type { Barrier, Building, Pair } from "./building_file";
import { with_line } from "./floor_cells";

function pair({ x, y }: Point): Pair {
  const millimetres = (value_m: number) => Math.round(value_m * 1000) / 1000;
  return [millimetres(x), millimetres(y)];
}

/** @throws Error where the name is taken, missing or too long */
export function with_place(building: Building, name: string, at: Point, heading_deg: number): Building {
  const places = building.places ?? [];
  if (name === "") throw new Error("a place needs a name");
  if (new TextEncoder().encode(name).length > 200) throw new Error("a place's name has at most 200 bytes");
  if (places.some((place) => place.name === name)) throw new Error(`there is a place named ${name} already`);
  return { ...building, places: [...places, { name, at_m: pair(at), heading_deg }] };
}

export function without_place(building: Building, name: string): Building {
  return { ...building, places: (building.places ?? []).filter((place) => place.name !== name) };
}

/** What lies nearest to a point: a part of the building by its number in its list. */
export interface Found {
  list: "walls" | "landmarks" | "barriers";
  index: number;
  away_m: number;
}

export function nearest_part(building: Building, at: Point, within_m: number): Found | undefined {
  const lines = (list: "walls" | "barriers") =>
    (building[list] ?? []).map(({ start_m, end_m }, index): Found => {
      return { list, index, away_m: distance_to_segment(at, point_of(start_m), point_of(end_m)) };
    });
  const landmarks = (building.landmarks ?? []).map(({ at_m }, index): Found => {
    return { list: "landmarks", index, away_m: distance(at, point_of(at_m)) };
  });
  const near = [...landmarks, ...lines("barriers"), ...lines("walls")].filter(
    ({ away_m }) => away_m <= within_m,
  );
  return near.reduce<Found | undefined>(
    (best, part) => (best === undefined || part.away_m < best.away_m ? part : best),
    undefined,
  );
}

export function without_part(building: Building, { list, index }: Found): Building {
  return { ...building, [list]: (building[list] ?? []).filter((_, at) => at !== index) };
}

/** A line that the vehicle never crosses: because somebody wishes it, or because a pane of glass stands there. */
export function with_barrier(building: Building, kind: Barrier["kind"], from: Point, to: Point): Building {
  const barrier = { kind, start_m: pair(from), end_m: pair(to) };
  return { ...building, barriers: [...(building.barriers ?? []), barrier] };
}

/** Floor that is free after all along a line: what stood there was not there. @throws Error without a floor */
export function with_cleared(building: Building, from: Point, to: Point): Building {
  if (!building.floor) throw new Error("this building has no floor to clear");
  const free = with_line(building.floor, from, to, (cell) => (cell === "#" ? "." : cell));
  return { ...building, floor: free };
}
