import { text } from "../text";

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
  /** A name is proposed, but the field may be left empty. */
  is_proposed?: boolean;
  choices?: string[];
}

export interface MissionForm {
  mission: string;
  label: string;
  begin: string;
  about: string;
  fields: Field[];
}

const keep_session: Field = { key: "session", label: text.fields.record_as, kind: "new_session" };
const building: Field = { key: "building", label: text.fields.building, kind: "building", is_needed: true };
const methods = ["landmarks", "sections", "rooms"];

export const mission_forms: MissionForm[] = [
  {
    mission: "explore",
    ...text.missions.explore,
    fields: [{ key: "building", label: text.fields.learn_as, kind: "new_building", is_proposed: true }],
  },
  {
    mission: "drive",
    ...text.missions.drive,
    fields: [keep_session],
  },
  {
    mission: "teach",
    ...text.missions.teach,
    fields: [
      { key: "session", label: text.fields.taught_run, kind: "new_session", is_needed: true },
      { key: "route", label: text.fields.route, kind: "text" },
      { key: "method", label: text.fields.method, kind: "method", choices: methods },
      { key: "scripted", label: text.fields.scripted, kind: "yes" },
    ],
  },
  {
    mission: "learn",
    ...text.missions.learn,
    fields: [
      { key: "session", label: text.fields.taught_run, kind: "session", is_needed: true },
      { key: "building", label: text.fields.learn_as, kind: "new_building", is_needed: true },
      { key: "method", label: text.fields.method, kind: "method", choices: methods },
    ],
  },
  {
    mission: "navigate",
    ...text.missions.navigate,
    fields: [
      building,
      { key: "route", label: text.fields.route, kind: "route" },
      { key: "reverse", label: text.fields.reverse, kind: "yes" },
      keep_session,
    ],
  },
  {
    mission: "go",
    ...text.missions.go,
    fields: [
      building,
      { key: "place", label: text.fields.place, kind: "place", is_needed: true },
      keep_session,
    ],
  },
  {
    mission: "patrol",
    ...text.missions.patrol,
    fields: [building, { key: "rounds", label: text.fields.rounds, kind: "count" }, keep_session],
  },
  {
    mission: "park",
    ...text.missions.park,
    fields: [
      building,
      { key: "place", label: text.fields.place, kind: "place", is_needed: true },
      keep_session,
    ],
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
