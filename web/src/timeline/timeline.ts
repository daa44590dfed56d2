import type { App } from "../page/app";
import { element, set_text } from "../page/element";
import { Sheet } from "../page/sheet";
import { short_duration } from "../page/status";
import { colour } from "../page/theme";
import { text } from "../text";
import type { MissionEvent } from "./mission_events";

const margin_px = 8;

/** What happened, in words. */
export function event_text({ stamp_s, kind, text: words }: MissionEvent): string {
  const what = text.timeline.kinds[kind] ?? kind;
  return [short_duration(stamp_s), what, words].filter(Boolean).join(" · ");
}

/** The index of the event whose time is nearest; -1: there is none. */
export function nearest_event(events: readonly MissionEvent[], at_s: number): number {
  const off_s = events.map(({ stamp_s }) => Math.abs(stamp_s - at_s));
  return off_s.indexOf(Math.min(...off_s));
}

function colour_of(kind: string): string {
  if (kind === "contact" || kind === "emergency_stop") return colour("trouble");
  if (kind === "state") return colour("accent");
  return ["mark", "goal_reached", "end"].includes(kind) ? colour("good") : colour("busy");
}

/**
 * The mission from its beginning until now, or a replayed session, with what happened in it. The newest event is in words
 * until one is chosen, by a click or by the arrow keys; where that was is shown on the plan, and a replay jumps there.
 */
export function timeline(app: App): HTMLElement {
  const canvas = element("canvas", {
    role: "slider",
    tabindex: 0,
    "aria-label": text.timeline.name,
    "aria-valuemin": 0,
    title: text.timeline.keys,
  });
  const words = element("span", {});
  const made = element("div", { class: "timeline", hidden: true }, canvas, words);
  /** undefined: the newest. */
  let chosen: MissionEvent | undefined;

  const events = () => app.events.list.value;
  const replay = () => (app.state.value?.mode === "replay" ? app.state.value.replay : undefined);
  const now_s = () => replay()?.at_s ?? events().at(-1)?.stamp_s ?? 0;
  const end_s = () => Math.max(1, replay()?.to_s ?? Math.max(now_s(), running_s()));
  const running_s = () => (app.state.value?.mode === "mission" ? app.state.value.stamp_s : 0);
  const x_of = (at_s: number) => margin_px + ((sheet.width_px - 2 * margin_px) * at_s) / end_s();

  const sheet = new Sheet(canvas, (context) => {
    const middle = sheet.height_px / 2;
    context.fillStyle = colour("edge");
    context.fillRect(margin_px, middle - 1, sheet.width_px - 2 * margin_px, 2);
    if (replay()) {
      context.fillStyle = colour("muted");
      context.fillRect(margin_px, middle - 1, x_of(now_s()) - margin_px, 2);
    }
    for (const event of events()) {
      const half = event === shown() ? middle - 1 : middle / 2;
      context.fillStyle = colour_of(event.kind);
      context.fillRect(x_of(event.stamp_s) - 1.5, middle - half, 3, 2 * half);
    }
  });
  const shown = () => chosen ?? events().at(-1);
  const show = () => {
    const event = shown();
    made.hidden = !event;
    if (!event) return;
    canvas.setAttribute("aria-valuemax", String(events().length - 1));
    canvas.setAttribute("aria-valuenow", String(events().indexOf(event)));
    canvas.setAttribute("aria-valuetext", event_text(event));
    set_text(words, event_text(event));
    words.title = event_text(event);
    sheet.redraw();
  };
  const choose = (index: number) => {
    const last = events().length - 1;
    const event = events()[Math.min(last, Math.max(0, index))];
    if (!event) return;
    chosen = index >= last ? undefined : event;
    app.plan.point_to(event.at_m);
    if (replay()) void app.notices.attempt(app.lease.call("replay/seek", { to_s: event.stamp_s }));
    show();
  };

  canvas.addEventListener("click", ({ offsetX }) => {
    const share = (offsetX - margin_px) / Math.max(1, sheet.width_px - 2 * margin_px);
    choose(nearest_event(events(), share * end_s()));
  });
  canvas.addEventListener("keydown", (event) => {
    const at = events().indexOf(shown() as MissionEvent);
    const steps: Record<string, number> = {
      ArrowLeft: at - 1,
      ArrowRight: at + 1,
      Home: 0,
      End: events().length - 1,
    };
    const to = steps[event.key];
    if (to === undefined) return;
    event.preventDefault();
    choose(to);
  });
  app.events.list.watch((list) => {
    if (chosen && !list.includes(chosen)) {
      chosen = undefined;
      app.plan.point_to(undefined);
    }
    show();
  });
  app.state.watch(() => {
    if (!made.hidden) sheet.redraw();
  });
  return made;
}
