/** The layers of the live plan, by the names under which they are switched on and off. */

import type { Floor, Place } from "../building/building_file";
import { named_rooms } from "../building/named_rooms";
import type { NamedRoom } from "../building/named_rooms";
import { colour } from "../page/theme";
import { floor_layer } from "./building_layer";
import {
  barrier_stroke,
  draw_area,
  draw_dots,
  draw_ellipse,
  draw_line,
  draw_name,
  draw_ring,
  draw_segments,
  draw_vehicle,
  zone_stroke,
} from "./draw";
import type { Stroke } from "./draw";
import type { Point } from "./geometry";
import type { LivePlan, Mark } from "./live_plan";
import type { Layer } from "./plan_canvas";

function pairs(points: Point[]): [Point, Point][] {
  const made: [Point, Point][] = [];
  for (let first = 0; first + 1 < points.length; first += 2) {
    made.push([points[first] as Point, points[first + 1] as Point]);
  }
  return made;
}

function stroke_of(namespace: string): Stroke {
  if (namespace === "walls") return { colour: colour("wall"), width_px: 2.5 };
  if (namespace === "keep_out" || namespace === "glass") return barrier_stroke(namespace);
  if (namespace === "slow" || namespace === "one_way") return zone_stroke(namespace);
  if (namespace === "routes") return { colour: colour("path"), width_px: 1.5 };
  if (namespace === "graph") return { colour: colour("graph"), width_px: 1.5, dash_px: [6, 4] };
  return { colour: colour("muted"), width_px: 1.5 };
}

function draw_mark(mark: Mark, ...[context, view]: Parameters<Layer>): void {
  const stroke = stroke_of(mark.namespace);
  const dot = mark.namespace === "landmarks" ? colour("landmark") : stroke.colour;
  if (mark.kind === "segments") draw_segments(context, view, pairs(mark.points), stroke);
  else if (mark.kind === "line") draw_line(context, view, mark.points, stroke);
  else if (mark.kind === "points")
    draw_dots(context, view, mark.points, dot, mark.namespace === "landmarks" ? 2.5 : 4);
  else for (const at of mark.points) draw_name(context, view, at, mark.text);
}

function marks_layer(plan: LivePlan, wanted: (namespace: string) => boolean): Layer {
  return (context, view) => {
    for (const mark of plan.marks.values()) if (wanted(mark.namespace)) draw_mark(mark, context, view);
  };
}

/** Traces the floor again only when it has changed. */
function known_floor_layer(plan: LivePlan): Layer {
  let traced: Floor | undefined;
  let layer: Layer | undefined;
  return (context, view) => {
    if (plan.floor !== traced) {
      traced = plan.floor;
      layer = traced && floor_layer(traced);
    }
    layer?.(context, view);
  };
}

/** The rooms of a mission's building, by the floor that was known when its places were. */
function known_rooms_layer(plan: LivePlan): Layer {
  let traced = "";
  let rooms: NamedRoom[] = [];
  return (context, view) => {
    if (!plan.floor) return;
    const places = plan.places().map(({ x, y, name }): Place => ({ name, at_m: [x, y] }));
    const present = JSON.stringify(places);
    if (present !== traced) rooms = named_rooms({ floor: plan.floor, places });
    traced = present;
    for (const { outlines } of rooms) draw_area(context, view, outlines, colour("accent"));
  };
}

export function live_layers(plan: LivePlan): Record<string, Layer> {
  const [floor, rooms] = [known_floor_layer(plan), known_rooms_layer(plan)];
  return {
    floor: (...on) => {
      floor(...on);
      rooms(...on);
    },
    walls: marks_layer(plan, (namespace) => !["landmarks", "graph", "places"].includes(namespace)),
    landmarks: marks_layer(plan, (namespace) => namespace === "landmarks"),
    graph: marks_layer(plan, (namespace) => namespace === "graph" || namespace === "places"),
    scan: (context, view) => draw_dots(context, view, plan.scan, colour("scan"), 1.5),
    trail: (context, view) => {
      draw_line(context, view, plan.trail, { colour: colour("trail"), width_px: 1.5 });
      if (plan.pointed) draw_ring(context, view, plan.pointed);
    },
    path: (context, view) =>
      draw_line(context, view, plan.path, { colour: colour("path"), width_px: 2, dash_px: [2, 5] }),
    vehicle: (context, view) => {
      if (!plan.pose) return;
      if (plan.ellipse) draw_ellipse(context, view, plan.pose, plan.ellipse);
      draw_vehicle(context, view, plan.pose, plan.shape);
    },
  };
}
