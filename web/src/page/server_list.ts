import type { App } from "./app";

/** A list that cannot be had now is asked for again at the next change. */
const ignore = (): void => undefined;

/** Asks for a list of what the server keeps whenever that may have changed, and when its tab is entered. */
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
