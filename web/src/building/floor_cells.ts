/** Floor rows are run-length encoded as in docs/formats/building.md: `12-40.3#`. */

import type { Point } from "../plan/geometry";
import type { Floor } from "./building_file";

export type FloorCell = "-" | "." | "#";

export function unpack_row(row: string): FloorCell[] {
  return [...row.matchAll(/(\d+)([-.#])/g)].flatMap(([, count, what]) =>
    Array<FloorCell>(Number(count)).fill(what as FloorCell),
  );
}

export function pack_row(cells: readonly FloorCell[]): string {
  const known = cells.slice(0, cells.findLastIndex((cell) => cell !== "-") + 1);
  const runs: { cell: FloorCell; count: number }[] = [];
  for (const cell of known) {
    const last = runs.at(-1);
    if (last?.cell === cell) last.count += 1;
    else runs.push({ cell, count: 1 });
  }
  return runs.map(({ cell, count }) => `${count}${cell}`).join("");
}

/** Cells that a line passes through, as [column, row] of the map. */
export function cells_along(cell_m: number, from: Point, to: Point): [number, number][] {
  const steps = Math.max(1, Math.ceil((Math.hypot(to.x - from.x, to.y - from.y) / cell_m) * 4));
  const passed = new Map<string, [number, number]>();
  for (let step = 0; step <= steps; step += 1) {
    const t = step / steps;
    const column = Math.floor((from.x + t * (to.x - from.x)) / cell_m);
    const row = Math.floor((from.y + t * (to.y - from.y)) / cell_m);
    passed.set(`${column} ${row}`, [column, row]);
  }
  return [...passed.values()];
}

/** The floor with the cells along a line changed; rows outside the floor stay unknown. */
export function with_line(
  floor: Floor,
  from: Point,
  to: Point,
  change: (cell: FloorCell) => FloorCell,
): Floor {
  const rows = [...floor.rows];
  const changed_rows = new Map<number, FloorCell[]>();
  for (const [column, row] of cells_along(floor.cell_m, from, to)) {
    const index = row - floor.low_cell[1];
    const place = column - floor.low_cell[0];
    if (index < 0 || index >= rows.length || place < 0) continue;
    const cells = changed_rows.get(index) ?? unpack_row(rows[index] ?? "");
    changed_rows.set(index, cells);
    while (cells.length <= place) cells.push("-");
    cells[place] = change(cells[place] ?? "-");
  }
  for (const [index, cells] of changed_rows) rows[index] = pack_row(cells);
  return { ...floor, rows };
}
