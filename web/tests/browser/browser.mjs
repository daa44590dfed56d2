// A real browser for the tests: pages that report their own errors, and screenshots.
import assert from "node:assert/strict";
import { mkdirSync } from "node:fs";
import { join } from "node:path";
import { chromium } from "playwright-core";

export const page_directory = new URL("../../dist", import.meta.url).pathname;

export const desktop = { viewport: { width: 1280, height: 800 }, colorScheme: "dark" };
export const desktop_light = { ...desktop, colorScheme: "light" };
export const phone = {
  viewport: { width: 360, height: 740 },
  colorScheme: "dark",
  hasTouch: true,
  isMobile: true,
};

/** What takes longer hangs, on a slow machine with other work, too. */
const hang_ms = 60000;

export function open_browser() {
  return chromium.launch({
    executablePath: process.env.AISLE_BROWSER ?? "/usr/bin/chromium",
    args: ["--no-sandbox"],
  });
}

/** Opens a page in a context of its own; its errors are collected in `page.errors`. */
export async function open_page(browser, address, options = desktop) {
  const context = await browser.newContext(options);
  const page = await context.newPage();
  page.setDefaultTimeout(hang_ms);
  page.errors = [];
  page.on("pageerror", (error) => page.errors.push(error.message));
  await page.goto(address);
  return page;
}

/** Closes a page, on which no script may have failed. */
export async function close_page(page) {
  await page.context().close();
  assert.deepEqual(page.errors, []);
}

/** Saves a screenshot in the directory AISLE_PICTURES, if that is set. */
export async function keep_screenshot(page, name, options = {}) {
  const directory = process.env.AISLE_PICTURES;
  if (!directory) return;
  mkdirSync(directory, { recursive: true });
  await page.screenshot({ path: join(directory, `${name}.png`), ...options });
}

/** Polls `condition` in the test's own process until it is true. @throws Error at the time-out */
export async function until(condition, what, timeout_ms = hang_ms) {
  const end_ms = performance.now() + timeout_ms;
  while (!(await condition())) {
    if (performance.now() > end_ms) throw new Error(`timed out waiting for: ${what}`);
    await new Promise((resolve) => setTimeout(resolve, 10));
  }
}
