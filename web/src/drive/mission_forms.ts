/** What each mission asks for: the table of docs/reference/live-server.md. */

export type FieldKind =
  "new_session" | "session" | "new_building" | "building" | "route" | "place" | "text" | "yes" | "method";

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
    about: "The vehicle explores the building alone and comes home.",
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
    begin: "Begin the lesson",
    about: "Drive the way once by hand; then learn it.",
    fields: [
      { key: "session", label: "Lesson", kind: "new_session", is_needed: true },
      { key: "route", label: "Route", kind: "text" },
      { key: "method", label: "Method", kind: "method", choices: methods },
      { key: "scripted", label: "A simulated person drives", kind: "yes" },
    ],
  },
  {
    mission: "learn",
    label: "Learn",
    begin: "Learn",
    about: "Makes a building of a lesson.",
    fields: [
      { key: "session", label: "Lesson", kind: "session", is_needed: true },
      { key: "building", label: "Learn as", kind: "new_building", is_needed: true },
      { key: "method", label: "Method", kind: "method", choices: methods },
    ],
  },
  {
    mission: "navigate",
    label: "Navigate",
    begin: "Drive the route",
    about: "The vehicle drives a route that it was taught.",
    fields: [
      building,
      { key: "route", label: "Route", kind: "route" },
      { key: "reverse", label: "Back, from the end", kind: "yes" },
      keep_session,
    ],
  },
  {
    mission: "go",
    label: "Go to a place",
    begin: "Go",
    about: "To a place of the building, or click one on the plan.",
    fields: [building, { key: "place", label: "Place", kind: "place", is_needed: true }, keep_session],
  },
  {
    mission: "patrol",
    label: "Patrol",
    begin: "Patrol",
    about: "Through all places of the building.",
    fields: [building, { key: "rounds", label: "Rounds", kind: "text" }, keep_session],
  },
  {
    mission: "park",
    label: "Park",
    begin: "Park",
    about: "Comes to stand exactly at a place.",
    fields: [building, { key: "place", label: "Place", kind: "place", is_needed: true }, keep_session],
  },
];

/** The request of `mission/start` from what was filled in; what is empty is left out. */
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

/** A name that is not there yet, such as `lesson-2`. A building's has no dash: what follows one counts versions. */
export function fresh_name(stem: string, taken: readonly string[]): string {
  for (let number = 1; ; number += 1) {
    const name = `${stem}${number}`;
    if (!taken.includes(name)) return name;
  }
}
