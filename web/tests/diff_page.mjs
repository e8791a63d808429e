// usage: node diff_page.mjs RADLINT ROOT
//
// The HTML report of `radlint diff` in a browser: what it says, and two views that one camera moves.
// RAD_SCREENSHOTS=FOLDER keeps pictures of the pages.
import assert from 'node:assert/strict';
import { mkdtemp, readFile, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { launch } from './browser.mjs';
import { opened as openedIn, run, settled } from './opened_page.mjs';

const [RADLINT, ROOT] = process.argv.slice(2).map((word) => path.resolve(word));

let browser;
let folder;

before(async () => {
  browser = await launch();
  folder = await mkdtemp(path.join(tmpdir(), 'rad-diff-'));
});

after(async () => {
  await browser.close();
  await rm(folder, { recursive: true });
});

const opened = (...args) => openedIn(browser, ...args);

// The comparison of two models as a file, and the same as JSON.
async function comparison(name, old, now) {
  const html = path.join(folder, `${name}.html`);
  const json = path.join(folder, `${name}.json`);
  const models = [old, now].map((model) => path.join(ROOT, 'corpus', model));
  await run(RADLINT, 'diff', ...models, '--report', `html=${html}`, '--report', `json=${json}`, '--quiet');
  return { html, json: JSON.parse(await readFile(json, 'utf8')) };
}

const BROKEN = 'models/lamp_post.obj';
const REPAIRED = 'models/lamp_post_repaired.obj';

const pictures = (page) =>
  page.evaluate(() => [...document.querySelectorAll('.canvas canvas')].map((canvas) => canvas.toDataURL()));

for (const [name, old, now] of [['repaired', BROKEN, REPAIRED], ['broken', REPAIRED, BROKEN], ['same', BROKEN, BROKEN]]) {
  test(`${name}: the page says what the JSON says`, async () => {
    const { html, json } = await comparison(name, old, now);
    await opened(
      html,
      async (page) => {
        assert.equal(await page.locator('#verdict').getAttribute('data-verdict'), json.verdict);
        for (const status of ['new', 'changed', 'fixed', 'unchanged']) {
          const count = await page.locator(`.verdict .counts [data-status="${status}"]`).getAttribute('data-count');
          assert.equal(Number(count), json.summary[status], status);
          assert.equal(await page.locator(`.finding[data-status="${status}"]`).count(), json.summary[status], status);
        }
      },
      { picture: `diff_${name}`, fullPage: true },
    );
  });
}

test('both models are shown, by their names', async () => {
  const { html } = await comparison('sides', BROKEN, REPAIRED);
  await opened(html, async (page) => {
    assert.equal(await page.locator('.canvas canvas').count(), 2);
    assert.deepEqual(await page.locator('.canvas .side').allTextContents(), ['Before', 'After']);
    const [before, after] = await pictures(page);
    assert.notEqual(before, after);
  });
});

test('one camera moves both views', async () => {
  const { html } = await comparison('camera', BROKEN, BROKEN);
  await opened(html, async (page) => {
    const first = await pictures(page);
    assert.equal(first[0], first[1], 'the same model from the same place');
    await page.locator('.canvas canvas').first().focus();
    await page.keyboard.press('ArrowRight');
    await settled(page);
    const turned = await pictures(page);
    assert.notEqual(turned[0], first[0]);
    assert.equal(turned[0], turned[1]);
  });
});

test('a click on what is fixed flies to where it was', async () => {
  const { html } = await comparison('fly', BROKEN, REPAIRED);
  await opened(html, async (page) => {
    const whole = await pictures(page);
    const item = page.locator('.finding[data-status="fixed"]:has(.fly:visible)').first();
    await item.locator('.fly').click();
    await settled(page);
    assert.equal(await page.locator('.finding[aria-current="true"]').count(), 1);
    const near = await pictures(page);
    assert.notEqual(near[0], whole[0]);
    assert.notEqual(near[1], whole[1], 'the other side follows');
    await page.keyboard.press('Escape');
    assert.equal(await page.locator('.finding[aria-current]').count(), 0);
  }, { picture: 'diff_fixed' });
});

test('filters leave what is new', async () => {
  const { html, json } = await comparison('filters', REPAIRED, BROKEN);
  await opened(html, async (page) => {
    const shown = () => page.locator('.finding:visible').count();
    assert.equal(await page.locator('.finding[data-status="new"]:visible').count(), json.summary.new);
    await page.locator('.filters input').fill('no finding holds these words');
    assert.equal(await shown(), 0);
    await page.locator('.filters input').fill('');
    assert.ok((await shown()) > 0);
  });
});

test('it can be read without scripts', async () => {
  const { html, json } = await comparison('static', BROKEN, REPAIRED);
  await opened(html, async (page) => {
    assert.ok(await page.locator('#verdict').isVisible());
    assert.equal(await page.locator('.finding[data-status="fixed"]:visible').count(), json.summary.fixed);
    assert.equal(await page.locator('.stage:visible').count(), 0);
  }, { javaScriptEnabled: false });
});
