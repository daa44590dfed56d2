import assert from "node:assert/strict";
import { test } from "node:test";

import type { LiveState } from "../../src/connection/live_state";
import { Signal } from "../../src/page/signal";
import { MissionEvents } from "../../src/timeline/mission_events";

// The browser's function that the colours use.
Object.assign(globalThis, { matchMedia: () => ({ matches: true }) });
const { event_text, nearest_event } = await import("../../src/timeline/timeline");

/** A server with events of which it keeps those from `kept_from` on. */
function followed() {
  const server = { texts: [] as string[], kept_from: 0, asked: [] as number[] };
  const state = new Signal<LiveState | undefined>(undefined);
  const call = ({ from }: { from: number }) => {
    server.asked.push(from);
    const first = Math.max(server.kept_from, Math.min(from, server.texts.length));
    const events = server.texts.slice(first).map((text) => ({ stamp_s: 0, kind: "state", text }));
    return Promise.resolve({ from: first, events });
  };
  const connection = {
    services: new Signal<ReadonlySet<string>>(new Set(["mission/events"])),
    call: (_: string, request: { from: number }) => call(request),
  };
  const events = new MissionEvents(connection as never, state);
  const tell = async (...texts: string[]) => {
    server.texts = texts;
    state.value = { events: texts.length } as LiveState;
    await new Promise(setImmediate);
  };
  const known = () => events.list.value.map(({ text }) => text);
  return { server, tell, known };
}

test("Only what is new is asked for, and nothing when nothing is", async () => {
  const { server, tell, known } = followed();
  await tell("a", "b");
  await tell("a", "b");
  await tell("a", "b", "c");
  assert.deepEqual(known(), ["a", "b", "c"]);
  assert.deepEqual(server.asked, [0, 2]);
});

test("Another mission, or a replay that jumped back, begins again", async () => {
  const { tell, known } = followed();
  await tell("a", "b");
  await tell();
  assert.deepEqual(known(), []);
  await tell("x");
  assert.deepEqual(known(), ["x"]);
});

test("What the server no longer keeps is left out", async () => {
  const { server, tell, known } = followed();
  server.kept_from = 2;
  await tell("a", "b", "c");
  assert.deepEqual(known(), ["c"]);
  await tell("a", "b", "c", "d");
  assert.deepEqual(known(), ["c", "d"]);
});

test("An event is told with its time, and found by it", () => {
  const event = (stamp_s: number) => ({ stamp_s, kind: "pause", text: "" });
  assert.equal(event_text({ ...event(187), text: "by anna" }), "3:07 · paused · by anna");
  assert.equal(event_text({ stamp_s: 1, kind: "state", text: "lost" }), "0:01 · lost");
  assert.equal(event_text({ stamp_s: 1, kind: "new kind", text: "" }), "0:01 · new kind");
  assert.equal(
    event_text({ stamp_s: 9, kind: "goal_next", text: "desk (2/3)" }),
    "0:09 · next goal · desk (2/3)",
  );
  assert.equal(nearest_event([1, 5, 9].map(event), 6.5), 1);
  assert.equal(nearest_event([], 6.5), -1);
});
