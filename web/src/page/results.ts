import type { LiveState } from "../connection/live_state";
import { text } from "../text";
import type { App } from "./app";
import { tell_elsewhere } from "./elsewhere";
import { sentence } from "./notices";

type Last = NonNullable<LiveState["last"]>;

/** How a mission ended, in sentences; of a failure also what to do. */
export function result_text({ mission, ok, text: words, problems }: Last): string {
  const head = ok ? text.result.done(mission) : text.result.not_done(mission);
  const advice = ok ? undefined : text.result.what_to_do[mission];
  return [head, ...[words, ...problems].map(sentence), advice].filter(Boolean).join(" ");
}

/** Shows how each mission ended until that is dismissed; a page that joins later does not repeat the last one. */
export function announce_results(app: App): void {
  let known: string | undefined;
  app.state.watch((state) => {
    if (!state) return;
    const last = JSON.stringify(state.last);
    const is_news = known === undefined ? state.mode === "ended" : last !== known;
    known = last ?? "";
    if (!is_news || !state.last) return;
    const message = result_text(state.last);
    app.notices.show(message, state.last.ok ? "result" : "trouble");
    tell_elsewhere(message, state.last.ok);
  });
}
