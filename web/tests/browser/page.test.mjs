// The page in a real browser, with a fake server that sends what each test needs.
import assert from "node:assert/strict";
import { beforeEach, test } from "node:test";

import { desktop_light, open_page, until } from "./browser.mjs";
import { give_building, with_fake_page } from "./fake_page.mjs";

const given = with_fake_page();
const { called } = given;
let vehicle, address, page;
beforeEach(() => ({ vehicle, address, page } = given));

test("Shows a lost connection, and reconnects by itself", async () => {
  const port = Number(new URL(address).port);
  await vehicle.stop();
  await page.getByText("Not connected").waitFor();
  assert.ok(await page.getByRole("button", { name: "Emergency stop" }).isDisabled());
  await vehicle.start(port);
  await page.getByText("l-corridor: waiting").waitFor();
});

test("Speaks the browser's language until the user chooses one, and then that", async () => {
  const german = await open_page(given.browser, address, { ...desktop_light, locale: "de-AT" });
  await german.getByRole("link", { name: "Gebäude" }).waitFor();
  await german.getByRole("button", { name: "English" }).click();
  await german.getByRole("link", { name: "Building" }).waitFor();
  await german.reload();
  await german.getByRole("link", { name: "Building" }).waitFor();
  await german.context().close();
});

test("Shows when the data are old", async () => {
  vehicle.stop_sending();
  await page.getByText("Old data").waitFor();
});

test("Shows who drives, and why the controls are refused", async () => {
  vehicle.send_state({ lease_held: true });
  await page.getByText("somebody else holds the controls").waitFor();
  vehicle.answers["lease/take"] = () => new Error("anna drives");
  await page.getByRole("button", { name: "Take the controls" }).click();
  await page.getByText("anna drives").waitFor();
});

test("Arrow keys drive while held, and the last command is a stop", async () => {
  await page.getByRole("button", { name: "Take the controls" }).click();
  await page.getByText("you hold the controls").waitFor();
  await page.keyboard.down("ArrowUp");
  await page.keyboard.down("ArrowLeft");
  await until(() => vehicle.drives.some(({ steering_rad }) => steering_rad > 0), "a curve to the left");
  await page.keyboard.up("ArrowUp");
  await page.keyboard.up("ArrowLeft");
  await until(() => vehicle.drives.at(-1)?.speed_mps === 0, "a stop command");
  const sequences = vehicle.drives.map(({ sequence }) => sequence);
  assert.deepEqual(
    sequences,
    [...sequences].sort((a, b) => a - b),
  );
  assert.equal(new Set(sequences).size, sequences.length);
  assert.ok(vehicle.drives.every(({ lease }) => lease === "token"));
});

test("An expired lease is taken again if it is free, and keys that are still held no longer drive", async () => {
  await page.getByRole("button", { name: "Take the controls" }).click();
  await page.getByText("you hold the controls").waitFor();
  await page.keyboard.down("ArrowUp");
  await until(() => vehicle.drives.length > 0, "driving");
  vehicle.answers["lease/take"] = () => ({ lease: "second token", valid_s: 3 });
  vehicle.answers["lease/renew"] = ({ lease }) =>
    lease === "token" ? new Error("the lease ran out") : { valid_s: 3 };
  await until(() => called("lease/take").length === 2, "taken again");
  await page.getByText("you hold the controls").waitFor();
  assert.ok(vehicle.drives.every(({ lease }) => lease === "token"));
  await page.keyboard.up("ArrowUp");
  await page.keyboard.down("ArrowUp");
  await until(() => vehicle.drives.at(-1)?.lease === "second token", "driving again");
  const again = vehicle.drives.filter(({ lease }) => lease === "second token");
  assert.equal(again[0].sequence, 1);
  await page.keyboard.up("ArrowUp");

  vehicle.answers["lease/renew"] = () => new Error("the lease ran out");
  vehicle.answers["lease/take"] = () => new Error("anna drives");
  await page.getByText("nobody holds the controls").waitFor();
});

test("Without the lease the arrow keys send nothing", async () => {
  await page.keyboard.press("ArrowUp");
  await page.getByRole("button", { name: "Emergency stop" }).click();
  await until(() => called("mission/emergency_stop").length === 1, "the call that comes after the key");
  assert.deepEqual(vehicle.drives, []);
});

test("The pad drives while it is dragged", async () => {
  await page.getByRole("button", { name: "Take the controls" }).click();
  await page.getByText("you hold the controls").waitFor();
  const pad = page.getByRole("application", { name: /Drive pad/ });
  const box = await pad.boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await page.mouse.move(box.x + box.width / 2, box.y + 6);
  await until(() => vehicle.drives.some(({ speed_mps }) => speed_mps > 0), "driving ahead");
  await page.mouse.up();
  await until(() => vehicle.drives.at(-1)?.speed_mps === 0, "a stop command");
});

test("A gamepad's left stick drives, and releasing it sends a stop", async () => {
  await page.getByRole("button", { name: "Take the controls" }).click();
  await page.getByText("you hold the controls").waitFor();
  await page.evaluate(() => {
    window.stick = { axes: [-0.5, -1] };
    navigator.getGamepads = () => [null, window.stick];
    dispatchEvent(new Event("gamepadconnected"));
  });
  await until(
    () => vehicle.drives.some(({ speed_mps, steering_rad }) => speed_mps > 0 && steering_rad > 0),
    "a curve to the left",
  );
  await page.evaluate(() => (window.stick.axes = [0.1, 0.1]));
  await until(() => vehicle.drives.at(-1)?.speed_mps === 0, "a stop command");
});

test("The stop button and Escape work in every tab without the lease", async () => {
  for (const tab of ["Drive", "Maze", "Sessions", "Building"]) {
    await page.getByRole("link", { name: tab }).click();
    const before = called("mission/emergency_stop").length;
    await page.getByRole("button", { name: "Emergency stop" }).click();
    await page.keyboard.press("Escape");
    await until(() => called("mission/emergency_stop").length === before + 2, `two stops in ${tab}`);
  }
  assert.equal(called("lease/take").length, 0);
});

test("A mission starts with the filled-in fields", async () => {
  await page.getByRole("combobox", { name: "Mission" }).selectOption("teach");
  await page.getByRole("textbox", { name: "Route" }).fill("desk to lift");
  await page.getByRole("button", { name: "Start teaching" }).click();
  await until(() => called("mission/start").length === 1, "the mission's start");
  assert.deepEqual(called("mission/start")[0].request, {
    mission: "teach",
    session: "taught-1",
    route: "desk to lift",
    lease: "token",
  });
});

test("A name is proposed that is not taken, and what the user writes stays", async () => {
  const name = page.getByRole("textbox", { name: "Learn as" });
  assert.equal(await name.inputValue(), "");
  vehicle.send_state({ keeps_buildings: true });
  await until(async () => (await name.inputValue()) === "building1", "a proposal");
  give_building(vehicle, ["building1"]);
  vehicle.send_state({ mode: "mission", mission: "explore" });
  vehicle.send_state({ mode: "idle", mission: "" });
  await until(async () => (await name.inputValue()) === "building2", "another proposal");
  await name.fill("lab");
  await page.getByRole("button", { name: "Explore" }).click();
  await until(() => called("mission/start").length === 1, "the mission's start");
  assert.equal(called("mission/start")[0].request.building, "lab");
});

test("A click on the plan sends the vehicle to that point, also a second time", async () => {
  give_building(vehicle);
  vehicle.send_state({ mode: "work" });
  vehicle.send_state({ mode: "idle" });
  await page.getByRole("combobox", { name: "Mission" }).selectOption("go");
  await page.locator(".mission-panel option[value=floor]").waitFor({ state: "attached" });
  const plan = page.getByRole("img", { name: /Plan of the building and/ });
  for (const times of [1, 2]) {
    await plan.click();
    await page.getByRole("button", { name: "Go there" }).click();
    await until(() => called("mission/go").length === times, "the call");
    vehicle.send_state({ mode: "mission", mission: "go", driven_by_hand: false });
    await page.getByText("l-corridor: go").waitFor();
    vehicle.send_state({ mode: "idle", mission: "", driven_by_hand: true });
    await page.getByText("l-corridor: waiting").waitFor();
  }
  const { building, x_m, y_m } = called("mission/go")[1].request;
  assert.equal(building, "floor");
  assert.ok(x_m > 0 && x_m < 10 && Math.abs(y_m) < 4, `${x_m}, ${y_m}`);
});

test("The explorer's floor is drawn in the plan", async () => {
  const plan = page.getByRole("img", { name: /Plan of the building and/ });
  const colours = () =>
    plan.evaluate((canvas) => {
      const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
      return new Set(new Uint32Array(data.buffer)).size;
    });
  const before = await colours();
  const floor = { cell_m: 0.5, low_cell: [0, 0], rows: ["8#", "1#6.1#", "8#"] };
  vehicle.publish("/floor", "std_msgs/String", { data: JSON.stringify(floor) });
  await until(async () => (await colours()) >= before + 2, "free and blocked floor");
});

test("The match quality is shown, and detected lines are drawn over the image", async () => {
  const match = { stamp_s: 1, quality: 0.834, text: "41 of 52 lines" };
  vehicle.publish("/match", "std_msgs/String", { data: JSON.stringify(match) });
  await page.locator(".details-panel summary").click();
  await page.getByText("83 % · 41 of 52 lines").waitFor();
  const lines = ["base line", "region", "scan line"].map((kind) => ({ kind, u0: 0, v0: 1, u1: 8, v1: 1 }));
  const data = JSON.stringify({ stamp_s: 1, lines });
  const [header, pixels] = [{ stamp: { sec: 1, nanosec: 0 }, frame_id: "top" }, new Uint8Array(12)];
  const image = { header, height: 3, width: 4, encoding: "mono8", is_bigendian: 0, step: 4, data: pixels };
  vehicle.publish("/camera/top/image_raw", "sensor_msgs/Image", image);
  await page.locator(".camera-panel canvas[data-stamp-s]").waitFor();
  vehicle.publish("/overlay/top", "std_msgs/String", { data });
  for (const kind of ["base line", "region", "scan line"])
    await page.locator(".camera-panel").getByLabel(kind).waitFor();
});

test("A maze drawn with the keyboard is sent to be explored", async () => {
  vehicle.answers["maze/run"] = () => new Error("no engine here");
  await page.getByRole("link", { name: "Maze" }).click();
  await page.getByLabel("Width").fill("2");
  await page.getByLabel("Height").fill("1");
  await page.getByRole("button", { name: "Empty" }).click();
  await page.getByRole("application", { name: /Maze/ }).focus();
  await page.keyboard.press("Shift+ArrowRight");
  await page.keyboard.press("ArrowRight");
  await page.keyboard.press("s");
  await page.getByRole("button", { name: "Explore" }).click();
  await page.getByText("no engine here").waitFor();
  assert.equal(called("maze/run")[0].request.maze, "o---o---o\n|   | S |\no---o---o\n");
});

test("Colours follow the system until the user chooses", async () => {
  const light = await open_page(given.browser, address, desktop_light);
  const theme = () => light.evaluate(() => document.documentElement.dataset.theme);
  assert.equal(await theme(), "light");
  await light.getByRole("button", { name: "Switch to dark colours" }).click();
  await light.reload();
  assert.equal(await theme(), "dark");
  await light.context().close();
});
