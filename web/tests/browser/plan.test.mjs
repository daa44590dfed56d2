// What a plan offers beside its drawing: to measure, a grid, a legend, units, a picture. With a fake server.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { beforeEach, test } from "node:test";

import { desktop_light, keep_screenshot, open_page, phone, until } from "./browser.mjs";
import { give_building, open_touch, with_fake_page } from "./fake_page.mjs";

const given = with_fake_page();
let vehicle, page;
beforeEach(() => {
  ({ vehicle, page } = given);
  give_building(vehicle, ["attic"]);
});

const plan_of = (shown) => shown.getByRole("img", { name: "Plan of the building", exact: true });
const more_of = (shown) => shown.locator(".building-tab").getByRole("button", { name: "More" });

/** Opens the building, which is fitted in as 10 m by 7.5 m about (5, -0.25). @returns its tab, and where a point is */
async function open_building(shown) {
  await shown.evaluate(() => (location.hash = "building/attic"));
  await shown.getByText("2 walls, 1 place, floor").waitFor();
  const box = await plan_of(shown).boundingBox();
  const px_per_m = Math.min(200, (box.width - 64) / 10, (box.height - 64) / 7.5);
  const at = (x, y) => ({
    x: box.x + box.width / 2 + (x - 5) * px_per_m,
    y: box.y + box.height / 2 - (y + 0.25) * px_per_m,
  });
  return { at, tab: shown.locator(".building-tab") };
}

const click = (shown, { x, y }) => shown.mouse.click(x, y);

/** Lengths on the screen are whole pixels. */
function assert_near(text, expected, within) {
  const numbers = text.match(/-?\d+(\.\d+)?/g).map(Number);
  assert.equal(numbers.length, expected.length, text);
  numbers.forEach((number, index) => assert.ok(Math.abs(number - expected[index]) <= within, text));
}

test("Points are measured in the map's axes, in metres and in feet", async () => {
  const { at, tab } = await open_building(page);
  await more_of(page).click();
  await tab.getByRole("button", { name: "Measure" }).click();
  const measured = tab.getByRole("status").filter({ hasText: /°|Click points/ });
  await click(page, at(1, -2));
  await click(page, at(7, -2));
  assert_near(await measured.textContent(), [6, 0], 0.03);
  await click(page, at(7, 1));
  assert_near(await measured.textContent(), [3, 90, 9], 0.6);
  await page.getByText(/^\d\.\d\d, \d\.\d\d m$/).waitFor();
  assert_near(await tab.locator(".plan-readout span").last().textContent(), [7, 1], 0.03);
  await tab.getByRole("button", { name: "Lengths in feet" }).click();
  assert_near(await measured.textContent(), [9.84, 90, 29.53], 0.6);
  await page.getByText("2 walls, 1 place, floor").waitFor();
  await page.reload();
  await page.getByText("2 walls, 1 place, floor").waitFor();
  await plan_of(page).hover();
  assert.match(await tab.locator(".plan-readout span").last().textContent(), / ft$/);
});

test("The keys measure in the middle of the plan", async () => {
  const { tab } = await open_building(page);
  await more_of(page).press("Enter");
  await tab.getByRole("button", { name: "Measure" }).press("Enter");
  await plan_of(page).focus();
  await page.keyboard.press("Enter");
  for (let times = 0; times < 2; times += 1) await page.keyboard.press("ArrowRight");
  await page.keyboard.press("Enter");
  await tab.getByText(/^[1-9]\d*\.\d\d m, 0°$/).waitFor();
  await page.keyboard.press("Backspace");
  await tab.getByText("Click points to measure.").waitFor();
});

test("A finger's taps measure; two fingers still move the plan", async () => {
  const touch = await open_touch(given, 768, 1024);
  const { at, tab } = await open_building(touch);
  await more_of(touch).tap();
  await tab.getByRole("button", { name: "Measure" }).tap();
  for (const point of [at(2, -2), at(2, 3)]) await touch.touchscreen.tap(point.x, point.y);
  assert_near(await tab.getByText(/ m, 90°$/).textContent(), [5, 90], 0.03);
  await touch.context().close();
});

test("The plan is saved as a picture of what is seen, with grid and legend", async () => {
  const { at, tab } = await open_building(page);
  await more_of(page).click();
  for (const name of ["Grid", "Legend"]) await tab.getByRole("button", { name }).click();
  const [download] = await Promise.all([
    page.waitForEvent("download"),
    tab.getByRole("button", { name: "Picture" }).click(),
  ]);
  assert.equal(download.suggestedFilename(), "aisle-attic.png");
  const bytes = readFileSync(await download.path()).toString("base64");
  const box = await plan_of(page).boundingBox();
  const place = (x, y) => ({ x: Math.round(at(x, y).x - box.x), y: Math.round(at(x, y).y - box.y) });
  const colours = await page.evaluate(
    async ([png, points]) => {
      const image = new Image();
      image.src = `data:image/png;base64,${png}`;
      await image.decode();
      const canvas = new OffscreenCanvas(image.width, image.height);
      const context = canvas.getContext("2d");
      context.drawImage(image, 0, 0);
      return points.map(({ x, y }) => [...context.getImageData(x, y, 1, 1).data.slice(0, 3)]);
    },
    [bytes, [place(5, 2.3), place(5, -3.8), place(2, 1), { x: 1, y: 1 }]],
  );
  const [wall, no_wall, desk, ground] = colours;
  assert.ok(Math.min(...wall) > 200, `the wall ends at y = 3, above: ${wall}`);
  assert.ok(Math.max(...no_wall) < 100, `${no_wall}`);
  assert.ok(desk[2] > 200 && desk[0] < 120, `the place lies to the left, above the middle: ${desk}`);
  assert.deepEqual(ground, [15, 19, 23]);
  await keep_screenshot(page, "plan-tools-dark");
});

test("Grid and legend look right in light colours and on a phone", async () => {
  for (const [name, options] of [
    ["plan-tools-light", desktop_light],
    ["plan-tools-phone", phone],
  ]) {
    const other = await open_page(given.browser, given.address, { ...options, locale: "de-AT" });
    await other.evaluate(() => (location.hash = "building/attic"));
    const tab = other.locator(".building-tab");
    await tab.getByRole("button", { name: "Mehr" }).click();
    for (const tool of ["Raster", "Legende"]) await tab.getByRole("button", { name: tool }).click();
    await tab.getByRole("button", { name: "Messen" }).click();
    await tab.getByText("Klicken Sie Punkte an.").waitFor();
    await keep_screenshot(other, name);
    await other.context().close();
  }
});

test("A place is dragged to where it faces", async () => {
  const { at } = await open_building(page);
  await page.getByLabel("Tool").selectOption("place");
  const [from, to] = [at(3, -2), at(3, 1)];
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(to.x, to.y, { steps: 4 });
  await page.mouse.up();
  assert.equal(await page.getByLabel("Heading in degrees").inputValue(), "90");
  await page.getByLabel("Name of the place").fill("lift");
  await page.getByRole("button", { name: "Name it" }).click();
  await page.getByRole("button", { name: "Save as a new version" }).click();
  await page.getByText("Saved as attic-2").waitFor();
  const { name, at_m, heading_deg } = vehicle.posts[0].body.places[1];
  assert.deepEqual([name, heading_deg], ["lift", 90]);
  assert.ok(Math.hypot(at_m[0] - 3, at_m[1] + 2) < 0.05, String(at_m));
});

test("A link opens a tab with what is chosen in it, and the address follows the choice", async () => {
  give_building(vehicle, ["attic", "floor"]);
  const entry = (name) => ({ name, file: `${name}_0.mcap`, bytes: 1, duration_s: 1 });
  vehicle.answers["sessions/list"] = () => ({ sessions: [entry("run-1"), entry("run-2")] });
  const other = await open_page(given.browser, `${given.address}#sessions/run-2`);
  await other.getByRole("link", { name: "run-2_0.mcap" }).waitFor();
  await other.getByRole("button", { name: "run-1", exact: true }).click();
  const hash = () => other.evaluate(() => location.hash);
  assert.equal(await hash(), "#sessions/run-1");
  await other.evaluate(() => (location.hash = "building/floor"));
  await other.getByText("2 walls, 1 place, floor").waitFor();
  assert.equal(await other.locator(".building-tools").getByLabel("Building").inputValue(), "floor");
  await other.getByRole("link", { name: "Sessions" }).click();
  await until(async () => (await hash()) === "#sessions/run-1", "the choice is in the address again");
  await other.evaluate(() => (location.hash = "drive/patrol"));
  await other.getByRole("button", { name: "Patrol" }).waitFor();
  await other.context().close();
});

test("A user who looks elsewhere is told when a mission has ended", async () => {
  vehicle.send_state({ mode: "mission", mission: "explore", driven_by_hand: false });
  await page.evaluate(() => {
    window.told = [];
    window.Notification = class {
      static permission = "default";
      static requestPermission = async () => (this.permission = "granted");
      constructor(title, { body }) {
        window.told.push(`${title}: ${body}`);
      }
    };
  });
  await page.getByLabel("Notify me when it ends").check();
  const end = (ok) => {
    const last = { mission: "explore", ok, text: "", problems: ok ? [] : ["stuck"] };
    vehicle.send_state({ mode: "idle", mission: "", driven_by_hand: true, last });
  };
  end(true);
  await page.getByText("Last: explore done.").waitFor();
  assert.deepEqual(await page.evaluate(() => window.told), []);
  await page.evaluate(() => (document.hasFocus = () => false));
  end(false);
  await until(async () => (await page.title()).startsWith("✗"), "the title says so");
  const [told] = await page.evaluate(() => window.told);
  assert.match(told, /^aisle: Last: explore not done\. stuck\./);
  await page.evaluate(() => dispatchEvent(new Event("focus")));
  assert.equal(await page.title(), "Drive · aisle");
});

test("What happened is on the timeline: the newest in words, by keys the others, with their place on the plan", async () => {
  const events = [
    { stamp_s: 0.5, kind: "state", text: "looking" },
    { stamp_s: 61, kind: "contact", text: "", at_m: [2, 1] },
    { stamp_s: 90, kind: "end", text: "not done" },
  ];
  vehicle.answers["mission/events"] = ({ from }) => ({
    from,
    events: events.slice(from, vehicle.state.events),
  });
  vehicle.send_state({ mode: "mission", mission: "explore", driven_by_hand: false, events: 2, stamp_s: 70 });
  const timeline = page.locator(".drive-tab").getByRole("slider", { name: "Events" });
  const drive = page.locator(".drive-tab");
  await drive.getByText("1:01 · bumper contact").waitFor();
  vehicle.send_state({ mode: "idle", mission: "", events: 3 });
  await drive.getByText("1:30 · ended · not done").waitFor();
  assert.deepEqual(
    given.called("mission/events").map(({ request }) => request.from),
    [0, 2],
  );
  await timeline.press("ArrowLeft");
  await drive.getByText("1:01 · bumper contact").waitFor();
  assert.equal(await timeline.getAttribute("aria-valuetext"), "1:01 · bumper contact");
  await keep_screenshot(page, "timeline-dark");
  await timeline.press("Home");
  await drive.getByText("0:01 · looking").waitFor();
  vehicle.send_state({ mode: "mission", mission: "go", events: 0 });
  await timeline.waitFor({ state: "hidden" });
});

test("A replay jumps to the event that is clicked on the timeline", async () => {
  const replay = { session: "run", from_s: 0, to_s: 60, at_s: 0, playing: false, rate: 1 };
  const events = [10, 30].map((stamp_s) => ({ stamp_s, kind: "state", text: `at ${stamp_s}` }));
  vehicle.answers["mission/events"] = ({ from }) => ({
    from,
    events: events.slice(from, vehicle.state.events),
  });
  vehicle.send_state({ mode: "replay", mission: "replay", driven_by_hand: false, replay, events: 2 });
  await page.evaluate(() => (location.hash = "sessions"));
  const timeline = page.locator(".sessions-tab").getByRole("slider", { name: "Events" });
  await timeline.waitFor();
  const box = await timeline.boundingBox();
  await page.mouse.click(box.x + box.width * 0.2, box.y + box.height / 2);
  await until(() => given.called("replay/seek").length === 1, "the jump");
  assert.equal(given.called("replay/seek")[0].request.to_s, 10);
});
