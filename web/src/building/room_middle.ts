/** Where a room has most space: there its name is put. */

import type { Point } from "../plan/geometry";
import type { Floor } from "./building_file";
import { clearances_of } from "./clearances";
import type { Clearances } from "./clearances";

/** Space may shrink over this distance on the way to where there is more: furniture stands about. */
const look_m = 0.5;

/** The cell with most space, the nearest of equals, of those to which free floor leads within a distance. */
function best_near(clearances: Clearances, start: number, within: number): number {
  const { columns, offsets } = clearances;
  const away = (cell: number) =>
    Math.hypot(
      Math.floor(cell / columns) - Math.floor(start / columns),
      (cell % columns) - (start % columns),
    );
  let best = start;
  const seen = new Set([start]);
  for (const cell of seen) {
    if (clearances.at(cell) > clearances.at(best)) best = cell;
    for (const offset of offsets) {
      const next = cell + offset;
      if (clearances.at(next) > 0 && away(next) <= within) seen.add(next);
    }
  }
  return best;
}

/**
 * From a point of the free floor to where there is more space, until nowhere near has more: the middle of the room, or of
 * the corridor beside the point. Doors are narrow, so it does not leave the room. undefined: no free floor is known there
 */
export function room_middle(floor: Floor, at: Point): Point | undefined {
  const clearances = clearances_of(floor);
  let cell = clearances.cell_at(at);
  if (cell === undefined || clearances.at(cell) === 0) return undefined;
  for (let next = -1; next !== cell;) {
    if (next >= 0) cell = next;
    next = best_near(clearances, cell, look_m / floor.cell_m);
  }
  const { x, y } = clearances.low_corner(cell);
  return { x: x + floor.cell_m / 2, y: y + floor.cell_m / 2 };
}
