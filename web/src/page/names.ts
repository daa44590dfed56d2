/** Of the names of sessions and buildings: docs/reference/live-server.md. */
export const name_pattern = "[A-Za-z0-9_\\-][A-Za-z0-9_.\\-]{0,63}";
