/** The parts of a building as points of the plan. */

import type { Building, Floor, Pair, Route, Zone } from "../building/building_file";
import { moved_by } from "./geometry";
import type { Point, Pose } from "./geometry";

const arc_step_rad = 0.1;

export function point_of([x, y]: Pair): Point {
  return { x, y };
}

/** The path of `base_link` along a route. */
export function route_points({ start, pieces = [] }: Route): Point[] {
  if (!start) return [];
  let pose: Pose = { ...point_of(start.at_m), heading_rad: ((start.heading_deg ?? 0) * Math.PI) / 180 };
  const points: Point[] = [{ x: pose.x, y: pose.y }];
  for (const { length_m = 0, turn_deg = 0 } of pieces) {
    const turn_rad = (turn_deg * Math.PI) / 180;
    const parts = Math.max(1, Math.ceil(Math.abs(turn_rad) / arc_step_rad));
    for (let part = 0; part < parts; part += 1) {
      const middle = { ...pose, heading_rad: pose.heading_rad + turn_rad / parts / 2 };
      const half_rad = turn_rad / parts / 2;
      const chord_m = (length_m / parts) * (half_rad === 0 ? 1 : Math.sin(half_rad) / half_rad);
      pose = { ...moved_by(middle, { x: chord_m, y: 0 }), heading_rad: pose.heading_rad + turn_rad / parts };
      if (length_m !== 0) points.push({ x: pose.x, y: pose.y });
    }
  }
  return points;
}

/** A zone's corners, and the first one again. */
export function zone_outline({ outline_m }: Zone): Point[] {
  return [...outline_m, ...outline_m.slice(0, 1)].map(point_of);
}

export function zone_edges(zone: Zone): [Point, Point][] {
  const outline = zone_outline(zone);
  return outline.slice(1).map((to, index) => [outline[index] as Point, to]);
}

const arrow_m = 0.5;

/** An arrow in the middle of a one-way zone. */
export function zone_arrow({ outline_m, direction_deg = 0 }: Zone): Point[] {
  const middle = (axis: 0 | 1) => outline_m.reduce((sum, corner) => sum + corner[axis], 0) / outline_m.length;
  const pose: Pose = { x: middle(0), y: middle(1), heading_rad: (direction_deg * Math.PI) / 180 };
  const head: Pair[] = [
    [-arrow_m, 0],
    [arrow_m, 0],
    [arrow_m / 2, arrow_m / 4],
    [arrow_m / 2, -arrow_m / 4],
    [arrow_m, 0],
  ];
  return head.map((point) => moved_by(pose, point_of(point)));
}

export interface FloorRun {
  low: Point;
  length_m: number;
  is_free: boolean;
}

/** The known cells of a floor as runs, each within one row. */
export function floor_runs({ cell_m, low_cell, rows }: Floor): FloorRun[] {
  const runs: FloorRun[] = [];
  rows.forEach((row, index) => {
    let column = low_cell[0];
    for (const [, count, what] of row.matchAll(/(\d+)([-.#])/g)) {
      const cells = Number(count);
      const low = { x: column * cell_m, y: (low_cell[1] + index) * cell_m };
      if (what !== "-") runs.push({ low, length_m: cells * cell_m, is_free: what === "." });
      column += cells;
    }
  });
  return runs;
}

export function free_floor_m2(floor: Floor): number {
  const free = floor_runs(floor).filter(({ is_free }) => is_free);
  return free.reduce((sum, { length_m }) => sum + length_m * floor.cell_m, 0);
}

/** The end points of all runs of the known floor. */
export function* floor_points(floor: Floor): Iterable<Point> {
  for (const { low, length_m } of floor_runs(floor)) {
    yield low;
    yield { x: low.x + length_m, y: low.y };
  }
}

export function* building_points(building: Building): Iterable<Point> {
  for (const { start_m, end_m } of [...(building.walls ?? []), ...(building.barriers ?? [])])
    yield* [point_of(start_m), point_of(end_m)];
  for (const { outline_m } of building.zones ?? []) yield* outline_m.map(point_of);
  for (const { at_m } of building.landmarks ?? []) yield point_of(at_m);
  for (const { at_m } of building.places ?? []) yield point_of(at_m);
  for (const { at_m } of building.corridors?.nodes ?? []) yield point_of(at_m);
  for (const route of building.routes ?? []) yield* route_points(route);
  if (building.floor) yield* floor_points(building.floor);
}
