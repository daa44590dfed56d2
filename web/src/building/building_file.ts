/** A building file as docs/formats/building.md tells: the parts that the page shows and mends. */

export type Pair = [number, number];

export interface Wall {
  start_m: Pair;
  end_m: Pair;
}

/** A line that the vehicle never crosses. */
export interface Barrier {
  kind: "keep_out" | "glass";
  start_m: Pair;
  end_m: Pair;
}

export interface Landmark {
  at_m: Pair;
}

/** A list of objects as a file may have it: their keys once, then the values of each. */
interface Table {
  columns: string[];
  rows: unknown[][];
}

export interface Place {
  name: string;
  at_m: Pair;
  heading_deg?: number;
}

export interface RoutePiece {
  length_m?: number;
  turn_deg?: number;
}

export interface Route {
  name: string;
  start?: { at_m: Pair; heading_deg?: number };
  pieces?: RoutePiece[];
}

export interface Floor {
  cell_m: number;
  low_cell: Pair;
  rows: string[];
}

export interface Building {
  format: string;
  version: number;
  name?: string;
  walls?: Wall[];
  landmarks?: Landmark[];
  routes?: Route[];
  corridors?: { nodes: { kind: string; at_m: Pair }[]; corridors: { way_m: Pair[] }[] };
  places?: Place[];
  barriers?: Barrier[];
  floor?: Floor;
}

/** A building as it stands in its file. */
export type BuildingFile = Omit<Building, "landmarks"> & { landmarks?: Landmark[] | Table };

export function building_of({ landmarks, ...parts }: BuildingFile): Building {
  if (landmarks === undefined) return parts;
  return {
    ...parts,
    landmarks: Array.isArray(landmarks) ? landmarks : (objects_of(landmarks) as Landmark[]),
  };
}

/** What is null in a row its object has no key for. */
function objects_of({ columns, rows }: Table): object[] {
  return rows.map((row) =>
    Object.fromEntries(columns.map((key, at) => [key, row[at]]).filter(([, value]) => value !== null)),
  );
}
