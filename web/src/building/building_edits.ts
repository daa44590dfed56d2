/** Edits of a building: each returns a new building and leaves the old one unchanged. */

import { distance, distance_to_segment, rectangle } from "../plan/geometry";
import type { Point } from "../plan/geometry";
import { point_of, zone_edges, zone_outline } from "../plan/building_geometry";
import type { Barrier, Building, Pair, Place, Zone } from "./building_file";
import { with_line } from "./floor_cells";

function pair({ x, y }: Point): Pair {
  const millimetres = (value_m: number) => Math.round(value_m * 1000) / 1000;
  return [millimetres(x), millimetres(y)];
}

/** @throws Error where the name is taken, missing or too long */
function check_name(places: readonly Place[], name: string): void {
  if (name === "") throw new Error("a place needs a name");
  if (new TextEncoder().encode(name).length > 200) throw new Error("a place's name has at most 200 bytes");
  if (places.some((place) => place.name === name)) throw new Error(`there is a place named ${name} already`);
}

/** @param heading_deg  undefined: how the vehicle stands there does not matter  @throws Error as check_name */
export function with_place(
  building: Building,
  name: string,
  at: Point,
  heading_deg: number | undefined,
): Building {
  const places = building.places ?? [];
  check_name(places, name);
  const heading = heading_deg === undefined ? {} : { heading_deg };
  return { ...building, places: [...places, { name, at_m: pair(at), ...heading }] };
}

/** @throws Error as check_name */
export function renamed_place(building: Building, name: string, other: string): Building {
  const places = building.places ?? [];
  check_name(places, other);
  return {
    ...building,
    places: places.map((place) => (place.name === name ? { ...place, name: other } : place)),
  };
}

export function without_place(building: Building, name: string): Building {
  return { ...building, places: (building.places ?? []).filter((place) => place.name !== name) };
}

/** The part of the building nearest to a point, by its index in its list. */
export interface FoundPart {
  list: "walls" | "landmarks" | "barriers" | "zones";
  index: number;
  distance_m: number;
}

export function nearest_part(building: Building, at: Point, within_m: number): FoundPart | undefined {
  const lines = (list: "walls" | "barriers") =>
    (building[list] ?? []).map(({ start_m, end_m }, index): FoundPart => {
      return { list, index, distance_m: distance_to_segment(at, point_of(start_m), point_of(end_m)) };
    });
  const landmarks = (building.landmarks ?? []).map(({ at_m }, index): FoundPart => {
    return { list: "landmarks", index, distance_m: distance(at, point_of(at_m)) };
  });
  const zones = (building.zones ?? []).map((zone, index): FoundPart => {
    const edges = zone_edges(zone).map(([from, to]) => distance_to_segment(at, from, to));
    return { list: "zones", index, distance_m: Math.min(...edges) };
  });
  const near = [...landmarks, ...lines("barriers"), ...zones, ...lines("walls")].filter(
    ({ distance_m }) => distance_m <= within_m,
  );
  return near.reduce<FoundPart | undefined>(
    (best, part) => (best === undefined || part.distance_m < best.distance_m ? part : best),
    undefined,
  );
}

/** The end points of a wall or line, where a landmark is, or a zone's closed outline. */
export function part_points(building: Building, { list, index }: FoundPart): Point[] {
  const part = building[list]?.[index];
  if (!part) return [];
  if ("outline_m" in part) return zone_outline(part);
  return "at_m" in part ? [point_of(part.at_m)] : [point_of(part.start_m), point_of(part.end_m)];
}

export function without_part(building: Building, { list, index }: FoundPart): Building {
  return { ...building, [list]: (building[list] ?? []).filter((_, at) => at !== index) };
}

/** Adds a line that the vehicle never crosses: an operator's keep-out line, or a pane of glass. */
export function with_barrier(building: Building, kind: Barrier["kind"], from: Point, to: Point): Building {
  const barrier = { kind, start_m: pair(from), end_m: pair(to) };
  return { ...building, barriers: [...(building.barriers ?? []), barrier] };
}

/**
 * Adds a rectangular zone that was drawn from one corner to the opposite one. A one-way zone is driven along its longer
 * side, the way it was drawn. @throws Error where it has no area, or a slow zone no speed
 */
export function with_zone(
  building: Building,
  kind: Zone["kind"],
  from: Point,
  to: Point,
  speed_max_mps: number,
): Building {
  const [width_m, height_m] = [to.x - from.x, to.y - from.y];
  if (Math.min(Math.abs(width_m), Math.abs(height_m)) < 0.05) throw new Error("a zone is at least 5 cm wide");
  const zone: Zone = { kind, outline_m: rectangle(from, to).slice(0, 4).map(pair) };
  if (kind === "slow") {
    if (!(speed_max_mps >= 0.01 && speed_max_mps <= 20))
      throw new Error("a slow zone's speed is 0.01 to 20 m/s");
    zone.speed_max_mps = speed_max_mps;
  }
  if (kind === "one_way") {
    if (Math.abs(width_m) > Math.abs(height_m)) zone.direction_deg = width_m > 0 ? 0 : 180;
    else zone.direction_deg = height_m > 0 ? 90 : -90;
  }
  return { ...building, zones: [...(building.zones ?? []), zone] };
}

/** Marks occupied floor along a line as free, where an obstacle is false. @throws Error without a floor */
export function with_cleared(building: Building, from: Point, to: Point): Building {
  if (!building.floor) throw new Error("this building has no floor to clear");
  const free = with_line(building.floor, from, to, (cell) => (cell === "#" ? "." : cell));
  return { ...building, floor: free };
}
