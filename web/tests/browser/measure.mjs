// Measures the page: its size, its first load, the delay of an image from the program's server to the screen (640 x 480
// at 30 images/s on loopback), and the server's share of a core. Prints one JSON object.
//   LIVE_PICTURES=build/release/bin/live_images npm run measure
import { spawn } from "node:child_process";
import { readdirSync, statSync } from "node:fs";
import { join } from "node:path";

import { open_browser, open_page, page_directory, until } from "./browser.mjs";

const duration_s = 15;

/** Of the compressed copies, which the server sends. */
function gzip_kb() {
  const files = readdirSync(page_directory, { recursive: true, withFileTypes: true });
  const bytes = files
    .filter((file) => file.isFile() && file.name.endsWith(".gz"))
    .map((file) => statSync(join(file.parentPath ?? file.path, file.name)).size);
  return bytes.reduce((sum, size) => sum + size, 0) / 1000;
}

function median(values) {
  return [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)];
}

/** Records the age of every drawn image at the frame in which it appears. */
function record_delays() {
  window.delays_ms = [];
  const canvas = document.querySelector(".camera-panel canvas");
  const drawn = () => {
    const taken_ms = Number(canvas.dataset.stampS) * 1000;
    requestAnimationFrame(() => window.delays_ms.push(Date.now() - taken_ms));
  };
  new MutationObserver(drawn).observe(canvas, { attributeFilter: ["data-stamp-s"] });
}

const browser = await open_browser();
const server = spawn(process.env.LIVE_PICTURES, [page_directory, String(duration_s)]);
let log = "";
let measured = "";
server.stderr.on("data", (data) => (log += data));
server.stdout.on("data", (data) => (measured += data));
await until(() => /live: (\S+)/.test(log), "the server's address");

const page = await open_page(browser, /live: (\S+)/.exec(log)[1]);
await page.evaluate(record_delays);
const first_load_ms = await page.evaluate(
  () => performance.getEntriesByName("first-contentful-paint")[0]?.startTime,
);
await until(() => page.evaluate(() => window.delays_ms.length > 60), "images");
await page.evaluate(() => (window.delays_ms = [])); // the first ones arrived while the page was still loading
let delays_ms = [];
while (server.exitCode === null) {
  delays_ms = await page.evaluate(() => window.delays_ms);
  await new Promise((resolve) => setTimeout(resolve, 500));
}
await browser.close();

console.log(
  JSON.stringify({
    page_gzip_kb: Number(gzip_kb().toFixed(1)),
    first_contentful_paint_ms: Math.round(first_load_ms),
    pictures_shown: delays_ms.length,
    camera_to_screen_median_ms: Math.round(median(delays_ms)),
    camera_to_screen_largest_ms: Math.round(Math.max(...delays_ms)),
    ...JSON.parse(measured),
  }),
);
