// HTML reports in a browser, from file:// and without a network.
import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import path from 'node:path';
import { pathToFileURL } from 'node:url';

const VIEWPORT = { width: 1400, height: 900 };

// What radlint writes to standard output; findings are no failure.
export function run(radlint, ...args) {
  return new Promise((resolve, reject) => {
    execFile(radlint, args, { maxBuffer: 1 << 28 }, (error, stdout, stderr) => {
      if (error && ![1, 3].includes(error.code)) reject(new Error(`radlint: ${stderr}`));
      else resolve(stdout);
    });
  });
}

// Opens a report and, with `act`, uses it; then nothing may have gone wrong. RAD_SCREENSHOTS=FOLDER keeps pictures.
export async function opened(browser, file, act, options = {}) {
  const context = await browser.newContext({ viewport: VIEWPORT, reducedMotion: 'reduce', offline: true, ...options });
  const problems = [];
  try {
    const page = await context.newPage();
    page.setDefaultTimeout(60_000);
    page.on('console', (message) => {
      if (['error', 'warning'].includes(message.type())) problems.push(`console ${message.type()}: ${message.text()}`);
    });
    page.on('pageerror', (error) => problems.push(`page error: ${error.message}`));
    const url = pathToFileURL(file).href;
    page.on('request', (request) => {
      if (!request.url().startsWith(url) && !/^(data|blob):/.test(request.url())) problems.push(`asked for ${request.url()}`);
    });
    await page.goto(url);
    if (options.javaScriptEnabled !== false) {
      await page.evaluate(() => (window.radlint ?? window.radfix).ready.then(() => null));
      await settled(page);
    }
    await act(page);
    if (process.env.RAD_SCREENSHOTS && options.picture) {
      await page.screenshot({ path: path.join(process.env.RAD_SCREENSHOTS, `${options.picture}.png`), fullPage: options.fullPage });
    }
  } finally {
    await context.close();
  }
  assert.deepEqual(problems, []);
}

// Two frames on: what was asked for is drawn.
export const settled = (page) =>
  page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => requestAnimationFrame(done)))));
