// The editor of buildings and the maze's, in a real browser with a fake server.
import assert from "node:assert/strict";
import { beforeEach, test } from "node:test";

import { keep_screenshot, until } from "./browser.mjs";
import { give_building, open_touch, with_fake_page } from "./fake_page.mjs";

const given = with_fake_page();
let vehicle, page;
beforeEach(async () => {
  ({ vehicle, page } = given);
  give_building(vehicle, ["attic", "floor"]);
});

const plan_of = (shown) => shown.getByRole("img", { name: "Plan of the building", exact: true });

async function open_editor(shown) {
  await shown.evaluate(() => (location.hash = "building"));
  await shown.getByText("2 walls, 1 place, floor").waitFor();
  const box = await plan_of(shown).boundingBox();
  return { x: box.x + box.width / 2, y: box.y + box.height / 2 };
}

async function drag(from, to) {
  await page.mouse.move(from.x, from.y);
  await page.mouse.down();
  await page.mouse.move(to.x, to.y, { steps: 4 });
  await page.mouse.up();
}

test("An edited building is saved with its new place and keep-out line, and without the false wall", async () => {
  await open_editor(page);
  const plan = page.getByRole("img", { name: "Plan of the building", exact: true });
  const box = await plan.boundingBox();
  const middle = { x: box.x + box.width / 2, y: box.y + box.height / 2 };

  await page.getByLabel("Tool").selectOption("delete");
  await page.mouse.click(middle.x, middle.y + 60);
  await page.getByText("1 wall, 1 place, floor").waitFor();
  await page.getByLabel("Tool").selectOption("place");
  await page.mouse.click(middle.x, middle.y - 40);
  await page.getByLabel("Name of the place").fill("lift");
  await page.getByRole("button", { name: "Name it" }).click();
  await page.getByText("1 wall, 2 places, floor").waitFor();
  await page.getByLabel("Tool").selectOption("keep_out");
  await page.mouse.move(middle.x - 60, middle.y);
  await page.mouse.down();
  await page.mouse.move(middle.x + 60, middle.y, { steps: 4 });
  await page.mouse.up();
  await page.getByRole("button", { name: "Save as a new version" }).click();
  await page.getByText("Saved as attic-2").waitFor();

  const { path, lease, body } = vehicle.posts[0];
  assert.equal(path, "/buildings/attic");
  assert.equal(lease, "token");
  assert.equal(body.walls.length, 1);
  assert.equal(body.places[1].name, "lift");
  const [{ kind, start_m, end_m }] = body.barriers;
  assert.equal(kind, "keep_out");
  assert.ok(start_m[0] < end_m[0] && Math.abs(start_m[1] - end_m[1]) < 0.01);
});

test("Two fingers move the plan and draw nothing", async () => {
  const phone = await open_touch(given, 360, 640);
  const middle = await open_editor(phone);
  await phone.getByLabel("Tool").selectOption("keep_out");
  await plan_of(phone).scrollIntoViewIfNeeded();
  const touch = await phone.context().newCDPSession(phone);
  const send = (type, ...points) =>
    touch.send("Input.dispatchTouchEvent", {
      type,
      touchPoints: points.map(([right, down], id) => ({ x: middle.x + right, y: middle.y + down, id })),
    });
  await send("touchStart", [0, 0]);
  await send("touchMove", [30, 0]);
  await send("touchStart", [30, 0], [-30, 0]);
  await send("touchMove", [60, 20], [-60, -20]);
  await send("touchMove", [80, 30], [-80, -30]);
  await send("touchEnd", [-80, -30]);
  await send("touchMove", [-80, 40]);
  await send("touchEnd");
  await send("touchStart", [-40, 60]);
  await send("touchMove", [40, 60]);
  await send("touchEnd");
  await phone.getByText("1 drawn line").waitFor();
  await phone.context().close();
});

test("A slow zone is drawn with its speed, and a one-way zone the way it was dragged", async () => {
  const middle = await open_editor(page);
  const tool = page.getByLabel("Tool");
  await tool.selectOption("slow_zone");
  await page.getByLabel("Speed in the zone").fill("0.15");
  await drag({ x: middle.x - 60, y: middle.y - 30 }, { x: middle.x - 10, y: middle.y + 30 });
  await page.getByText("1 zone").waitFor();
  await tool.selectOption("one_way_zone");
  assert.equal(await page.getByLabel("Speed in the zone").isVisible(), false);
  await drag({ x: middle.x + 60, y: middle.y - 20 }, { x: middle.x + 10, y: middle.y + 10 });
  await page.getByText("2 zones").waitFor();
  await page.getByRole("button", { name: "Save as a new version" }).click();
  await page.getByText("Saved as attic-2").waitFor();
  assert.deepEqual(
    vehicle.posts[0].body.zones.map(({ kind, speed_max_mps, direction_deg }) => [
      kind,
      speed_max_mps,
      direction_deg,
    ]),
    [
      ["slow", 0.15, undefined],
      ["one_way", undefined, 180],
    ],
  );
});

test("A room is named where it has most space, and its place gets another name", async () => {
  const middle = await open_editor(page);
  await page.getByLabel("Tool").selectOption("room");
  await page.mouse.click(middle.x + 70, middle.y - 50);
  await page.getByLabel("Name of the place").fill("hall");
  await page.getByRole("button", { name: "Name it" }).click();
  await page.getByText("2 places").waitFor();
  await page.getByRole("button", { name: "Rename the place hall" }).click();
  assert.equal(await page.getByLabel("Heading in degrees").isVisible(), false);
  await page.getByLabel("Name of the place").fill("desk");
  await page.getByRole("button", { name: "Name it" }).click();
  await page.getByText("there is a place named desk already").waitFor();
  await page.getByLabel("Name of the place").fill("great hall");
  await page.getByRole("button", { name: "Name it" }).click();
  await page.getByRole("button", { name: "Delete the place great hall" }).waitFor();
  await keep_screenshot(page, "editor-room-dark");
  await page.getByRole("button", { name: "Save as a new version" }).click();
  await page.getByText("Saved as attic-2").waitFor();
  const [desk, hall] = vehicle.posts[0].body.places;
  assert.equal(desk.name, "desk");
  assert.equal(hall.name, "great hall");
  assert.ok(hall.at_m[0] > 3.4 && hall.at_m[0] < 6.6 && Math.abs(hall.at_m[1]) < 0.6, String(hall.at_m));
});

test("A named room is shown as far as its walls and its door", async () => {
  const walled = Array(7).fill("10.1#9.");
  vehicle.files["/buildings/attic.json"].floor.rows = [...walled, "20.", "20.", ...walled];
  const middle = await open_editor(page);
  const box = await plan_of(page).boundingBox();
  const colours = () =>
    plan_of(page).evaluate(
      (canvas, points) => {
        const context = canvas.getContext("2d");
        return points.map(([x, y]) => context.getImageData(x, y, 1, 1).data.join());
      },
      [-100, 100].map((right) => [middle.x - box.x + right, middle.y - box.y - 60]),
    );
  const [left, right] = await colours();
  assert.equal(left, right);
  await page.getByLabel("Tool").selectOption("room");
  await page.mouse.click(middle.x - 100, middle.y - 60);
  await page.getByLabel("Name of the place").fill("office");
  await page.getByRole("button", { name: "Name it" }).click();
  await page.getByText("2 places").waitFor();
  await until(async () => (await colours())[0] !== left, "the room is shown");
  assert.equal((await colours())[1], right, "the room behind the door is not");
  await page.locator(".building-tab").getByRole("button", { name: "More" }).click();
  await page.locator(".building-tab").getByRole("button", { name: "Legend" }).click();
  await keep_screenshot(page, "editor-named-room-dark");
});

test("Under a finger, what will be deleted is shown first", async () => {
  const phone = await open_touch(given, 768, 1024);
  const middle = await open_editor(phone);
  await phone.getByLabel("Tool").selectOption("delete");
  await phone.touchscreen.tap(middle.x, middle.y + 60);
  await phone.getByText("Click the marked wall again to delete it.").waitFor();
  await phone.getByText("2 walls").waitFor();
  await phone.touchscreen.tap(middle.x, middle.y + 60);
  await phone.getByText("1 wall, 1 place, floor").waitFor();
  await phone.context().close();
});

test("Edits outlast a change of buildings, are marked as not saved, and are undone by keys", async () => {
  const middle = await open_editor(page);
  await page.getByLabel("Tool").selectOption("keep_out");
  await drag({ x: middle.x - 60, y: middle.y }, { x: middle.x + 60, y: middle.y });
  await page.getByText("1 drawn line").waitFor();
  const chooser = page.locator(".building-tools").getByLabel("Building");
  await chooser.locator("option", { hasText: "attic · not saved" }).waitFor({ state: "attached" });
  await chooser.selectOption("floor");
  await page.getByText("2 walls, 1 place, floor").waitFor();
  await chooser.selectOption("attic");
  await page.getByText("1 drawn line").waitFor();
  await plan_of(page).focus();
  await page.keyboard.press("Control+z");
  await page.getByText("2 walls, 1 place, floor").waitFor();
  await chooser.locator("option", { hasText: /^attic$/ }).waitFor({ state: "attached" });
  await page.keyboard.press("Control+Shift+z");
  await page.getByText("1 drawn line").waitFor();
  const asked = new Promise((resolve) => page.once("dialog", resolve));
  const leaving = page.reload().catch(() => undefined);
  const dialog = await asked;
  assert.equal(dialog.type(), "beforeunload");
  await dialog.dismiss();
  await leaving;
  await page.getByText("1 drawn line").waitFor();
});

test("The arrow keys move the plan when they do not drive", async () => {
  await open_editor(page);
  const plan = plan_of(page);
  const picture = () => plan.evaluate((canvas) => canvas.toDataURL());
  const before = await picture();
  await plan.focus();
  await page.keyboard.press("ArrowLeft");
  await until(async () => (await picture()) !== before, "another part of the plan");
});

test("A wall that is drawn along a line has no stubs", async () => {
  vehicle.answers["maze/run"] = () => new Error("no engine here");
  await page.evaluate(() => (location.hash = "maze"));
  for (const side of ["Width", "Height"]) await page.getByLabel(side).fill("4");
  await page.getByRole("button", { name: "Empty" }).click();
  const box = await page.getByRole("application", { name: /Maze/ }).boundingBox();
  const cell = Math.min((box.width - 28) / 4, (box.height - 28) / 4, 64);
  const at = (x, y) => ({
    x: box.x + box.width / 2 + (x - 2) * cell,
    y: box.y + box.height / 2 - (y - 2) * cell,
  });
  await drag(at(0.5, 2.08), at(3.5, 1.93));
  await page.getByRole("button", { name: "Explore" }).click();
  await page.getByText("no engine here").waitFor();
  const open = "|               |";
  const [edge, wall] = ["o---o---o---o---o", "o   o   o   o   o"];
  const drawn = given.called("maze/run")[0].request.maze.trimEnd().split("\n");
  assert.deepEqual(
    drawn.map((line) => line.replace("S", " ")),
    [edge, open, wall, open, edge, open, wall, open, edge],
  );
});
