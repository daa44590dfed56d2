// A simulated vehicle is sent about on the plan: `aisle live` in a building that was explored.
import assert from "node:assert/strict";
import { execFileSync } from "node:child_process";
import { copyFileSync, mkdirSync, mkdtempSync } from "node:fs";
import { tmpdir } from "node:os";
import { join } from "node:path";
import { after, afterEach, before, beforeEach, test } from "node:test";

import { close_page, keep_screenshot, open_browser, open_page, until } from "./browser.mjs";
import { Watcher, end_live, hold, start_live } from "./watcher.mjs";

/** A mission of half a minute, at twice the speed of time, on a slow machine. */
const driven_ms = 180000;

let browser, server, watcher, directory, page;

before(async () => {
  browser = await open_browser();
  directory = mkdtempSync(join(tmpdir(), "aisle-going-"));
  const vehicle = ["--vehicle", "turtlebot"];
  const explored = join(directory, "explored");
  execFileSync(process.env.AISLE, ["explore", "l-corridor", ...vehicle, "--out", explored]);
  mkdirSync(join(directory, "buildings"));
  copyFileSync(join(explored, "building.json"), join(directory, "buildings", "floor.json"));
  server = await start_live("l-corridor", directory, ...vehicle, "--rate", "2");
  watcher = new Watcher(server.address, ["/pose", "/cmd_vel", "/vehicle_description"]);
});
after(async () => {
  await browser.close();
  watcher?.close();
  await end_live(server, directory);
});
beforeEach(async () => {
  page = await open_page(browser, `${server.address}#drive/go`);
  await page.locator('.mission-panel option[value="home"]').waitFor({ state: "attached" });
  await page.getByText(/l-corridor: waiting/).waitFor();
});
afterEach(() => close_page(page));

/** Where on the screen a point of the map is, by what the plan says under the mouse at two places. */
async function screen_of(x_m, y_m) {
  const box = await page.locator(".drive-tab .stage .plan canvas").boundingBox();
  const readout = page.locator(".drive-tab .plan-readout span").last();
  const read = async (x, y) => {
    await page.mouse.move(x, y);
    await readout.waitFor();
    const [, right, up] = /^(-?[\d.]+), (-?[\d.]+) m$/.exec(await readout.textContent());
    return { x, y, x_m: Number(right), y_m: Number(up) };
  };
  const a = await read(box.x + box.width * 0.4, box.y + box.height * 0.3);
  const b = await read(box.x + box.width * 0.9, box.y + box.height * 0.8);
  return {
    x: a.x + ((x_m - a.x_m) * (b.x - a.x)) / (b.x_m - a.x_m),
    y: a.y + ((y_m - a.y_m) * (b.y - a.y)) / (b.y_m - a.y_m),
  };
}

function pose() {
  const { position, orientation } = watcher.latest("/pose").message.pose.pose;
  return { x: position.x, y: position.y, heading_rad: 2 * Math.atan2(orientation.z, orientation.w) };
}

test("A drag on the plan sends it there, and it turns to where the drag ended", async () => {
  const [from, to] = [await screen_of(2.5, 0), await screen_of(2.5, 3)];
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(to.x, to.y, { steps: 5 });
  await page.mouse.up();
  await page.getByText("Last: go done.").waitFor({ timeout: driven_ms });
  const { x, y, heading_rad } = pose();
  assert.ok(Math.hypot(x - 2.5, y) < 0.8, `${x}, ${y}`);
  assert.ok(Math.abs(heading_rad - Math.PI / 2) < 0.2, `${heading_rad} rad`);
  const vehicles = watcher.received.filter(({ topic }) => topic === "/vehicle_description");
  assert.ok(vehicles.length > 1, "the waiting vehicle, and the mission's");
  for (const { message } of vehicles)
    assert.match(message.data, /^name: "TurtleBot/m, "the one that the server was started with");
});

/** What the timeline says, event by event, without the times. */
async function told_events() {
  const timeline = page.locator(".drive-tab").getByRole("slider", { name: "Events of the mission" });
  await timeline.focus();
  await page.keyboard.press("Home");
  const told = [];
  for (let at = 0; at <= Number(await timeline.getAttribute("aria-valuemax")); at += 1) {
    told.push((await timeline.getAttribute("aria-valuetext")).replace(/^[\d:]+ · /, ""));
    await page.keyboard.press("ArrowRight");
  }
  return told;
}

test("A queue under way is extended, and what is not reached is taken out", async () => {
  await page.keyboard.down("Shift");
  for (const x of [1.5, 3]) {
    const at = await screen_of(x, 0);
    await page.mouse.click(at.x, at.y);
  }
  await page.keyboard.up("Shift");
  watcher.received = [];
  await page.getByRole("button", { name: "Drive in order" }).click();
  await until(() => watcher.state?.goals?.length === 2, "the mission has two goals");
  await page.keyboard.press("Escape"); // so that it reaches none before it is told
  await page.getByText("go, held").waitFor();
  await page.getByRole("button", { name: "Fit" }).first().click();
  const at = await screen_of(2, 0);
  await page.mouse.click(at.x, at.y);
  await page.getByRole("button", { name: "Add", exact: true }).click();
  await page.getByRole("button", { name: "Remove goal 3" }).waitFor();
  await page
    .locator(".drive-tab")
    .getByText(/goal added/)
    .waitFor();
  await page.getByRole("button", { name: "Remove goal 2" }).click();
  await until(() => watcher.state.goals?.length === 2, "one is taken out");
  await page
    .locator(".drive-tab")
    .getByText(/goal removed/)
    .waitFor();
  await keep_screenshot(page, "going-extended-dark");
  await hold(page, "Resume");
  await page.getByText("Last: go done.").waitFor({ timeout: driven_ms });
  assert.ok(Math.abs(pose().x - 2) < 0.8, `${pose().x}`);
  assert.equal(watcher.state.last.figures.places_reached, 2);
  await page.locator(".drive-tab").getByText("ended · done").waitFor();
  const of_goals = (await told_events()).filter((words) => /^(next goal|goal \w+) · /.test(words));
  const expected = [
    /^next goal · 1\.\d\d, -?0\.\d\d m \(1\/2\)$/,
    /^goal added · (1\.9|2\.0)\d, -?0\.\d\d m$/,
    /^goal removed · (2\.9|3\.0)\d, -?0\.\d\d m$/,
    /^goal reached · 1\.\d\d, -?0\.\d\d m \(1\/2\)$/,
    /^next goal · (1\.9|2\.0)\d, -?0\.\d\d m \(2\/2\)$/,
    /^goal reached · (1\.9|2\.0)\d, -?0\.\d\d m \(2\/2\)$/,
  ];
  assert.equal(of_goals.length, expected.length, of_goals.join("\n"));
  expected.forEach((wanted, index) => assert.match(of_goals[index], wanted));
});

test("A queue is driven in order, is stopped, and goes on", async () => {
  await page.keyboard.down("Shift");
  for (const x of [2, 0.5]) {
    const at = await screen_of(x, 0);
    await page.mouse.click(at.x, at.y);
  }
  await page.keyboard.up("Shift");
  watcher.received = [];
  await page.getByRole("button", { name: "Drive in order" }).click();
  await until(() => watcher.state?.goals?.length === 2, "the mission has two goals");
  await until(() => watcher.latest("/pose") && pose().x > 0.3, "it drives");
  await page.keyboard.press("Escape");
  await page.getByText("go, held").waitFor();
  await until(() => watcher.speed_mps() === 0, "the command to stand");
  await keep_screenshot(page, "going-held-dark");
  await hold(page, "Resume");
  await page.getByText("Last: go done.").waitFor({ timeout: driven_ms });
  assert.ok(Math.abs(pose().x - 0.5) < 0.8, `${pose().x}`);
  await until(() => watcher.state.goals === undefined, "no goals are left");
});
