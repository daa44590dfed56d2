import type { Building } from "../building/building_file";
import { named_rooms } from "../building/named_rooms";
import { colour } from "../page/theme";
import { text } from "../text";
import { apply_stroke, area_opacity, barrier_stroke, draw_caption, zone_stroke } from "./draw";
import type { Stroke } from "./draw";
import type { LivePlan } from "./live_plan";
import type { PlanView } from "./plan_view";

/** What a plan can show. */
export type Shown = keyof typeof text.plan.legend_of;

const in_order = Object.keys(text.plan.legend_of) as Shown[];

interface Sample extends Stroke {
  form: "area" | "line" | "dot";
  /** Of an area's inside. */
  opacity?: number;
}

/** How each of it is drawn. */
function sample_of(shown: Shown): Sample {
  const samples: Record<Shown, () => Sample> = {
    free: () => ({ form: "area", colour: colour("floor"), width_px: 1 }),
    occupied: () => ({ form: "area", colour: colour("blocked"), width_px: 1 }),
    walls: () => ({ form: "line", colour: colour("wall"), width_px: 2.5 }),
    landmarks: () => ({ form: "dot", colour: colour("landmark"), width_px: 5 }),
    graph: () => ({ form: "line", colour: colour("graph"), width_px: 1.5, dash_px: [6, 4] }),
    routes: () => ({ form: "line", colour: colour("path"), width_px: 1.5 }),
    places: () => ({ form: "dot", colour: colour("accent"), width_px: 8 }),
    rooms: () => ({ form: "area", colour: colour("accent"), width_px: 1.5, opacity: area_opacity }),
    keep_out: () => ({ form: "line", ...barrier_stroke("keep_out") }),
    glass: () => ({ form: "line", ...barrier_stroke("glass") }),
    slow: () => ({ form: "line", ...zone_stroke("slow") }),
    one_way: () => ({ form: "line", ...zone_stroke("one_way") }),
    scan: () => ({ form: "dot", colour: colour("scan"), width_px: 3 }),
    trail: () => ({ form: "line", colour: colour("trail"), width_px: 1.5 }),
    path: () => ({ form: "line", colour: colour("path"), width_px: 2, dash_px: [2, 5] }),
    vehicle: () => ({ form: "dot", colour: colour("accent"), width_px: 9 }),
  };
  return samples[shown]();
}

export function shown_of_building(building: Building): Set<Shown> {
  const shown = new Set<Shown>();
  if (building.floor) shown.add("free").add("occupied");
  if (building.corridors?.corridors.length) shown.add("graph");
  for (const list of ["walls", "landmarks", "routes", "places"] as const)
    if (building[list]?.length) shown.add(list);
  if (named_rooms(building).length > 0) shown.add("rooms");
  for (const { kind } of [...(building.barriers ?? []), ...(building.zones ?? [])]) shown.add(kind);
  return shown;
}

/** @param is_hidden whether the layer with this name is switched off */
export function shown_live(plan: LivePlan, is_hidden: (layer: string) => boolean): Set<Shown> {
  const shown = new Set<Shown>();
  const add = (kind: Shown, is_there: boolean, layer: string = kind) => {
    if (is_there && !is_hidden(layer)) shown.add(kind);
  };
  add("free", plan.floor !== undefined, "floor");
  add("occupied", plan.floor !== undefined, "floor");
  const marked = new Set([...plan.marks.values()].map(({ namespace }) => namespace));
  for (const kind of ["landmarks", "graph"] as const) add(kind, marked.has(kind));
  for (const kind of ["walls", "routes", "keep_out", "glass", "slow", "one_way"] as const)
    add(kind, marked.has(kind), "walls");
  add("scan", plan.scan.length > 0);
  add("trail", plan.trail.length > 1);
  add("path", plan.path.length > 1);
  add("vehicle", plan.pose !== undefined);
  return shown;
}

const line_px = 17;
const sample_px = 24;
const margin_px = 12;
/** Above the scale bar. */
const bottom_px = 34;

function draw_sample(context: CanvasRenderingContext2D, x: number, y: number, sample: Sample): void {
  apply_stroke(context, sample);
  context.fillStyle = sample.colour;
  context.beginPath();
  if (sample.form === "line") {
    context.moveTo(x, y);
    context.lineTo(x + sample_px, y);
  } else if (sample.form === "dot") {
    context.arc(x + sample_px / 2, y, sample.width_px / 2, 0, 2 * Math.PI);
    context.fill();
    return;
  } else {
    context.rect(x, y - 5, sample_px, 10);
    context.globalAlpha = sample.opacity ?? 1;
    context.fill();
    context.globalAlpha = 1;
    if (sample.opacity === undefined) context.strokeStyle = colour("muted");
  }
  context.stroke();
}

/** What the plan shows, in the lower left corner, in as many columns as half of its height needs. */
export function draw_legend(
  context: CanvasRenderingContext2D,
  view: PlanView,
  shown: ReadonlySet<Shown>,
): void {
  const entries = in_order.filter((kind) => shown.has(kind));
  if (entries.length === 0) return;
  const rows = Math.max(1, Math.min(entries.length, Math.floor((view.height_px / 2 - bottom_px) / line_px)));
  const columns = Math.ceil(entries.length / rows);
  context.font = "12px system-ui, sans-serif";
  const words_px = Math.max(...entries.map((kind) => context.measureText(text.plan.legend_of[kind]).width));
  const column_px = sample_px + 8 + words_px + 12;
  const top_px = view.height_px - bottom_px - rows * line_px;
  context.globalAlpha = 0.85;
  context.fillStyle = colour("sheet");
  context.fillRect(margin_px - 6, top_px - 4, columns * column_px, rows * line_px + 8);
  context.globalAlpha = 1;
  entries.forEach((kind, index) => {
    const x = margin_px + Math.floor(index / rows) * column_px;
    const y = top_px + (index % rows) * line_px + line_px / 2;
    draw_sample(context, x, y, sample_of(kind));
    draw_caption(context, { x: x + sample_px + 8, y }, text.plan.legend_of[kind]);
  });
}
