import type { Building, Floor } from "../building/building_file";
import { colour } from "../page/theme";
import { floor_runs, point_of, route_points } from "./building_geometry";
import { draw_dots, draw_line, draw_name, draw_pieces } from "./draw";
import type { Point } from "./geometry";
import type { Layer } from "./plan_canvas";

/** The floor as bars: free ones first, so that what is blocked stays in sight. */
function floor_layer(floor: Floor): Layer {
  const runs = floor_runs(floor);
  return (context, view) => {
    const height_px = Math.ceil(floor.cell_m * view.scale_px_per_m);
    for (const is_free of [true, false]) {
      context.fillStyle = colour(is_free ? "floor" : "blocked");
      for (const run of runs) {
        if (run.is_free !== is_free) continue;
        const { x, y } = view.to_screen(run.low);
        context.fillRect(x, y - height_px, Math.ceil(run.length_m * view.scale_px_per_m), height_px);
      }
    }
  };
}

export function building_layer(building: Building): Layer {
  const floor = building.floor ? floor_layer(building.floor) : undefined;
  const routes = (building.routes ?? []).map(route_points);
  return (context, view) => {
    floor?.(context, view);
    const graph = { colour: colour("graph"), width_px: 1.5, dash_px: [6, 4] };
    for (const { way_m } of building.corridors?.corridors ?? []) {
      draw_line(context, view, way_m.map(point_of), graph);
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
    draw_pieces(context, view, walls, { colour: colour("wall"), width_px: 2.5 });
    draw_dots(
      context,
      view,
      (building.landmarks ?? []).map(({ at_m }) => point_of(at_m)),
      colour("landmark"),
      2.5,
    );
    for (const { name, at_m } of building.places ?? []) {
      draw_dots(context, view, [point_of(at_m)], colour("accent"), 4);
      draw_name(context, view, point_of(at_m), name);
    }
  };
}
