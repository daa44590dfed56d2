import type { App } from "./app";

/** A request that fails is repeated at the next change. */
const ignore = (): void => undefined;

/**
 * Refreshes a list from the server whenever it may have changed, and when its tab is opened. One request is on its way at
 * a time; what may have changed meanwhile is asked for once after it.
 */
export function keep_fresh(app: App, tab: string, refresh: () => Promise<void>): void {
  let is_asking = false;
  let shall_ask_again = false;
  const ask = async () => {
    shall_ask_again = is_asking;
    if (is_asking) return;
    is_asking = true;
    do {
      shall_ask_again = false;
      await refresh().catch(ignore);
    } while (shall_ask_again);
    is_asking = false;
  };
  let mode: string | undefined;
  app.state.watch((state) => {
    if (state && state.mode !== mode) void ask();
    mode = state?.mode;
  });
  app.connection.services.watch(() => void ask());
  app.tab.watch((entered) => {
    if (entered === tab) void ask();
  });
}
