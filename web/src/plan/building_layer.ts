import type { Building, Floor } from "../building/building_file";
import { named_rooms } from "../building/named_rooms";
import { colour } from "../page/theme";
import { floor_runs, point_of, route_points, zone_arrow, zone_outline } from "./building_geometry";
import {
  barrier_stroke,
  zone_stroke,
  draw_area,
  draw_dots,
  draw_line,
  draw_name,
  draw_segments,
} from "./draw";
import type { Point } from "./geometry";
import type { Layer } from "./plan_canvas";

/** Rows overlap by this share of a cell, so that no gaps show between them. */
const overlap = 0.06;

function cells_path(floor: Floor, is_free: boolean): Path2D {
  const path = new Path2D();
  for (const run of floor_runs(floor)) {
    if (run.is_free === is_free) path.rect(run.low.x, run.low.y, run.length_m, floor.cell_m * (1 + overlap));
  }
  return path;
}

/** The floor, traced once in map coordinates [m]: free cells first, so that occupied cells stay visible. */
export function floor_layer(floor: Floor): Layer {
  const [free, blocked] = [cells_path(floor, true), cells_path(floor, false)];
  return (context, view) => {
    const origin = view.to_screen({ x: 0, y: 0 });
    context.save();
    context.translate(origin.x, origin.y);
    context.scale(view.scale_px_per_m, -view.scale_px_per_m);
    context.fillStyle = colour("floor");
    context.fill(free);
    context.fillStyle = colour("blocked");
    context.fill(blocked);
    context.restore();
  };
}

export function building_layer(building: Building): Layer {
  const floor = building.floor ? floor_layer(building.floor) : undefined;
  const routes = (building.routes ?? []).map(route_points);
  return (context, view) => {
    floor?.(context, view);
    for (const { outlines } of named_rooms(building)) draw_area(context, view, outlines, colour("accent"));
    const graph = { colour: colour("graph"), width_px: 1.5, dash_px: [6, 4] };
    for (const { path_m } of building.corridors?.corridors ?? []) {
      draw_line(context, view, path_m.map(point_of), graph);
    }
    draw_dots(
      context,
      view,
      (building.corridors?.nodes ?? []).map(({ at_m }) => point_of(at_m)),
      graph.colour,
      3.5,
    );
    for (const route of routes) draw_line(context, view, route, { colour: colour("path"), width_px: 1.5 });
    const walls = (building.walls ?? []).map(({ start_m, end_m }): [Point, Point] => [
      point_of(start_m),
      point_of(end_m),
    ]);
    draw_segments(context, view, walls, { colour: colour("wall"), width_px: 2.5 });
    draw_dots(
      context,
      view,
      (building.landmarks ?? []).map(({ at_m }) => point_of(at_m)),
      colour("landmark"),
      2.5,
    );
    for (const { kind, start_m, end_m } of building.barriers ?? []) {
      draw_line(context, view, [point_of(start_m), point_of(end_m)], barrier_stroke(kind));
    }
    for (const zone of building.zones ?? []) {
      draw_line(context, view, zone_outline(zone), zone_stroke(zone.kind));
      if (zone.kind === "one_way") draw_line(context, view, zone_arrow(zone), zone_stroke(zone.kind));
    }
    for (const { name, at_m } of building.places ?? []) {
      draw_dots(context, view, [point_of(at_m)], colour("accent"), 4);
      draw_name(context, view, point_of(at_m), name);
    }
  };
}
