/** Tells a user who looks elsewhere that a mission has ended. */

import { text } from "../text";
import { tick } from "./element";
import { Kept } from "./kept";
import type { Notices } from "./notices";
import { Signal } from "./signal";

const wanted = new Kept("aisle.notify", ["off", "on"]);

/** What the user has not seen yet, for the title of the page: ✓ or ✗. */
export const unseen = new Signal("");

addEventListener("focus", () => (unseen.value = ""));

function can_notify(): boolean {
  return "Notification" in window && isSecureContext;
}

export function tell_elsewhere(message: string, ok: boolean): void {
  if (document.hasFocus()) return;
  unseen.value = ok ? "✓" : "✗";
  if (wanted.value === "off" || !can_notify() || Notification.permission !== "granted") return;
  try {
    new Notification("aisle", { body: message, tag: "aisle-end", lang: document.documentElement.lang });
  } catch {
    // Some phones allow this to service workers alone: the title has to do.
  }
}

/** Asks the browser for the permission when it is switched on. @returns nothing where the browser has no notifications */
export function notify_switch(notices: Notices): HTMLElement | undefined {
  if (!can_notify()) return undefined;
  const made = tick(text.mission.notify, wanted.value === "on", (on) => void choose(on));
  const choose = async (on: boolean) => {
    const is_allowed = !on || (await Notification.requestPermission()) === "granted";
    if (!is_allowed) notices.show(text.mission.not_allowed, "trouble");
    box.checked = on && is_allowed;
    wanted.choose(box.checked ? "on" : "off");
  };
  const box = made.firstElementChild as HTMLInputElement;
  return made;
}
