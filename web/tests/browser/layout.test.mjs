// Whether every control can be reached, by touch and by keyboard, at the sizes of phones, tablets and desktops.
import assert from "node:assert/strict";
import { readFileSync } from "node:fs";
import { createRequire } from "node:module";
import { test } from "node:test";

import { desktop, desktop_light, open_page, until } from "./browser.mjs";
import { give_building, open_touch, with_fake_page } from "./fake_page.mjs";

const sizes = [
  [360, 640],
  [640, 360],
  [768, 1024],
  [1024, 600],
  [1440, 900],
];
const tabs = ["drive", "maze", "sessions", "building"];
const given = with_fake_page();

/** The controls whose centre is covered by something else, or which cannot be focused. */
function unreachable() {
  const controls = [
    ...document.querySelectorAll("button, a, input, select, summary, canvas[tabindex], [role=application]"),
  ].filter((control) => control.checkVisibility() && getComputedStyle(control).pointerEvents !== "none");
  const why = (control) => {
    control.scrollIntoView({ block: "nearest", inline: "nearest" });
    const box = control.getBoundingClientRect();
    const [x, y] = [box.x + box.width / 2, box.y + box.height / 2];
    if (x < 0 || y < 0 || x >= innerWidth || y >= innerHeight) return "lies outside";
    const hit = document.elementFromPoint(x, y);
    const is_itself = control.contains(hit) || control.labels?.[0]?.contains(hit);
    if (!is_itself) return `is covered by ${hit?.outerHTML.slice(0, 80)}`;
    if (control.disabled || control.closest("fieldset:disabled") || control.matches(".pad")) return undefined;
    control.focus();
    return document.activeElement === control ? undefined : "cannot be focused";
  };
  return controls.flatMap((control) => {
    const reason = why(control);
    return reason ? [`${control.outerHTML.slice(0, 80)} ${reason}`] : [];
  });
}

async function check_reach(page, where) {
  assert.deepEqual(await page.evaluate(unreachable), [], where);
  const width = await page.evaluate(() => document.documentElement.scrollWidth - innerWidth);
  assert.ok(width <= 0, `${where} is ${width} px too wide`);
}

for (const [width, height] of sizes) {
  test(`Nothing covers a control at ${width} x ${height}`, async () => {
    give_building(given.vehicle);
    const page = await open_touch(given, width, height);
    for (const tab of tabs) {
      await page.evaluate((name) => (location.hash = name), tab);
      await page.locator(`.${tab}-tab`).waitFor();
      await check_reach(page, tab);
    }
    await page.evaluate(() => (location.hash = "drive"));
    await page.locator(".details-panel summary").click();
    await check_reach(page, "details");
    await page.locator(".details-panel summary").click();

    await page.getByRole("button", { name: "Take the controls" }).click();
    given.vehicle.send_state({ mode: "mission", mission: "teach", driven_by_hand: true });
    await page.getByRole("application", { name: /Drive pad/ }).waitFor();
    await page.getByRole("button", { name: "Turning begins" }).waitFor();
    await check_reach(page, "teaching");

    given.vehicle.send_state({
      mission: "explore",
      driven_by_hand: false,
      paused: true,
      emergency: true,
      keeps_buildings: true,
    });
    await page.getByRole("button", { name: "End and keep the map" }).waitFor();
    given.vehicle.answers["mission/pause"] = () => new Error("a trouble that is told in a sentence");
    given.vehicle.send_state({ last: { mission: "go", ok: false, text: "", problems: ["no path"] } });
    await page.locator(".notice.trouble").waitFor();
    await check_reach(page, "held, with a message");
    await page.context().close();
  });
}

test("In German, too, nothing covers a control", async () => {
  give_building(given.vehicle);
  for (const [width, height] of sizes) {
    const page = await open_touch(given, width, height);
    await page.getByRole("button", { name: "Deutsch" }).tap();
    await page.getByRole("link", { name: "Fahren" }).waitFor();
    assert.equal(await page.evaluate(() => document.documentElement.lang), "de");
    for (const tab of tabs) {
      await page.evaluate((name) => (location.hash = name), tab);
      await page.locator(`.${tab}-tab`).waitFor();
      await check_reach(page, `${tab} at ${width} x ${height}`);
    }
    await page.context().close();
  }
});

test("The stop button stays where it is in the same size, and no other comes under the finger", async () => {
  for (const [width, height] of sizes) {
    given.vehicle.send_state({ mode: "mission", mission: "explore", driven_by_hand: false, paused: false });
    given.vehicle.send_state({ emergency: false });
    const page = await open_touch(given, width, height);
    const stop = page.getByRole("button", { name: "Emergency stop" });
    const before = await stop.boundingBox();
    const stops = given.called("mission/emergency_stop").length;
    await stop.tap();
    given.vehicle.send_state({ emergency: true, paused: true });
    await page.getByText("STOPPED", { exact: true }).waitFor();
    assert.deepEqual(await stop.boundingBox(), before, `${width} x ${height}`);
    await page.touchscreen.tap(before.x + before.width / 2, before.y + before.height / 2);
    await until(() => given.called("mission/emergency_stop").length === stops + 2, "two stops");
    await page.context().close();
  }
  assert.equal(given.called("mission/emergency_release").length, 0);
});

test("On a phone that drives by the pad, the camera is to be seen", async () => {
  for (const [width, height] of [
    [360, 640],
    [640, 360],
  ]) {
    const page = await open_touch(given, width, height);
    await page.getByRole("button", { name: "Take the controls" }).click();
    const pad = page.getByRole("application", { name: /Drive pad/ });
    await pad.waitFor();
    const camera = await page.locator(".camera-box .camera-image").boundingBox();
    assert.ok(camera.height >= 140 && camera.width >= 200, `${camera.width} x ${camera.height}`);
    await page.getByRole("button", { name: "Swap camera and plan" }).click();
    await page.getByRole("button", { name: "Zoom in" }).waitFor();
    await page.context().close();
  }
});

test("axe finds nothing wrong", async () => {
  const axe = readFileSync(createRequire(import.meta.url).resolve("axe-core/axe.min.js"), "utf8");
  give_building(given.vehicle);
  for (const options of [desktop, desktop_light]) {
    const page = await open_page(given.browser, given.address, options);
    await page.getByText("l-corridor: ").first().waitFor();
    await page.evaluate(axe);
    const check = async (where) => {
      const { violations } = await page.evaluate(() => window.axe.run());
      const found = violations.map(({ id, nodes }) => `${id}: ${nodes.map(({ html }) => html).join(" ")}`);
      assert.deepEqual(found, [], where);
    };
    for (const tab of tabs) {
      await page.evaluate((name) => (location.hash = name), tab);
      await page.locator(`.${tab}-tab`).waitFor();
      await check(tab);
    }
    given.vehicle.send_state({ mode: "mission", mission: "explore", paused: true, emergency: true });
    await page.getByRole("button", { name: "Resume" }).waitFor();
    await page.evaluate(() => (location.hash = "drive"));
    await page.locator(".details-panel summary").click();
    await check("held");
    given.vehicle.send_state({ mode: "idle", mission: "", paused: false, emergency: false });
    await page.context().close();
  }
});
