// Prints every message of a rosbag2 database as one line of JSON: topic, type, stamp, message.
// Bytes are in base64, and what JSON has no number for is null.
//   node dump.mjs DATABASE.db3
import { readFile } from "node:fs/promises";
import { createRequire } from "node:module";

globalThis.File ??= class File {}; // Node 18 has none, and the reader asks whether it was given one

const require = createRequire(import.meta.url);
const { Rosbag2, SqliteSqljs } = require("@foxglove/rosbag2-web");

function plain(value) {
  if (value instanceof Uint8Array) return { base64: Buffer.from(value).toString("base64") };
  if (ArrayBuffer.isView(value)) return Array.from(value, plain);
  if (Array.isArray(value)) return value.map(plain);
  if (Object.is(value, -0)) return { negative_zero: true };
  if (value === null || typeof value !== "object") return value;
  return Object.fromEntries(Object.entries(value).map(([key, inner]) => [key, plain(inner)]));
}

await SqliteSqljs.Initialize({ wasmBinary: await readFile(require.resolve("@foxglove/sql.js/dist/sql-wasm.wasm")) });
const bag = new Rosbag2([new SqliteSqljs(new Uint8Array(await readFile(process.argv[2])))]);
await bag.open();
for await (const { topic, timestamp, value } of bag.readMessages()) {
  const line = { topic: topic.name, type: topic.type, stamp: timestamp, message: plain(value) };
  process.stdout.write(JSON.stringify(line) + "\n");
}
await bag.close();
