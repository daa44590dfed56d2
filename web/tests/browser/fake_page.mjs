// What the tests with a fake vehicle begin with: a browser, the vehicle, and a page that is connected to it.
import assert from "node:assert/strict";
import { after, afterEach, before, beforeEach } from "node:test";

import { open_browser, open_page, page_directory } from "./browser.mjs";
import { FakeVehicle } from "./fake_vehicle.mjs";

/** @returns an object whose members are there in each test: browser, vehicle, address, page, called(service) */
export function with_fake_page() {
  const given = { called: (name) => given.vehicle.calls.filter((call) => call.name === name) };
  before(async () => (given.browser = await open_browser()));
  after(() => given.browser.close());
  beforeEach(async () => {
    const vehicle = new FakeVehicle(page_directory);
    vehicle.answers["lease/take"] = () => ({ lease: "token", valid_s: 3 });
    vehicle.answers["lease/renew"] = () => ({ valid_s: 3 });
    vehicle.answers["buildings/list"] = () => ({ buildings: [] });
    vehicle.answers["sessions/list"] = () => ({ sessions: [] });
    vehicle.answers["mission/trail"] = () => ({ points: [] });
    vehicle.answers["mission/events"] = ({ from }) => ({ from, events: [] });
    given.vehicle = vehicle;
    given.address = await vehicle.start();
    given.page = await open_page(given.browser, given.address);
    await given.page.getByText("l-corridor: waiting").waitFor();
  });
  afterEach(async () => {
    const { errors } = given.page;
    await given.page.context().close();
    await given.vehicle.stop();
    assert.deepEqual(errors, []);
  });
  return given;
}

/** A page of the given size with touch, connected to the same vehicle. */
export async function open_touch(given, width, height) {
  const page = await open_page(given.browser, given.address, {
    viewport: { width, height },
    hasTouch: true,
    isMobile: true,
    colorScheme: "dark",
  });
  await page.getByText("l-corridor: ").first().waitFor();
  return page;
}

/** A building of two walls with a floor, under the name `floor`. */
export function give_building(vehicle, names = ["floor"]) {
  vehicle.answers["buildings/list"] = () => ({ buildings: names.map((name) => ({ name })) });
  for (const name of names)
    vehicle.files[`/buildings/${name}.json`] = {
      format: "aisle.building",
      version: 1,
      walls: [
        { start_m: [0, 0], end_m: [10, 0] },
        { start_m: [5, 3], end_m: [5, -3] },
      ],
      places: [{ name: "desk", at_m: [2, 1] }],
      floor: { cell_m: 0.5, low_cell: [0, -8], rows: Array(16).fill("20.") },
    };
}
