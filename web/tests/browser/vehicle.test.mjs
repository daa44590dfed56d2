// The page in a real browser, connected to a simulated vehicle: `aisle live`.
import assert from "node:assert/strict";
import { mkdtempSync, writeFileSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, afterEach, before, beforeEach, test } from "node:test";

import {
  close_page,
  desktop,
  desktop_light,
  keep_screenshot,
  open_browser,
  open_page,
  phone,
  until,
} from "./browser.mjs";
import { make_certificate } from "./certificate.mjs";
import { Watcher, end_live, hold, start_live } from "./watcher.mjs";

/** The vehicle's maximum reaction time, by its own clock. */
const reaction_max_s = 0.3;

let browser, server, watcher, directory, page;

before(async () => {
  browser = await open_browser();
  directory = mkdtempSync(join(tmpdir(), "aisle-live-"));
  server = await start_live("l-corridor", directory);
  watcher = new Watcher(server.address, ["/cmd_vel", "/odom", "/decision", "/overlay/corridor", "/match"]);
});
after(async () => {
  await browser.close();
  watcher?.close();
  await end_live(server, directory);
});
beforeEach(async () => {
  page = await open_page(browser, server.address);
  await page.getByText(/l-corridor: /).waitFor();
});
afterEach(() => close_page(page));

async function drive_ahead() {
  await page.getByRole("button", { name: "Take the controls" }).click();
  await page.getByText("you hold the controls").waitFor();
  await page.keyboard.down("ArrowUp");
  await until(() => watcher.speed_mps() > 0.1, "the vehicle drives");
}

const mission = () => page.getByRole("combobox", { name: "Mission" });

test("Shows the camera, the plan and the state of a waiting vehicle", async () => {
  const camera = page.locator(".camera-panel canvas[data-stamp-s]");
  await camera.waitFor();
  const first_s = Number(await camera.getAttribute("data-stamp-s"));
  await until(async () => Number(await camera.getAttribute("data-stamp-s")) > first_s, "a newer image");
  await keep_screenshot(page, "drive-dark");
  for (const [name, options] of [
    ["drive-light", desktop_light],
    ["drive-phone", phone],
  ]) {
    const other = await open_page(browser, server.address, options);
    await other.locator(".camera-panel canvas[data-stamp-s]").waitFor();
    await keep_screenshot(other, name);
    await other.context().close();
  }
});

test("The emergency stop stops a vehicle that is driven by hand", async () => {
  await drive_ahead();
  const pressed_s = watcher.now_s;
  await page.keyboard.press("Escape");
  assert.ok((await watcher.stop_commanded_s(pressed_s)) <= pressed_s + reaction_max_s);
  await page.getByText("STOPPED", { exact: true }).waitFor();
  await page.keyboard.up("ArrowUp");
  await hold(page, "Release");
  await page.getByText("l-corridor: waiting").waitFor();
});

test("The vehicle stops when its page is closed", async () => {
  await drive_ahead();
  const closed_s = watcher.now_s;
  await page.close();
  assert.ok((await watcher.stop_commanded_s(closed_s)) <= closed_s + reaction_max_s);
  await until(() => watcher.state?.lease_held === false, "the controls are free again");
});

test("Of two pages one drives, and the other shows that somebody drives", async () => {
  await page.getByRole("button", { name: "Take the controls" }).click();
  await page.getByText("you hold the controls").waitFor();
  const other = await open_page(browser, server.address, desktop);
  await other.getByText("somebody else holds the controls").waitFor();
  await other.getByRole("button", { name: "Take the controls" }).click();
  await other.locator(".notice.trouble").waitFor();
  await other.context().close();
});

test("A maze is drawn, and its exploration is shown to be complete", async () => {
  await page.getByRole("link", { name: "Maze" }).click();
  await page.getByLabel("Width").fill("6");
  await page.getByLabel("Height").fill("5");
  await page.getByRole("button", { name: "Random" }).click();
  const maze = page.getByRole("application", { name: /Maze/ });
  await maze.focus();
  await page.keyboard.press("Shift+ArrowRight");
  await page.keyboard.press("Shift+ArrowRight");
  for (const rules of ["published", "homing"]) {
    await page.getByLabel("Rules").selectOption(rules);
    await page.getByRole("button", { name: "Explore" }).click();
    await page.getByText("Explored completely, back at the start: 30 of 30 cells").waitFor();
  }
  await page.getByRole("button", { name: "To the end" }).click();
  await page.getByText("q_fin").waitFor();
  await keep_screenshot(page, "maze-dark");
});

test("A route taught with the arrow keys is learned and driven", { timeout: 120000 }, async () => {
  await mission().selectOption("teach");
  await page.getByRole("button", { name: "Start teaching" }).click();
  await page.getByText("l-corridor: teach").waitFor();
  await page.keyboard.down("ArrowUp");
  await until(() => (watcher.latest("/odom")?.message.pose.pose.position.x ?? 0) > 2, "two metres", 60000);
  await page.keyboard.up("ArrowUp");
  await page.getByRole("textbox", { name: "Name or number of the mark" }).fill("printer");
  await page.getByRole("button", { name: "Place", exact: true }).click();
  await page.getByText("Marked: place").waitFor();
  await page.getByRole("button", { name: "Route ends" }).click();
  await page.getByText("Marked: stop").waitFor();
  await page.getByRole("button", { name: "Finish" }).click();
  await page.getByText("Last: teach done").waitFor();

  await mission().selectOption("learn");
  await page.getByRole("button", { name: "Learn", exact: true }).click();
  await page.getByText("Last: learn done").waitFor({ timeout: 60000 });

  await mission().selectOption("navigate");
  await page.getByRole("button", { name: "Drive the route" }).click();
  await page.getByText("l-corridor: navigate").waitFor();
  await page.getByText("Last: navigate done").waitFor({ timeout: 90000 });
  const drawn = watcher.received.filter(({ topic }) => topic === "/overlay/corridor");
  const kinds = new Set(
    drawn.flatMap(({ message }) => JSON.parse(message.data).lines.map(({ kind }) => kind)),
  );
  assert.deepEqual([...kinds].sort(), ["foot", "stripe", "vertical line"]);
  assert.ok(JSON.parse(watcher.latest("/match").message.data).quality > 0.5);
  await keep_screenshot(page, "driven-dark");
});

test("A session is listed and replayed, and its building is edited", async () => {
  await page.getByRole("link", { name: "Sessions" }).click();
  await page.getByRole("button", { name: "taught-1" }).click();
  await page.getByRole("link", { name: "taught-1_0.db3" }).waitFor();
  await page.getByRole("button", { name: "Replay", exact: true }).click();
  await page.getByText(/^[1-9]\.\d of \d/).waitFor();
  const picture = page.locator(".sessions-replay canvas[data-stamp-s]");
  const shown_s = async () => Number(await picture.getAttribute("data-stamp-s"));
  await until(async () => (await shown_s()) > 1, "a picture");
  await page.getByRole("button", { name: "Pause" }).click();
  await page.getByRole("button", { name: "Play", exact: true }).waitFor();
  await page.getByRole("slider", { name: "Time" }).press("Home");
  await until(async () => (await shown_s()) < 1, "the picture at the beginning");
  await page.getByText(/^0\.0 of \d/).waitFor();
  await keep_screenshot(page, "sessions-dark");
  await page.getByRole("button", { name: "End the replay" }).click();
  await page.getByText("l-corridor: waiting").waitFor();

  await page.getByRole("link", { name: "Building" }).click();
  await page.getByText(/landmarks, 1 route, 1 place/).waitFor();
  await page.getByText("printer").waitFor();
  await page.getByLabel("Tool").selectOption("place");
  await page.getByRole("img", { name: "Plan of the building", exact: true }).click();
  await page.getByLabel("Name of the place").fill("desk");
  await page.getByRole("button", { name: "Name it" }).click();
  await page.getByRole("button", { name: "Save as a new version" }).click();
  await page.getByText("Saved as building1-2").waitFor();
  await keep_screenshot(page, "building-dark");
});

test("The exploration of an unknown building is shown to its end", { timeout: 400000 }, async () => {
  const fast = await start_live("l-corridor", join(directory, "fast"), "--rate", "2");
  const everything = new Watcher(fast.address);
  const other = await open_page(browser, fast.address);
  await other.getByRole("combobox", { name: "Mission" }).selectOption("explore");
  await other.getByRole("button", { name: "Explore" }).click();
  await other.getByText("l-corridor: explore").waitFor();
  await until(() => everything.latest("/transducer") && everything.latest("/floor"), "the explorer's map");
  await other.getByText("Last: explore done").waitFor({ timeout: 300000 });
  await keep_screenshot(other, "explored-dark");
  await other.context().close();
  everything.close();
  assert.equal(await fast.stop(), 130);
});

test("Over https the page uses wss, and it asks for a missing token", async () => {
  const token = join(directory, "token");
  writeFileSync(token, "0123456789abcdef\n");
  const { certificate, key } = make_certificate(directory);
  const guarded = await start_live(
    "l-corridor",
    join(directory, "guarded"),
    ...["--token-file", token, "--cert", certificate, "--key", key],
  );
  const trusting = { ...desktop, ignoreHTTPSErrors: true };
  const outside = await open_page(browser, guarded.address, trusting);
  await outside.getByText("Not connected").waitFor();
  await outside.getByText("This vehicle asks for its token.").waitFor();
  await outside.getByLabel("Token of this vehicle").fill("fedcba9876543210");
  await outside.getByRole("button", { name: "Enter" }).click();
  await outside.getByText("This token is wrong.").waitFor();
  await outside.getByLabel("Token of this vehicle").fill("0123456789abcdef");
  await outside.getByRole("button", { name: "Enter" }).click();
  await outside.locator(".camera-panel canvas[data-stamp-s]").waitFor();
  await outside.getByRole("link", { name: "Building" }).click();
  await outside.getByText("No building yet").waitFor();
  const opened = await open_page(browser, `${guarded.address}?token=0123456789abcdef`, trusting);
  await opened.locator(".camera-panel canvas[data-stamp-s]").waitFor();
  assert.equal(new URL(opened.url()).search, "");
  await opened.context().close();
  await outside.context().close();
  assert.equal(await guarded.stop(), 130);
});
