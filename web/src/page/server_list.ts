import type { App } from "./app";

/** A request that fails is repeated at the next change. */
const ignore = (): void => undefined;

/** Refreshes a list from the server whenever it may have changed, and when its tab is opened. */
export function keep_fresh(app: App, tab: string, refresh: () => Promise<void>): void {
  const ask = () => void refresh().catch(ignore);
  let mode: string | undefined;
  app.state.watch((state) => {
    if (state && state.mode !== mode) ask();
    mode = state?.mode;
  });
  app.connection.services.watch(ask);
  app.tab.watch((entered) => {
    if (entered === tab) ask();
  });
}
