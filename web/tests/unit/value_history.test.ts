import assert from "node:assert/strict";
import { test } from "node:test";

import { ValueHistory, range_of } from "../../src/drive/value_history";

function listening() {
  const heard = new Map<string, (message: unknown, stamp_ns: bigint) => void>();
  const connection = { listen: (topic: string, take: () => void) => heard.set(topic, take) };
  const history = new ValueHistory(connection as never, () => undefined);
  const quality = (value: number, stamp_s: number) =>
    heard.get("/match")?.({ data: JSON.stringify({ quality: value }) }, BigInt(stamp_s) * 1_000_000_000n);
  return { heard, history, quality };
}

test("Values of the last two minutes are kept", () => {
  const { history, quality } = listening();
  for (const stamp_s of [0, 60, 125]) quality(0.5, stamp_s);
  assert.deepEqual(history.of("match"), [
    { stamp_s: 60, value: 50 },
    { stamp_s: 125, value: 50 },
  ]);
  assert.deepEqual(history.of("speed"), []);
});

test("A clock that goes back, and a new session, begin again", () => {
  const { heard, history, quality } = listening();
  for (const stamp_s of [50, 60, 10]) quality(0.5, stamp_s);
  assert.deepEqual(history.of("match"), [{ stamp_s: 10, value: 50 }]);
  heard.get("/session")?.({}, 0n);
  assert.deepEqual(history.of("match"), []);
});

test("The range of values is never empty", () => {
  const samples = (...values: number[]) => values.map((value) => ({ stamp_s: 0, value }));
  assert.deepEqual(range_of(samples(3, 1, 2)), { low: 1, high: 3 });
  assert.deepEqual(range_of(samples(2, 2)), { low: 1, high: 3 });
});
