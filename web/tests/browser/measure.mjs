// Measures the page: its size, its first load, and how long a picture takes from a server to the screen, 640 x 480 at
// 30 a second on loopback. Prints one JSON object.
//   npm run measure
import { readdirSync, readFileSync } from "node:fs";
import { join } from "node:path";
import { gzipSync } from "node:zlib";

import { open_browser, open_page, page_directory } from "./browser.mjs";
import { FakeVehicle } from "./fake_vehicle.mjs";

const pictures = 300;
const period_ms = 1000 / 30;

function gzip_kb() {
  const files = readdirSync(page_directory, { recursive: true, withFileTypes: true }).filter((file) =>
    file.isFile(),
  );
  const bytes = files.map(
    (file) => gzipSync(readFileSync(join(file.parentPath ?? file.path, file.name))).length,
  );
  return bytes.reduce((sum, size) => sum + size, 0) / 1000;
}

/** A JPEG with as much in it as a corridor has. */
function jpeg(page) {
  return page.evaluate(async () => {
    const canvas = new OffscreenCanvas(640, 480);
    const context = canvas.getContext("2d");
    for (let stripe = 0; stripe < 400; stripe += 1) {
      context.fillStyle = `hsl(${(stripe * 37) % 360} 20% ${(stripe * 13) % 100}%)`;
      context.fillRect((stripe * 53) % 640, (stripe * 29) % 480, 90, 70);
    }
    const blob = await canvas.convertToBlob({ type: "image/jpeg", quality: 0.9 });
    return [...new Uint8Array(await blob.arrayBuffer())];
  });
}

function median(values) {
  return [...values].sort((a, b) => a - b)[Math.floor(values.length / 2)];
}

const browser = await open_browser();
const vehicle = new FakeVehicle(page_directory);
const address = await vehicle.start();
const page = await open_page(browser, address);
await page.getByText("l-corridor").waitFor();
const first_load_ms = await page.evaluate(
  () => performance.getEntriesByName("first-contentful-paint")[0].startTime,
);

await page.evaluate(() => {
  window.delays_ms = [];
  const canvas = document.querySelector(".camera-panel canvas");
  const drawn = () => {
    const taken_ms = Number(canvas.dataset.stampS) * 1000;
    requestAnimationFrame(() => window.delays_ms.push(Date.now() - taken_ms));
  };
  new MutationObserver(drawn).observe(canvas, { attributeFilter: ["data-stamp-s"] });
});
const data = Uint8Array.from(await jpeg(page));
for (let picture = 0; picture < pictures; picture += 1) {
  const now_ms = Date.now();
  const stamp = { sec: Math.floor(now_ms / 1000), nanosec: (now_ms % 1000) * 1e6 };
  const header = { stamp, frame_id: "front_optical" };
  vehicle.publish("/camera/front/image_raw/compressed", "sensor_msgs/CompressedImage", {
    header,
    format: "jpeg",
    data,
  });
  await new Promise((resolve) => setTimeout(resolve, period_ms));
}
const delays_ms = await page.evaluate(() => window.delays_ms);
await browser.close();
await vehicle.stop();

console.log(
  JSON.stringify({
    page_gzip_kb: Number(gzip_kb().toFixed(1)),
    first_contentful_paint_ms: Math.round(first_load_ms),
    picture_bytes: data.length,
    pictures_shown: delays_ms.length,
    camera_to_screen_median_ms: median(delays_ms),
    camera_to_screen_largest_ms: Math.max(...delays_ms),
  }),
);
