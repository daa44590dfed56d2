/** The parts of a building file (docs/formats/building.md) that the page shows and edits. */

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

/** An area in which vehicles stay out, drive slowly, or drive one way only. */
export interface Zone {
  kind: "keep_out" | "slow" | "one_way";
  name?: string;
  outline_m: Pair[];
  speed_max_mps?: number;
  direction_deg?: number;
}

export interface Landmark {
  at_m: Pair;
}

/** A list of objects in its compact form: the keys once, then a row of values for each object. */
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

export interface CorridorNode {
  kind: string;
  at_m: Pair;
}

export interface Corridor {
  path_m: Pair[];
}

export interface Building {
  format: string;
  version: number;
  name?: string;
  walls?: Wall[];
  landmarks?: Landmark[];
  routes?: Route[];
  corridors?: { nodes: CorridorNode[]; corridors: Corridor[] };
  places?: Place[];
  barriers?: Barrier[];
  zones?: Zone[];
  floor?: Floor;
}

/** Versions 1 and 2 name a corridor's polyline `way_m`. */
type FileCorridor = Corridor | { way_m: Pair[] };

/** A building as its file has it, of version 1, 2 or 3. */
export type BuildingFile = Omit<Building, "landmarks" | "corridors"> & {
  landmarks?: Landmark[] | Table;
  corridors?: { nodes: CorridorNode[]; corridors: FileCorridor[] };
};

/** The version that the page works with and saves. */
const building_version = 3;

/** The building of a file; an older version is converted to version 3. */
export function building_of({ landmarks, corridors, ...parts }: BuildingFile): Building {
  const building: Building = { ...parts, version: Math.max(parts.version, building_version) };
  if (landmarks) building.landmarks = Array.isArray(landmarks) ? landmarks : landmarks_of(landmarks);
  if (corridors) building.corridors = { ...corridors, corridors: corridors.corridors.map(corridor_of) };
  return building;
}

function corridor_of(corridor: FileCorridor): Corridor {
  if (!("way_m" in corridor)) return corridor;
  const { way_m, ...others } = corridor;
  return { ...others, path_m: way_m };
}

/** A null in a row means that the object does not have this key. */
function landmarks_of({ columns, rows }: Table): Landmark[] {
  return rows.map((row) =>
    Object.fromEntries(columns.map((key, at) => [key, row[at]]).filter(([, value]) => value !== null)),
  ) as Landmark[];
}
