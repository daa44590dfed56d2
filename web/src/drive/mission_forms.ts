/** The fields of each mission: the table of docs/reference/live-server.md. */

export type FieldKind =
  | "new_session"
  | "session"
  | "new_building"
  | "building"
  | "route"
  | "place"
  | "text"
  | "count"
  | "yes"
  | "method";

export interface Field {
  key: string;
  label: string;
  kind: FieldKind;
  is_needed?: boolean;
  choices?: string[];
}

export interface MissionForm {
  mission: string;
  label: string;
  begin: string;
  about: string;
  fields: Field[];
}

const keep_session: Field = { key: "session", label: "Record as", kind: "new_session" };
const building: Field = { key: "building", label: "Building", kind: "building", is_needed: true };
const methods = ["landmarks", "sections", "route"];

export const mission_forms: MissionForm[] = [
  {
    mission: "explore",
    label: "Explore",
    begin: "Explore",
    about: "The vehicle explores the building by itself and returns to the start.",
    fields: [{ key: "building", label: "Learn as", kind: "new_building" }],
  },
  {
    mission: "drive",
    label: "Drive by hand",
    begin: "Begin",
    about: "You drive; nothing is learned.",
    fields: [keep_session],
  },
  {
    mission: "teach",
    label: "Teach",
    begin: "Start teaching",
    about: "Drive the route once by hand; then learn it.",
    fields: [
      { key: "session", label: "Taught run", kind: "new_session", is_needed: true },
      { key: "route", label: "Route", kind: "text" },
      { key: "method", label: "Method", kind: "method", choices: methods },
      { key: "scripted", label: "A simulated driver drives", kind: "yes" },
    ],
  },
  {
    mission: "learn",
    label: "Learn",
    begin: "Learn",
    about: "Builds a map with the route from a taught run.",
    fields: [
      { key: "session", label: "Taught run", kind: "session", is_needed: true },
      { key: "building", label: "Learn as", kind: "new_building", is_needed: true },
      { key: "method", label: "Method", kind: "method", choices: methods },
    ],
  },
  {
    mission: "navigate",
    label: "Navigate",
    begin: "Drive the route",
    about: "The vehicle drives a taught route.",
    fields: [
      building,
      { key: "route", label: "Route", kind: "route" },
      { key: "reverse", label: "In reverse, from the end to the start", kind: "yes" },
      keep_session,
    ],
  },
  {
    mission: "go",
    label: "Go to a place",
    begin: "Go",
    about: "Drives to a place of the building. You can also click a point on the plan.",
    fields: [building, { key: "place", label: "Place", kind: "place", is_needed: true }, keep_session],
  },
  {
    mission: "patrol",
    label: "Patrol",
    begin: "Patrol",
    about: "Drives to all places of the building in turn.",
    fields: [building, { key: "rounds", label: "Rounds", kind: "count" }, keep_session],
  },
  {
    mission: "park",
    label: "Park",
    begin: "Park",
    about: "Parks precisely at a place.",
    fields: [building, { key: "place", label: "Place", kind: "place", is_needed: true }, keep_session],
  },
];

/** The request of `mission/start` from the filled-in values; empty fields are left out. */
export function start_request(
  form: MissionForm,
  values: Record<string, string | boolean>,
): Record<string, unknown> {
  const request: Record<string, unknown> = { mission: form.mission };
  for (const { key } of form.fields) {
    const value = values[key];
    if (value === undefined || value === "" || value === false) continue;
    request[key] = key === "rounds" ? Number(value) : value;
  }
  return request;
}

/** An unused name, such as `taught-2`. Names of buildings get no dash: the number after a dash is the version. */
export function fresh_name(stem: string, taken: readonly string[]): string {
  for (let number = 1; ; number += 1) {
    const name = `${stem}${number}`;
    if (!taken.includes(name)) return name;
  }
}
