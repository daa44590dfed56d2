// What an operator needs: to stop and go on, to see what is old, to hear how it ended. With a fake server.
import assert from "node:assert/strict";
import { beforeEach, test } from "node:test";

import { keep_screenshot, until } from "./browser.mjs";
import { open_touch, with_fake_page } from "./fake_page.mjs";

const given = with_fake_page();
const { called } = given;
let vehicle, page;
beforeEach(() => ({ vehicle, page } = given));

const exploring = { mode: "mission", mission: "explore", driven_by_hand: false, keeps_buildings: true };
const held = { ...exploring, paused: true, emergency: true };

async function hold(button) {
  const box = await button.boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  return () => page.mouse.up();
}

/** Whether the plan of the vehicle has a pixel of this colour. */
function has_colour(shown, wanted) {
  return shown.evaluate((rgb) => {
    const canvas = document.querySelector(".stage .plan canvas");
    const { data } = canvas.getContext("2d").getImageData(0, 0, canvas.width, canvas.height);
    for (let at = 0; at < data.length; at += 4)
      if (rgb.every((value, channel) => data[at + channel] === value)) return true;
    return false;
  }, wanted);
}

test("A stopped vehicle goes on only by a long press, of the mouse or of a key", async () => {
  vehicle.send_state(held);
  const resume = page.getByRole("button", { name: "Resume" });
  await resume.click();
  await page.getByRole("button", { name: "Drive from here" }).click();
  await resume.focus();
  await page.keyboard.press("Enter");
  await page.getByText("nobody holds the controls").waitFor();
  assert.deepEqual(called("mission/emergency_release"), []);

  const release = await hold(resume);
  await until(() => called("mission/resume").length === 1, "resumed");
  await release();
  assert.equal(called("mission/emergency_release").length, 1);
  await resume.focus();
  await page.keyboard.down("Enter");
  await until(() => called("mission/resume").length === 2, "resumed by a key");
  await page.keyboard.up("Enter");
});

test("A held exploration is ended, or driven on by hand, and both keep the map", async () => {
  vehicle.send_state(held);
  const release = await hold(page.getByRole("button", { name: "Drive from here" }));
  await until(() => called("mission/emergency_release").length === 1, "the vehicle is free");
  await release();
  assert.equal(called("mission/stop").length, 1);
  await page.getByText("you hold the controls").waitFor();
  await page.getByRole("button", { name: "End and keep the map" }).click();
  await until(() => called("mission/stop").length === 2, "ended");
  assert.ok(called("mission/stop").every(({ request }) => !("discard" in request)));
});

test("Escape in a form holds the vehicle, and shows that it is commanded to stand", async () => {
  await page.locator(".details-panel summary").click();
  const command = { speed_mps: 0.4, steering_rad: 0, turn_rate_rad_s: 0 };
  const data = JSON.stringify({ command, status: "going", state: "exploring", why: "" });
  vehicle.publish("/decision", "std_msgs/String", { data });
  await page.getByText("0.40 m/s").waitFor();
  await page.getByRole("textbox", { name: "Learn as" }).focus();
  await page.keyboard.press("Escape");
  await until(() => called("mission/emergency_stop").length === 1, "the stop");
  vehicle.send_state(held);
  await page.getByText("0.00 m/s: the vehicle is held").waitFor();
  assert.equal(await page.getByText("0.40 m/s").count(), 0);
});

test("What is old is dimmed and says how old it is", async () => {
  const header = { stamp: { sec: 1, nanosec: 0 }, frame_id: "top" };
  const data = new Uint8Array(12);
  const image = { header, height: 3, width: 4, encoding: "mono8", is_bigendian: 0, step: 4, data };
  vehicle.publish("/camera/top/image_raw", "sensor_msgs/Image", image);
  await page.locator(".camera-panel canvas[data-stamp-s]").waitFor();
  vehicle.send_state(exploring);
  await page.getByText(/^This image is \d+ s old$/).waitFor();
  await page.locator(".camera-image.old").first().waitFor();
  vehicle.publish("/camera/top/image_raw", "sensor_msgs/Image", image);
  await page.locator(".camera-panel .camera-image:not(.old)").waitFor();
});

test("The robot's battery is in the status line where it speaks of one, and dimmed when that is old", async () => {
  const battery = page.locator(".status-line .battery");
  assert.equal(await battery.isVisible(), false);
  const say = (charge) =>
    vehicle.publish("/battery", "std_msgs/String", { data: JSON.stringify({ charge }) });
  say(0.764);
  await page.locator(".battery:not(.old)").getByText("battery 76 %").waitFor();
  await keep_screenshot(page, "battery-dark");
  const phone = await open_touch(given, 360, 740);
  say(0.764);
  await phone.getByText("battery 76 %").waitFor();
  await keep_screenshot(phone, "battery-phone");
  await phone.context().close();
  await page.locator(".battery.old").waitFor();
  assert.match(await battery.getAttribute("title"), /^battery 76 %, \d+ s ago$/);
  say(0.5);
  await page.locator(".battery:not(.old)").getByText("battery 50 %").waitFor();
});

test("A failure is told in a sentence with what to do, and stays until it is dismissed", async () => {
  vehicle.send_state(exploring);
  vehicle.send_state({
    mode: "idle",
    mission: "",
    driven_by_hand: true,
    last: { mission: "go", ok: false, text: "", problems: ["place: there is no path to 'desk'"] },
  });
  const told = page.locator(".notice.trouble");
  await told.getByText("Last: go not done. place: there is no path to 'desk'. Choose a place").waitFor();
  await page.getByRole("button", { name: "Close this message" }).click();
  await told.waitFor({ state: "detached" });
  await page.getByRole("button", { name: "Log" }).click();
  await page.getByRole("list", { name: "Messages" }).getByText("Last: go not done.").waitFor();
});

test("The end of a watched mission is no lost connection", async () => {
  vehicle.send_state({ ...exploring, world: "" });
  await page.getByText("explore; nobody").waitFor();
  vehicle.send_state({ mode: "ended", last: { mission: "explore", ok: true, text: "", problems: [] } });
  await page.getByText("Last: explore done.").waitFor();
  const port = Number(new URL(given.address).port);
  await vehicle.stop();
  await page.getByText("explore has ended and its program is gone").waitFor();
  await vehicle.start(port);
});

test("While teaching on a phone, a message covers no mark button", async () => {
  const phone = await open_touch(given, 360, 740);
  await phone.getByRole("button", { name: "Take the controls" }).tap();
  vehicle.send_state({ mode: "mission", mission: "teach", driven_by_hand: true });
  await phone.getByRole("textbox", { name: "Name or number of the mark" }).fill("desk");
  for (const [name, kind] of [
    ["Place", "place"],
    ["Turning begins", "turning begins"],
    ["Route ends", "stop"],
  ]) {
    await phone.getByRole("button", { name, exact: true }).tap();
    await phone.locator(".notices").getByText(`Marked: ${kind}`).waitFor();
  }
  assert.deepEqual(
    called("mission/mark").map(({ request }) => [request.kind, request.label]),
    [
      ["place", "desk"],
      ["turning begins", "desk"],
      ["stop", ""],
    ],
  );
  await phone.context().close();
});

test("A patrol with rounds that are no number is not started", async () => {
  await page.getByRole("combobox", { name: "Mission" }).selectOption("patrol");
  const rounds = page.getByLabel("Rounds");
  await rounds.pressSequentially("abc");
  assert.equal(await rounds.inputValue(), "");
  await rounds.fill("0");
  await page.getByRole("button", { name: "Patrol" }).click();
  assert.equal(await rounds.evaluate((input) => input.validity.rangeUnderflow), true);
  assert.deepEqual(called("mission/start"), []);
});

test("A long list of sessions is sorted by number, and searched", async () => {
  const name = (index) => `a-very-long-name-of-a-run-in-the-corridor-of-the-first-floor-${index}`;
  const entry = (index) => ({ name: name(index), file: `${name(index)}_0.mcap`, bytes: 1, duration_s: 1 });
  let answer;
  vehicle.answers["sessions/list"] = () => ({ sessions: answer });
  answer = [1, 10, 101, 2].map(entry);
  await page.getByRole("link", { name: "Sessions" }).click();
  await page.getByRole("button", { name: name(101), exact: true }).waitFor();
  const names = await page.locator(".sessions-list td:first-child button").allTextContents();
  assert.deepEqual(names, [1, 2, 10, 101].map(name));
  await page.getByLabel("Search").fill("floor-10");
  await until(async () => (await page.locator(".sessions-list td button").count()) === 2, "two rows");
  await page.getByRole("button", { name: name(101), exact: true }).click();
  const link = page.getByRole("link", { name: `${name(101)}_0.mcap` });
  assert.match(await link.getAttribute("href"), /_0\.mcap$/);
});

test("The zoom buttons keep the vehicle in sight", async () => {
  const zeros = new Float64Array(36);
  const position = { x: 9, y: 0, z: 0 };
  const still = { x: 0, y: 0, z: 0 };
  vehicle.publish("/floor", "std_msgs/String", {
    data: JSON.stringify({ cell_m: 0.5, low_cell: [0, -4], rows: Array(8).fill("20.") }),
  });
  vehicle.publish("/odom", "nav_msgs/Odometry", {
    header: { stamp: { sec: 1, nanosec: 0 }, frame_id: "odom" },
    child_frame_id: "base_link",
    pose: { pose: { position, orientation: { ...still, w: 1 } }, covariance: zeros },
    twist: { twist: { linear: still, angular: still }, covariance: zeros },
  });
  const accent = () => has_colour(page, [0x5a, 0xab, 0xff]);
  await until(accent, "the vehicle");
  for (let times = 0; times < 8; times += 1) await page.getByRole("button", { name: "Zoom in" }).click();
  await page.evaluate(() => new Promise(requestAnimationFrame));
  assert.ok(await accent());
});

test("A page that joins late shows what was driven before, and a replay shows it where it jumps to", async () => {
  const points = Array.from({ length: 50 }, (_, index) => [index / 10, 0]);
  vehicle.answers["mission/trail"] = () => ({ points });
  const late = await open_touch(given, 1024, 600);
  await until(() => called("mission/trail").length >= 2, "the trail is asked for");
  await until(() => has_colour(late, [0x3a, 0x6d, 0xa3]), "the trail on the plan");
  await late.context().close();

  const replay = { session: "run", from_s: 0, to_s: 60, at_s: 13.2, playing: false, rate: 1 };
  vehicle.send_state({ mode: "replay", mission: "replay", driven_by_hand: false, replay });
  await page.getByRole("link", { name: "Sessions" }).click();
  const slider = page.getByRole("slider", { name: "Time" });
  await page.getByText("13.2 of 60.0 s").waitFor();
  const asked = called("mission/trail").length;
  const box = await slider.boundingBox();
  await page.mouse.move(box.x + box.width / 2, box.y + box.height / 2);
  await page.mouse.down();
  await until(() => called("replay/seek").length > 0, "a preview before the slider is let go");
  await page.mouse.up();
  await until(() => called("mission/trail").length > asked, "the trail up to there");
});
