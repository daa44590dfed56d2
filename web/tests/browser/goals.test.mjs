// Where the vehicle is sent on the plan: to a point, with a heading, to several goals in order. With a fake server.
import assert from "node:assert/strict";
import { beforeEach, test } from "node:test";

import { desktop_light, keep_screenshot, open_page, phone, until } from "./browser.mjs";
import { give_building, with_fake_page } from "./fake_page.mjs";

const given = with_fake_page();
const { called } = given;
let vehicle, page;
beforeEach(async () => {
  ({ vehicle, page } = given);
  give_building(vehicle, ["attic"]);
  await page.goto("about:blank");
  await page.goto(`${given.address}#drive/go`);
});

const requests = () => called("mission/go").map(({ request: { lease, ...goal } }) => goal);

/** The building is fitted in as 10 m by 7.5 m about (5, -0.25). @returns where a point is now */
async function open_go(shown) {
  await shown.locator('.mission-panel option[value="desk"]').waitFor({ state: "attached" });
  return async (x, y) => {
    await shown.evaluate(
      () => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(done))),
    );
    return shown.evaluate(
      ([x, y]) => {
        const canvas = document.querySelector(".drive-tab .stage .plan canvas");
        const box = canvas.getBoundingClientRect();
        const inset = document.querySelector(".stage[data-main=plan] .camera-box");
        const covered = (inset?.clientWidth ?? 0) + 12;
        const left = covered < canvas.clientWidth / 2 ? covered : 0;
        const px_per_m = Math.min(200, (box.width - left - 64) / 10, (box.height - 64) / 7.5);
        return {
          x: box.x + box.width / 2 + (x - 5) * px_per_m + left / 2,
          y: box.y + box.height / 2 - (y + 0.25) * px_per_m,
        };
      },
      [x, y],
    );
  };
}

async function drag(shown, from, to) {
  await shown.mouse.move(from.x, from.y);
  await shown.mouse.down();
  await shown.mouse.move(to.x, to.y, { steps: 5 });
}

/** Within a pixel or two of a phone. */
function assert_goal(goal, x_m, y_m, heading_deg) {
  assert.ok(Math.hypot(goal.x_m - x_m, goal.y_m - y_m) < 0.15, JSON.stringify(goal));
  if (heading_deg === undefined) assert.ok(!("heading_deg" in goal));
  else assert.ok(Math.abs(goal.heading_deg - heading_deg) <= 2, JSON.stringify(goal));
}

test("A drag sends the vehicle to where it began, facing where it ended; a click's heading does not matter", async () => {
  const at = await open_go(page);
  await drag(page, await at(3, -2), await at(3, 1));
  await keep_screenshot(page, "goal-heading-dark");
  assert.deepEqual(requests(), []);
  await page.mouse.up();
  await until(() => requests().length === 1, "the vehicle is sent");
  const [{ building, ...goal }] = requests();
  assert.equal(building, "attic");
  assert_goal(goal, 3, -2, 90);
  const clicked = await at(7, -3);
  await page.mouse.click(clicked.x, clicked.y);
  await page.getByText(/^-?\d\.\d\d, -?\d\.\d\d m in attic$/).waitFor();
  assert.equal(requests().length, 1);
  await page.getByRole("button", { name: "Go there" }).click();
  await until(() => requests().length === 2, "the vehicle is sent once it is confirmed");
  assert_goal(requests()[1], 7, -3);
});

test("Shift and click makes a queue, of which goals are taken out, and which is driven in order", async () => {
  const at = await open_go(page);
  const list = page.getByRole("list", { name: "Goals in order" });
  await page.keyboard.down("Shift");
  for (const [x, y] of [
    [2, 1],
    [7, -2],
    [8, 2],
  ]) {
    const there = await at(x, y);
    await page.mouse.click(there.x, there.y);
  }
  await page.keyboard.up("Shift");
  await until(async () => (await list.getByRole("listitem").count()) === 3, "three goals");
  assert.deepEqual(requests(), []);
  await drag(page, await at(3, -2), await at(1, -2));
  await page.mouse.up();
  await until(
    async () => (await list.getByRole("listitem").count()) === 4,
    "a goal with a heading joins them",
  );
  await page.getByRole("button", { name: "Remove goal 2" }).click();
  await until(async () => (await list.getByRole("listitem").count()) === 3, "one is taken out");
  await keep_screenshot(page, "goal-queue-dark");
  await page.getByRole("button", { name: "Drive in order" }).click();
  await until(() => requests().length === 1, "the vehicle is sent");
  const [first, second, third] = requests()[0].goals;
  assert.deepEqual(first, { place: "desk" });
  assert_goal(second, 8, 2);
  assert_goal(third, 3, -2, 180);
  await list.waitFor({ state: "hidden" });
});

test("A queue that is refused says why, and is still there", async () => {
  const at = await open_go(page);
  vehicle.answers["mission/go"] = () => new Error("goals.1: nothing is known there");
  const there = await at(7, -2);
  await page.mouse.click(there.x, there.y);
  await page.getByRole("button", { name: "Add", exact: true }).click();
  await page.getByRole("button", { name: "Drive in order" }).click();
  await page.locator(".notice.trouble").getByText("nothing is known there").waitFor();
  await page.getByRole("button", { name: "Remove goal 1" }).click();
  await page.getByRole("button", { name: "Drive in order" }).waitFor({ state: "hidden" });
});

test("While the goals are driven to, the plan shows their numbers", async () => {
  const gold = (shown) =>
    shown.evaluate(() => {
      const canvas = document.querySelector(".drive-tab .stage .plan canvas");
      const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
      const wanted = getComputedStyle(document.documentElement).getPropertyValue("--path").trim();
      const rgb = [1, 3, 5].map((from) => parseInt(wanted.slice(from, from + 2), 16));
      let count = 0;
      for (let at = 0; at < data.length; at += 4)
        if (rgb.every((value, channel) => data[at + channel] === value)) count += 1;
      return count;
    });
  vehicle.send_state({ mode: "mission", mission: "go", driven_by_hand: false });
  assert.equal(await gold(page), 0);
  vehicle.send_state({
    goals: [
      { x_m: 1, y_m: 1 },
      { x_m: -2, y_m: 0, heading_deg: 45 },
    ],
  });
  await until(async () => (await gold(page)) > 100, "the goals are drawn");
  await keep_screenshot(page, "goal-driving-dark");
  vehicle.send_state({ mode: "idle", mission: "", goals: undefined });
});

/** A mission to three goals, of which it has reached one; it changes them as it is asked. */
function drive_to_goals(vehicle) {
  const goals = [{ x_m: 0, y_m: 0 }, { place: "desk" }, { x_m: 8, y_m: 2, heading_deg: 90 }];
  const change = (changed) => {
    vehicle.send_state({ goals: changed });
    return { goals: changed };
  };
  vehicle.answers["mission/goals"] = ({ add, remove }) =>
    change(
      add ? [...vehicle.state.goals, add] : vehicle.state.goals.filter((_, index) => index !== remove - 1),
    );
  vehicle.publish("/map", "visualization_msgs/MarkerArray", { markers: [wall_of(0, -3), wall_of(10, 3)] });
  vehicle.send_state({ mode: "mission", mission: "go", driven_by_hand: false, goals, goals_reached: 1 });
}

function wall_of(x, y) {
  const zero = { x: 0, y: 0, z: 0 };
  return {
    header: { stamp: { sec: 0, nanosec: 0 }, frame_id: "map" },
    ns: "walls",
    id: Math.round(x),
    type: 4,
    action: 0,
    pose: { position: zero, orientation: { ...zero, w: 1 } },
    scale: { x: 0.05, y: 0, z: 0 },
    color: { r: 1, g: 1, b: 1, a: 1 },
    lifetime: { sec: 0, nanosec: 0 },
    frame_locked: false,
    points: [
      { x, y, z: 0 },
      { x: x + 0.1, y, z: 0 },
    ],
    colors: [],
    text: "",
    mesh_resource: "",
    mesh_use_embedded_materials: false,
  };
}

for (const [size, open] of [
  ["desktop", undefined],
  ["phone", phone],
]) {
  test(`On the way a goal is added, and one that is not reached is taken out: ${size}`, async () => {
    const shown = open ? await open_page(given.browser, `${given.address}#drive/go`, open) : page;
    await shown.locator('.mission-panel option[value="desk"]').waitFor({ state: "attached" });
    drive_to_goals(vehicle);
    const list = shown.getByRole("list", { name: "Goals in order" });
    await until(async () => (await list.getByRole("listitem").count()) === 2, "what is left");
    assert.equal(await shown.getByRole("button", { name: "Remove goal 1" }).count(), 0, "it is reached");
    assert.equal(await shown.getByRole("button", { name: "Drive in order" }).isVisible(), false);
    const canvas = shown.locator(".drive-tab .stage .plan canvas");
    const box = await canvas.boundingBox();
    const at = { x: box.width * 0.6, y: box.height * 0.6 };
    if (open) await canvas.tap({ position: at });
    else await canvas.click({ position: at });
    assert.equal(await shown.getByRole("button", { name: "Go there" }).isVisible(), false);
    await shown.getByRole("button", { name: "Add", exact: true }).click();
    await shown.getByRole("button", { name: "Remove goal 4" }).waitFor();
    await keep_screenshot(shown, `goal-extended-${size}`);
    await shown.getByRole("button", { name: "Remove goal 2" }).click();
    await until(async () => (await list.getByRole("listitem").count()) === 2, "one is taken out");
    const changes = called("mission/goals").map(({ request: { lease, ...change } }) => change);
    assert.equal(changes.length, 2);
    assert.equal(typeof changes[0].add.x_m, "number");
    assert.deepEqual(changes[1], { remove: 2 });
    assert.deepEqual(requests(), []);
    vehicle.send_state({ goals_reached: 2 });
    await list.waitFor({ state: "hidden" });
    vehicle.send_state({ mode: "idle", mission: "", goals: undefined, goals_reached: undefined });
    if (open) await shown.context().close();
  });
}

test("Shift and a drag adds a goal with its heading to the queue", async () => {
  const at = await open_go(page);
  const list = page.getByRole("list", { name: "Goals in order" });
  await page.keyboard.down("Shift");
  await drag(page, await at(3, -2), await at(3, 1));
  await keep_screenshot(page, "goal-heading-added-dark");
  await page.keyboard.up("Shift"); // before the button: the vehicle is not sent off
  await page.mouse.up();
  await until(async () => (await list.getByRole("listitem").count()) === 1, "it is in the queue");
  assert.deepEqual(requests(), []);
  await page.keyboard.down("Shift");
  const there = await at(7, -3);
  await page.mouse.click(there.x, there.y);
  await drag(page, await at(8, 2), await at(6, 2));
  await page.mouse.up();
  await page.keyboard.up("Shift");
  await until(async () => (await list.getByRole("listitem").count()) === 3, "two more");
  await keep_screenshot(page, "goal-headings-queue-dark");
  await page.getByRole("button", { name: "Drive in order" }).click();
  await until(() => requests().length === 1, "the vehicle is sent");
  const [first, second, third] = requests()[0].goals;
  assert_goal(first, 3, -2, 90);
  assert_goal(second, 7, -3);
  assert_goal(third, 8, 2, 180);
});

test("On the way Shift and a drag adds a goal with its heading, and a drag alone moves the plan", async () => {
  await page.locator('.mission-panel option[value="desk"]').waitFor({ state: "attached" });
  drive_to_goals(vehicle);
  await page.getByRole("button", { name: "Remove goal 2" }).waitFor();
  const box = await page.locator(".drive-tab .stage .plan canvas").boundingBox();
  const from = { x: box.x + box.width * 0.6, y: box.y + box.height * 0.6 };
  const above = { x: from.x, y: from.y - 90 };
  const changes = () => called("mission/goals").map(({ request: { lease, ...change } }) => change);
  await drag(page, from, above);
  await page.mouse.up();
  await page.keyboard.down("Shift");
  await drag(page, from, above);
  await keep_screenshot(page, "goal-heading-extended-dark");
  await page.mouse.up();
  await page.keyboard.up("Shift");
  await page.getByRole("button", { name: "Remove goal 4" }).waitFor();
  assert.equal(changes().length, 1, "a drag alone moves the plan");
  assert.equal(Math.round(changes()[0].add.heading_deg), 90);
  await page.getByRole("button", { name: "Add", exact: true }).waitFor({ state: "hidden" });
  const list = page.getByRole("list", { name: "Goals in order" });
  assert.match(await list.getByRole("listitem").last().textContent(), /facing 90°/);
  await keep_screenshot(page, "goal-headings-driving-dark");
  assert.deepEqual(requests(), []);
  vehicle.send_state({ mode: "idle", mission: "", goals: undefined, goals_reached: undefined });
});

test("A goal that is refused on the way says why, and can still be added", async () => {
  await page.locator('.mission-panel option[value="desk"]').waitFor({ state: "attached" });
  drive_to_goals(vehicle);
  vehicle.answers["mission/goals"] = () => new Error("PLACE: nothing is known at 5,9");
  await page.getByRole("button", { name: "Remove goal 2" }).waitFor();
  await page.locator(".drive-tab .stage .plan canvas").click({ position: { x: 700, y: 300 } });
  await page.getByRole("button", { name: "Add", exact: true }).click();
  await page.locator(".notice.trouble").getByText("nothing is known at 5,9").waitFor();
  assert.equal(await page.getByRole("button", { name: "Add", exact: true }).isEnabled(), true);
  assert.equal(await page.getByRole("button", { name: "Remove goal 2" }).isEnabled(), true);
  vehicle.send_state({ mode: "idle", mission: "", goals: undefined, goals_reached: undefined });
  await page.getByRole("button", { name: "Add", exact: true }).waitFor({ state: "hidden" });
});

test("A finger drags a heading, too, and two fingers move the plan", async () => {
  const touch = await open_page(given.browser, `${given.address}#drive/go`, phone);
  const at = await open_go(touch);
  await touch.evaluate(() => scrollTo(0, 0));
  const session = await touch.context().newCDPSession(touch);
  const send = (type, ...points) =>
    session.send("Input.dispatchTouchEvent", {
      type,
      touchPoints: points.map(({ x, y }, id) => ({ x, y, id })),
    });
  const [from, to, other] = [await at(3, -2), await at(7, -2), await at(8, 2)];
  await send("touchStart", from);
  await send("touchMove", to);
  await send("touchStart", to, other);
  await send("touchEnd", to);
  await send("touchEnd");
  await touch.getByRole("button", { name: "Fit" }).first().tap();
  const [again, there] = [await at(3, -2), await at(7, -2)];
  await send("touchStart", again);
  await send("touchMove", { x: (again.x + there.x) / 2, y: again.y });
  await send("touchMove", there);
  await keep_screenshot(touch, "goal-heading-phone");
  await send("touchEnd");
  await until(() => requests().length > 0, "the vehicle is sent");
  assert.equal(requests().length, 1, "two fingers move the plan");
  assert.equal(requests()[0].heading_deg, 0);
  await touch.context().close();
});

test("What a finger taps is added by a button", async () => {
  const touch = await open_page(given.browser, `${given.address}#drive/go`, phone);
  const at = await open_go(touch);
  for (const [x, y] of [
    [7, -2],
    [8, 2],
  ]) {
    const tapped = await at(x, y);
    await touch.touchscreen.tap(tapped.x, tapped.y);
    await touch.getByRole("button", { name: "Add", exact: true }).tap();
  }
  await touch.getByRole("button", { name: "Remove goal 2" }).waitFor();
  await keep_screenshot(touch, "goal-queue-phone");
  await touch.getByRole("button", { name: "Drive in order" }).tap();
  await until(() => requests().length === 1, "the queue is sent");
  const [first, second] = requests()[0].goals;
  assert_goal(first, 7, -2);
  assert_goal(second, 8, 2);
  await touch.context().close();
});

test("In another task a drag moves the plan, as does the middle button", async () => {
  const at = await open_go(page);
  await page.mouse.move(...Object.values(await at(3, -2)));
  await page.mouse.down({ button: "middle" });
  await page.mouse.move(...Object.values(await at(6, -2)), { steps: 3 });
  await page.mouse.up({ button: "middle" });
  await page.evaluate(() => (location.hash = "drive/patrol"));
  await page.getByRole("button", { name: "Patrol" }).waitFor();
  await drag(page, await at(3, -2), await at(6, -2));
  await page.mouse.up();
  await page.evaluate(() => new Promise(requestAnimationFrame));
  assert.deepEqual(requests(), []);
  assert.equal(await page.getByRole("button", { name: "Go there" }).isVisible(), false);
});

test("The goals look right in light colours", async () => {
  const other = await open_page(given.browser, `${given.address}#drive/go`, {
    ...desktop_light,
    locale: "de-AT",
  });
  await other.locator('.mission-panel option[value="desk"]').waitFor({ state: "attached" });
  const canvas = other.locator(".drive-tab .stage .plan canvas");
  await other.keyboard.down("Shift");
  for (const x of [0.55, 0.7, 0.8]) {
    const box = await canvas.boundingBox();
    await other.mouse.click(box.x + box.width * x, box.y + box.height * 0.7);
  }
  await other.keyboard.up("Shift");
  await other.getByRole("button", { name: "Ziel 3 entfernen" }).waitFor();
  await keep_screenshot(other, "goal-queue-light");
  await other.context().close();
});
