// What the program's server and the page do together for an operator: `aisle live` and `--live`.
import assert from "node:assert/strict";
import { cpSync, mkdirSync, mkdtempSync, readdirSync, renameSync, writeFileSync } from "node:fs";
import { get } from "node:http";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, afterEach, before, beforeEach, test } from "node:test";
import { WebSocket } from "ws";

import { close_page, keep_screenshot, open_browser, open_page, until } from "./browser.mjs";
import { Watcher, end_live, hold, start_live, start_watched } from "./watcher.mjs";

const viewer = "https://viewer.example";
let browser, server, directory, page;

before(async () => {
  browser = await open_browser();
  directory = mkdtempSync(join(tmpdir(), "aisle-operator-"));
  server = await start_live("l-corridor", directory, "--rate", "4", "--allow-origin", viewer);
});
after(async () => {
  await browser.close();
  await end_live(server, directory);
});
beforeEach(async () => {
  page = await open_page(browser, server.address);
  await page.getByText("l-corridor: waiting").waitFor();
});
afterEach(() => close_page(page));

/** Status, headers and number of bytes of an answer as it was sent. */
function fetched(path, headers = {}) {
  return new Promise((resolve, reject) => {
    get(new URL(path, server.address), { headers }, async (answer) => {
      const bytes = Buffer.concat(await answer.toArray()).length;
      resolve({ status: answer.statusCode, headers: answer.headers, bytes });
    }).on("error", reject);
  });
}

async function explore(name) {
  await page.getByRole("textbox", { name: "Learn as" }).fill(name);
  await page.getByRole("button", { name: "Explore" }).click();
  await page.getByText(/l-corridor: explore.* · [1-9]\d*\.\d m/).waitFor({ timeout: 60000 });
}

test("A stopped exploration stands still, goes on, and is driven on by hand with its map kept", async () => {
  const watcher = new Watcher(server.address, ["/cmd_vel", "/odom"]);
  await explore("half");
  await page.keyboard.press("Escape");
  await page.getByText("explore, held").waitFor();
  await until(() => watcher.latest("/cmd_vel")?.message.linear.x === 0, "the command to stand");
  const stood_s = watcher.latest("/odom").stamp_s;
  await keep_screenshot(page, "held-dark");
  await hold(page, "Resume");
  await until(() => watcher.latest("/odom").stamp_s > stood_s, "it goes on");

  await page.getByRole("button", { name: "Emergency stop" }).click();
  await page.getByText("explore, held").waitFor();
  await hold(page, "Drive from here");
  await page
    .getByText("Last: explore not done. simulated: ended by the operator")
    .waitFor({ timeout: 60000 });
  await page.getByText(/l-corridor: waiting; you hold the controls/).waitFor();
  const { map_origin } = watcher.state;
  assert.ok(Math.hypot(map_origin.x_m, map_origin.y_m) > 0.3, JSON.stringify(map_origin));
  const late = await open_page(browser, server.address);
  await late.getByText("l-corridor: waiting").waitFor();
  const short = (value) => value.toFixed(1).replace("-0.0", "0.0");
  const at = new RegExp(`${short(map_origin.x_m)}, ${short(map_origin.y_m)} m`);
  await late.getByText(at).waitFor();
  await late.context().close();

  await page.keyboard.down("ArrowUp");
  await until(() => watcher.latest("/cmd_vel")?.message.linear.x > 0.1, "it is driven by hand");
  await page.keyboard.up("ArrowUp");
  await page.getByRole("link", { name: "Building" }).click();
  await page.getByText(/1 place, floor/).waitFor();
  watcher.close();
});

test("An exploration that is ended at once, and one that is thrown away, leave the server in order", async () => {
  await explore("short");
  await page.getByRole("button", { name: "End", exact: true }).click();
  await page.getByText("Last: explore not done.").waitFor({ timeout: 60000 });
  await page.getByText("l-corridor: waiting").waitFor();
  assert.deepEqual(
    readdirSync(join(directory, "buildings")).filter((name) => name.startsWith(".")),
    [],
  );
});

test("The page is sent compressed, and a second time only if it has changed", async () => {
  const gzip = { "accept-encoding": "gzip, br" };
  const first = await fetched("/", gzip);
  assert.equal(first.headers["content-encoding"], "gzip");
  const again = await fetched("/", { ...gzip, "if-none-match": first.headers.etag });
  assert.deepEqual([again.status, again.bytes], [304, 0]);
  const scripts = await page.evaluate(() =>
    performance.getEntriesByType("resource").map(({ name }) => new URL(name).pathname),
  );
  const script = scripts.find((path) => path.endsWith(".js"));
  const [plain, compressed] = [await fetched(script), await fetched(script, gzip)];
  assert.ok(compressed.bytes < plain.bytes / 2, `${compressed.bytes} of ${plain.bytes} bytes`);
  assert.match(compressed.headers["cache-control"], /immutable/);
});

test("Pages of other sites are refused, but for those that are allowed", async () => {
  const opened = (origin) =>
    new Promise((resolve) => {
      const socket = new WebSocket(server.address.replace("http", "ws"), ["foxglove.sdk.v1"], { origin });
      socket.on("open", () => {
        socket.close();
        resolve(true);
      });
      socket.on("error", () => resolve(false));
    });
  assert.equal(await opened(viewer), true);
  assert.equal(await opened("https://evil.example"), false);
  assert.equal(
    (await fetched("/sessions/", { origin: viewer })).headers["access-control-allow-origin"],
    viewer,
  );
  assert.equal((await fetched("/sessions/", { origin: "https://evil.example" })).status, 403);
});

test("Sessions beside foreign files are listed, with the file of each kind", async () => {
  const sessions = join(directory, "sessions");
  await page.getByRole("combobox", { name: "Mission" }).selectOption("drive");
  await page.getByRole("textbox", { name: "Record as" }).fill("run-2");
  await page.getByRole("button", { name: "Begin" }).click();
  await page.getByText("l-corridor: drive").waitFor();
  await page.getByRole("button", { name: "End", exact: true }).click();
  await page.getByText("l-corridor: waiting").waitFor();

  cpSync(join(sessions, "run-2"), join(sessions, "copy"), { recursive: true });
  mkdirSync(join(sessions, "empty"));
  mkdirSync(join(sessions, "damaged"));
  writeFileSync(join(sessions, "damaged", "metadata.yaml"), "[");
  writeFileSync(join(sessions, "notes.txt"), "foreign");
  writeFileSync(join(sessions, ".aisle-sessions.json"), "{ damaged");
  await page.getByRole("link", { name: "Sessions" }).click();
  for (const name of ["run-2", "copy"]) {
    await page.getByRole("button", { name, exact: true }).click();
    await page.getByRole("link", { name: "run-2_0.db3" }).waitFor();
  }
  assert.equal(await page.locator(".sessions-list tbody tr").count(), 2);
  renameSync(join(sessions, "copy"), join(sessions, "moved"));
  await page.getByRole("link", { name: "Drive" }).click();
  await page.getByRole("link", { name: "Sessions" }).click();
  await page.getByRole("button", { name: "moved", exact: true }).waitFor();
});

test("A watched verb says how it ended before its program is gone", { timeout: 300000 }, async () => {
  // Slow enough for a page to come before it is over.
  const watched = await start_watched(["explore", "l-corridor", "--rate", "20"]);
  const other = await open_page(browser, watched.address);
  await other.getByText("Last: explore done.").waitFor({ timeout: 240000 });
  await other.getByText("explore has ended and its program is gone").waitFor();
  assert.equal(await watched.ended(), 0);
  await other.context().close();
});
