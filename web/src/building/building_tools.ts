import { colour } from "../page/theme";
import { text } from "../text";
import { draw_dots, draw_line } from "../plan/draw";
import { direction_deg, rectangle } from "../plan/geometry";
import type { Point } from "../plan/geometry";
import type { Layer, PlanCanvas, PlanTool } from "../plan/plan_canvas";
import {
  nearest_part,
  part_points,
  with_barrier,
  with_cleared,
  with_zone,
  without_part,
} from "./building_edits";
import type { FoundPart } from "./building_edits";
import type { Building, Zone } from "./building_file";
import { room_middle } from "./room_middle";

export type ToolName = "look" | "place" | "room" | "delete" | LineToolName;

type LineToolName = "keep_out" | "glass" | "keep_out_zone" | "slow_zone" | "one_way_zone" | "clear";

export const tool_labels = Object.entries(text.building.tools).map(([value, words]) => ({ value, ...words }));

const near_px = 12;

interface Editing {
  building(): Building | undefined;
  /** What a second click will delete, or nothing. */
  marked(part: FoundPart | undefined): void;
  /** Applies the change as a new version; an error that it throws is shown as a notice. */
  edit(change: (building: Building) => Building): void;
  /** A position was clicked or, with a heading, dragged from. */
  pick_place(heading_deg: number | undefined): void;
  /** No free floor is known where a room was clicked. */
  miss_room(): void;
  /** Of the next slow zone. */
  zone_speed_mps(): number;
}

type LineEdit = (building: Building, from: Point, to: Point, zone_speed_mps: number) => Building;

const zone_edit =
  (kind: Zone["kind"]): LineEdit =>
  (building, from, to, speed_mps) =>
    with_zone(building, kind, from, to, speed_mps);

const line_edits: Record<LineToolName, LineEdit> = {
  keep_out: (building, from, to) => with_barrier(building, "keep_out", from, to),
  glass: (building, from, to) => with_barrier(building, "glass", from, to),
  keep_out_zone: zone_edit("keep_out"),
  slow_zone: zone_edit("slow"),
  one_way_zone: zone_edit("one_way"),
  clear: with_cleared,
};

/** What clicks and drags on the plan do with each tool, and the line being drawn. */
export class BuildingTools {
  readonly layer: Layer;
  /** Position of the place that is about to be named. */
  place: Point | undefined;
  /** Where its heading points to. */
  #headed: Point | undefined;
  #line: [Point, Point] | undefined;
  /** The line is a zone's diagonal. */
  #is_area = false;
  /** What is about to be deleted. */
  #marked: FoundPart | undefined;

  constructor(
    private readonly canvas: PlanCanvas,
    private readonly editing: Editing,
  ) {
    this.layer = (context, view) => {
      if (this.#line) {
        const drawn = this.#is_area ? rectangle(...this.#line) : this.#line;
        draw_line(context, view, drawn, { colour: colour("trouble"), width_px: 3 });
      }
      const building = this.#marked && this.editing.building();
      const points = building && this.#marked ? part_points(building, this.#marked) : [];
      draw_line(context, view, points, { colour: colour("trouble"), width_px: 7 });
      draw_dots(context, view, points, colour("trouble"), 6);
      if (!this.place) return;
      draw_dots(context, view, [this.place], colour("path"), 6);
      const heading = this.#headed ? [this.place, this.#headed] : [];
      draw_line(context, view, heading, { colour: colour("path"), width_px: 2 });
    };
  }

  choose(name: ToolName): void {
    this.place = undefined;
    this.#line = undefined;
    this.#mark(undefined);
    this.canvas.tool = this.#tool(name);
    this.canvas.redraw();
  }

  #tool(name: ToolName): PlanTool {
    if (name === "look") return {};
    if (name === "place") {
      return {
        click: (at) => this.#place_at([at], true),
        drag: (...[from, to, ended]) => this.#place_at([from, to], ended),
        cancel: () => this.#place_at([], false),
      };
    }
    if (name === "room") return { click: (at) => this.#room_at(at) };
    if (name === "delete")
      return {
        click: (at) => this.#delete(at),
        hover: (at) => this.#mark(at && this.#found(at)),
      };
    const edit = line_edits[name];
    this.#is_area = name.endsWith("zone");
    return {
      drag: (from, to, ended) => {
        this.#line = ended ? undefined : [from, to];
        if (ended) this.editing.edit((building) => edit(building, from, to, this.editing.zone_speed_mps()));
        this.canvas.redraw();
      },
      cancel: () => {
        this.#line = undefined;
        this.canvas.redraw();
      },
    };
  }

  /** @param drawn the position, and where its heading points to */
  #place_at(drawn: Point[], ended: boolean): void {
    [this.place, this.#headed] = drawn;
    if (ended && this.place) this.editing.pick_place(this.#headed && direction_deg(this.place, this.#headed));
    this.canvas.redraw();
  }

  /** A room's name is a place in its middle. */
  #room_at(at: Point): void {
    const floor = this.editing.building()?.floor;
    const middle = floor && room_middle(floor, at);
    if (middle) this.#place_at([middle], true);
    else this.editing.miss_room();
  }

  #found(at: Point): FoundPart | undefined {
    const building = this.editing.building();
    return building && nearest_part(building, at, near_px / this.canvas.view.scale_px_per_m);
  }

  #mark(part: FoundPart | undefined): void {
    if (part?.list === this.#marked?.list && part?.index === this.#marked?.index) return;
    this.#marked = part;
    this.editing.marked(part);
    this.canvas.redraw();
  }

  /** Deletes what is marked; where nothing is, as under a finger, marks it first. */
  #delete(at: Point): void {
    const found = this.#found(at);
    const is_marked = found && found.list === this.#marked?.list && found.index === this.#marked.index;
    this.#mark(is_marked ? undefined : found);
    if (is_marked) this.editing.edit((present) => without_part(present, found));
  }
}
