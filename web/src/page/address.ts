import type { App, Tab } from "./app";

/** What the page's address names behind the '#': a tab, and what is chosen in it, as in #sessions/run-2. */
export interface NamedInAddress {
  tab: string;
  chosen: string;
}

function decoded(part: string): string {
  try {
    return decodeURIComponent(part);
  } catch {
    return "";
  }
}

export function named_in(hash: string): NamedInAddress {
  const [tab = "", ...chosen] = hash.slice(1).split("/");
  return { tab, chosen: decoded(chosen.join("/")) };
}

export function hash_of({ tab, chosen }: NamedInAddress): string {
  return chosen === "" ? `#${tab}` : `#${tab}/${encodeURIComponent(chosen)}`;
}

/** Shows what the address names, now and whenever it changes, and keeps it true to what is shown. */
export function follow_address(app: App, tabs: readonly Tab[]): void {
  const shown = () => tabs.find(({ name }) => name === app.tab.value);
  const write = () => {
    const hash = hash_of({ tab: app.tab.value, chosen: shown()?.choice?.name.value ?? "" });
    if (location.hash !== hash) history.replaceState(null, "", hash);
  };
  const enter = (hash: string) => {
    const { tab, chosen } = named_in(hash);
    app.tab.value = tabs.some(({ name }) => name === tab) ? tab : "drive";
    if (chosen !== "") shown()?.choice?.choose(chosen);
    write();
  };
  enter(location.hash);
  // Not location.hash: a choice may have rewritten that before this event came.
  addEventListener("hashchange", ({ newURL }) => enter(new URL(newURL).hash));
  for (const { choice } of tabs) choice?.name.watch(write);
}
