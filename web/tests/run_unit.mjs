// Bundles the unit tests and runs them: Node does not run TypeScript.
import { spawnSync } from "node:child_process";
import { mkdtempSync, readdirSync, rmSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { build } from "esbuild";

const here = import.meta.dirname ?? new URL(".", import.meta.url).pathname;
const sources = readdirSync(join(here, "unit"))
  .filter((name) => name.endsWith(".test.ts"))
  .map((name) => join(here, "unit", name));
if (sources.length === 0) throw new Error("there are no unit tests");

const directory = mkdtempSync(join(tmpdir(), "aisle-page-"));
await build({
  entryPoints: sources,
  outdir: directory,
  bundle: true,
  platform: "node",
  format: "esm",
  outExtension: { ".js": ".mjs" },
});
const tests = sources.map((name) =>
  join(directory, name.slice(name.lastIndexOf("/") + 1).replace(/\.ts$/, ".mjs")),
);
const { status } = spawnSync(process.execPath, ["--test", ...tests], { stdio: "inherit" });
rmSync(directory, { recursive: true });
process.exit(status ?? 1);
