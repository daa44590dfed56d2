/** Figures as lines of text: nested keys are joined, numbers shortened. */
export function figure_lines(figures: unknown, stem = ""): [string, string][] {
  if (Array.isArray(figures)) {
    return figures.flatMap((value, index) => figure_lines(value, `${stem} ${index + 1}`.trim()));
  }
  if (typeof figures === "object" && figures !== null) {
    return Object.entries(figures).flatMap(([key, value]) => figure_lines(value, `${stem} ${key}`.trim()));
  }
  return [[stem, typeof figures === "number" ? short_number(figures) : String(figures)]];
}

export function short_number(value: number): string {
  return Number.isInteger(value) ? String(value) : String(Number(value.toPrecision(5)));
}

export function short_bytes(bytes: number): string {
  if (bytes < 1000) return `${bytes} B`;
  const power = bytes < 1e6 ? 1 : bytes < 1e9 ? 2 : 3;
  return `${(bytes / 1000 ** power).toPrecision(3)} ${["kB", "MB", "GB"][power - 1]}`;
}
