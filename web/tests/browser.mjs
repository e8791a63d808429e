// A headless Chromium that sees the files of one page and nothing else of the world.
import { existsSync } from 'node:fs';
import { readFile } from 'node:fs/promises';
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { chromium } from 'playwright-core';

const HERE = path.dirname(fileURLToPath(import.meta.url));
const ORIGIN = 'http://page.invalid';
const TYPES = { '.html': 'text/html', '.js': 'text/javascript', '.wasm': 'application/wasm' };
const TIMEOUT_MS = 120_000;

function chromiumPath() {
  const named = process.env.RAD_CHROMIUM;
  const places = named ? [named] : (process.env.PATH ?? '').split(path.delimiter).map((p) => path.join(p, 'chromium'));
  const found = places.find((place) => existsSync(place));
  if (!found) throw new Error('no chromium in PATH; install the Debian package chromium or set RAD_CHROMIUM');
  return found;
}

export function launch() {
  return chromium.launch({
    executablePath: chromiumPath(),
    args: ['--no-sandbox', '--use-angle=swiftshader', '--enable-unsafe-swiftshader', '--host-resolver-rules=MAP * ~NOTFOUND'],
  });
}

// What a URL of the page stands for: bytes, or a path; null for all that the page must not ask for.
function contentOf(url, { model, files = {} }) {
  const { origin, pathname } = new URL(url);
  if (origin !== ORIGIN) return null;
  if (pathname in files) return files[pathname];
  if (pathname === '/model') return model;
  if (pathname === '/page.html' || pathname === '/page.js') return path.join(HERE, pathname);
  const inside = path.normalize(decodeURIComponent(pathname));
  return inside.startsWith('/node_modules/three/') ? path.join(HERE, '..', inside) : null;
}

async function answer(route, content, problems) {
  const url = route.request().url();
  const found = contentOf(url, content);
  if (!found || (typeof found === 'string' && !existsSync(found))) {
    problems.push(`asked for ${url}`);
    return route.abort();
  }
  const contentType = TYPES[path.extname(new URL(url).pathname)] ?? 'application/octet-stream';
  return route.fulfill({ body: typeof found === 'string' ? await readFile(found) : found, contentType });
}

// Opens a page that sees `model` as /model, `files` (bytes by path) and what the page of this folder needs, and nothing
// else. Returns { problems, result }: all that went wrong, in words, and what `act(page, problems)` gives.
export async function openPage(browser, { viewport, ...content }, act) {
  const problems = [];
  const context = await browser.newContext({ viewport });
  try {
    const page = await context.newPage();
    page.setDefaultTimeout(TIMEOUT_MS);
    page.on('console', (message) => {
      if (['error', 'warning'].includes(message.type())) problems.push(`console ${message.type()}: ${message.text()}`);
    });
    page.on('pageerror', (error) => problems.push(`page error: ${error.message}`));
    await page.route('**/*', (route) => answer(route, content, problems));
    await page.goto(`${ORIGIN}/page.html`);
    return { problems, result: await act(page, problems) };
  } finally {
    await context.close();
  }
}

// Loads one GLB in three.js. Returns { problems, summary }: everything that went wrong, in words, and what was drawn.
export async function loadGlb(browser, model, { screenshot } = {}) {
  const viewport = { width: 640, height: 480 };
  const { problems, result } = await openPage(browser, { model, viewport }, async (page, found) => {
    const summary = await page.evaluate(() => window.shown.catch((error) => ({ failed: String(error) })));
    if (!summary) found.push('the page did not run');
    else if (summary.failed) found.push(`did not load: ${summary.failed}`);
    else if (!summary.enough) found.push(`nothing to see: ${(summary.drawn * 100).toFixed(2)} % of the pixels`);
    if (screenshot) await page.screenshot({ path: screenshot });
    return summary;
  });
  return { problems, summary: result };
}
