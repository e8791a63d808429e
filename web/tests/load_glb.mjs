// usage: node load_glb.mjs [--screenshot] FILE.glb…
//
// Loads each file in three.js in a headless Chromium. Exits 1 where the console showed an error or a warning, the page
// asked for anything but its own files, or nothing was drawn. --screenshot writes FILE.glb.png beside each file.
import { launch, loadGlb } from './browser.mjs';

const files = process.argv.slice(2).filter((argument) => argument !== '--screenshot');
const wantsScreenshot = process.argv.includes('--screenshot');
if (files.length === 0) {
  console.error('usage: node load_glb.mjs [--screenshot] FILE.glb…');
  process.exit(2);
}

const browser = await launch();
let failed = 0;
for (const file of files) {
  const { problems, summary } = await loadGlb(browser, file, { screenshot: wantsScreenshot && `${file}.png` });
  console.log(`${problems.length ? 'FAIL' : 'ok'} ${file} ${JSON.stringify(summary)}`);
  for (const problem of problems) console.log(`  ${problem}`);
  if (problems.length) ++failed;
}
await browser.close();
process.exit(failed ? 1 : 0);
