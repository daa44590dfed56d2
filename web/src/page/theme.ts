/** Dark or light: the system's setting until the user chooses. */

type Theme = "dark" | "light";

const storage_key = "aisle.theme";
const system_prefers_dark = matchMedia("(prefers-color-scheme: dark)");

function chosen(): Theme | undefined {
  const value = localStorage.getItem(storage_key);
  return value === "dark" || value === "light" ? value : undefined;
}

export function present_theme(): Theme {
  return chosen() ?? (system_prefers_dark.matches ? "dark" : "light");
}

function show(): void {
  document.documentElement.dataset["theme"] = present_theme();
  dispatchEvent(new Event("aisle-theme"));
}

export function toggle_theme(): void {
  localStorage.setItem(storage_key, present_theme() === "dark" ? "light" : "dark");
  show();
}

export function follow_theme(): void {
  system_prefers_dark.addEventListener("change", show);
  show();
}

/** The style sheet's colour with this name, for drawing on a canvas. */
export function colour(name: string): string {
  return getComputedStyle(document.documentElement).getPropertyValue(`--${name}`).trim();
}
