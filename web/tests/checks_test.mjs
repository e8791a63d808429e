// usage: node --test checks_test.mjs
//
// The two checks of this folder let a sound file pass and name the fault of each faulty one.
import assert from 'node:assert/strict';
import { mkdtemp, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { launch, loadGlb } from './browser.mjs';
import { faulty, sound } from './glb_samples.mjs';
import { validateGlb } from './validator.mjs';

let browser;
let folder;

before(async () => {
  browser = await launch();
  folder = await mkdtemp(path.join(tmpdir(), 'rad-web-'));
});

after(async () => {
  await browser.close();
  await rm(folder, { recursive: true });
});

async function written(bytes) {
  const file = path.join(folder, 'model.glb');
  await writeFile(file, bytes);
  return file;
}

async function browserFinds(bytes, pattern) {
  const { problems } = await loadGlb(browser, await written(bytes));
  assert.ok(problems.some((problem) => pattern.test(problem)), `${pattern} not in ${JSON.stringify(problems)}`);
}

async function validatorFinds(bytes, pattern) {
  const { problems } = await validateGlb(await written(bytes));
  assert.ok(problems.some((problem) => pattern.test(problem)), `${pattern} not in ${JSON.stringify(problems)}`);
}

test('a sound file passes both', async () => {
  const file = await written(sound());
  assert.deepEqual(await validateGlb(file), { problems: [], notes: [] });
  const { problems, summary } = await loadGlb(browser, file);
  assert.deepEqual(problems, []);
  assert.equal(summary.triangles, 4);
  assert.equal(summary.coloured, 1);
  assert.ok(summary.drawn > 0.05 && summary.drawn < 0.9, `drawn ${summary.drawn}`);
  // COLOR_0 is linear 0.8, 0.4, 0.1; these are its sRGB code values.
  const expected = [231, 170, 89];
  summary.commonest.forEach((code, i) => assert.ok(Math.abs(code - expected[i]) <= 2, `shown as ${summary.commonest}`));
});

test('the browser check finds a file that ends early', () => browserFinds(faulty.truncated(), /did not load/));
test('the browser check finds a console error', () => browserFinds(faulty.reachesOut(), /console error.*texture/));
test('the browser check finds a console warning', () => browserFinds(faulty.warns(), /console warning/));
test('the browser check finds that nothing is seen', () => browserFinds(faulty.speck(), /nothing to see/));
test('the browser check finds a request to elsewhere', () =>
  browserFinds(faulty.reachesOut(), /asked for https:\/\/elsewhere\.invalid/));

test('the validator finds colours above 1', () => validatorFinds(faulty.bright(), /ACCESSOR_NON_CLAMPED/));
test('the validator finds positions that are not finite', () =>
  validatorFinds(faulty.notFinite(), /ACCESSOR_INVALID_FLOAT/));
