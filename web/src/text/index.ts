/** What the page says, in the language that the user has chosen; until then in that of the browser. */

import { english } from "./english";
import { german } from "./german";

export const languages = { en: "English", de: "Deutsch" };

export type Language = keyof typeof languages;

const storage_key = "aisle.language";

function chosen(): Language {
  const wanted = globalThis.localStorage?.getItem(storage_key) ?? globalThis.navigator?.language;
  return wanted?.startsWith("de") ? "de" : "en";
}

export const language = chosen();

export const text = language === "de" ? german : english;

/** Takes effect when the page is loaded again, which this does. */
export function choose_language(wanted: Language): void {
  localStorage.setItem(storage_key, wanted);
  location.reload();
}
