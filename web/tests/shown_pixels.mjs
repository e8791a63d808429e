// Code values that a renderer shows of a GLB, in a headless Chromium.
import path from 'node:path';
import { fileURLToPath } from 'node:url';
import { build } from 'esbuild';
import { openPage } from './browser.mjs';

const HERE = path.dirname(fileURLToPath(import.meta.url));
export const PICTURE = { width: 640, height: 480 };

const scripts = new Map();

// The script of a page with all that it uses of node_modules.
async function script(renderer) {
  if (!scripts.has(renderer)) {
    const { outputFiles } = await build({
      absWorkingDir: HERE,
      entryPoints: [`shown_${renderer}.js`],
      bundle: true,
      format: 'iife',
      target: 'es2022',
      logLevel: 'error',
      write: false,
    });
    scripts.set(renderer, outputFiles[0].text);
  }
  return scripts.get(renderer);
}

const page = `<!doctype html><title>GLB</title><link rel="icon" href="data:,"><style>body { margin: 0; }</style>
<canvas width="${PICTURE.width}" height="${PICTURE.height}"></canvas><script src="/script.js"></script>`;

// Codes [r, g, b] at `points`, pixels from the upper left, and all that went wrong. `view` is what window.show of
// shown_three.js and shown_babylon.js takes.
export async function shownPixels(browser, renderer, model, view, points, { screenshot } = {}) {
  const files = { '/page.html': Buffer.from(page), '/script.js': Buffer.from(await script(renderer)) };
  return openPage(browser, { model, files, viewport: PICTURE }, async (opened) => {
    const codes = await opened.evaluate(([how, where]) => window.show(how, where), [view, points]);
    if (screenshot) await opened.screenshot({ path: screenshot });
    return codes;
  });
}
