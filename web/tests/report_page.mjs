// usage: node report_page.mjs RADLINT ROOT
//
// The HTML report of radlint in a browser, from file:// and without a network: what it says, shows and lets a user do.
// RAD_SCREENSHOTS=FOLDER keeps pictures of the pages.
import assert from 'node:assert/strict';
import { mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { launch } from './browser.mjs';
import { opened as openedIn, run, settled } from './opened_page.mjs';

const [RADLINT, ROOT] = process.argv.slice(2).map((word) => path.resolve(word));
const SIGN_REACH = 5; // pixels around a sign's middle that have its colour

let browser;
let folder;

before(async () => {
  browser = await launch();
  folder = await mkdtemp(path.join(tmpdir(), 'rad-report-'));
});

after(async () => {
  await browser.close();
  await rm(folder, { recursive: true });
});

const radlint = (...args) => run(RADLINT, ...args);
const opened = (...args) => openedIn(browser, ...args);

// The report of some models as a file, and the same as JSON.
async function report(name, models, ...options) {
  const html = path.join(folder, `${name}.html`);
  const json = path.join(folder, `${name}.json`);
  await radlint(...models, '--report', `html=${html}`, '--report', `json=${json}`, '--quiet', ...options);
  return { html, json: JSON.parse(await readFile(json, 'utf8')) };
}

const corpus = (name) => path.join(ROOT, 'corpus', name);

// The colour of the canvas around a place, in CSS pixels of it.
async function colourAt(page, { x, y }) {
  return page.evaluate(
    ([left, top]) => {
      const canvas = document.querySelector('.canvas canvas');
      const copy = document.createElement('canvas');
      const ratio = canvas.width / canvas.clientWidth;
      copy.width = copy.height = 1;
      copy.getContext('2d').drawImage(canvas, left * ratio, top * ratio, 1, 1, 0, 0, 1, 1);
      return [...copy.getContext('2d').getImageData(0, 0, 1, 1).data.slice(0, 3)];
    },
    [x, y],
  );
}

const canvasBytes = (page) => page.evaluate(() => document.querySelector('.canvas canvas').toDataURL());

const markColour = (page, severity) =>
  page.evaluate((name) => {
    const text = getComputedStyle(document.documentElement).getPropertyValue(`--mark-${name}`).trim();
    return [1, 3, 5].map((at) => parseInt(text.slice(at, at + 2), 16));
  }, severity);

const near = (a, b) => a.every((code, i) => Math.abs(code - b[i]) <= 24);

// Where the first place of a fault is seen.
const seenAt = (page, model, fault) =>
  page.evaluate(
    ([m, f]) => {
      const stage = window.radlint.stage();
      const { points, lines } = stage.views.get(m).faults[f];
      return points.length
        ? stage.project(...points.slice(0, 3))
        : stage.project(...[0, 1, 2].map((axis) => (lines[axis] + lines[axis + 3]) / 2));
    },
    [model, fault],
  );

async function choose(page, id) {
  await page.evaluate((name) => window.radlint.choose(document.getElementById(name)), id);
  await settled(page);
}

const MODELS = ['models/lamp_post.obj', 'rules/RL201-t-vertex/fail.obj', 'rules/RL210-implicit-intersection/fail.obj', 'rules/RL102-nonmanifold-edge/fail.obj'];

for (const model of MODELS) {
  const name = model.replaceAll('/', '_');
  test(`${model}: the page says what the JSON report says`, async () => {
    const { html, json } = await report(name, [corpus(model)]);
    await opened(
      html,
      async (page) => {
        const { errors, warnings, notes } = json.summary;
        assert.equal(await page.locator('#verdict').getAttribute('data-verdict'), json.verdict);
        for (const [severity, count] of Object.entries({ error: errors, warning: warnings, note: notes })) {
          assert.equal(await page.locator(`.verdict .counts .${severity}`).getAttribute('data-count'), String(count));
          assert.equal(await page.locator(`.finding[data-severity="${severity}"]`).count(), count);
        }
        for (const [rule, { findings }] of Object.entries(json.summary.byRule)) {
          assert.equal(await page.locator(`.finding[data-rule="${rule}"]`).count(), findings, rule);
        }
        const statuses = await page.locator('.requirements td[data-status]').evaluateAll((cells) => cells.map((c) => c.dataset.status));
        assert.deepEqual(statuses, Object.values(json.summary.requirements).map(({ status }) => status));
        const fingerprints = await page.locator('.finding').evaluateAll((items) => items.map((i) => i.dataset.fingerprint));
        assert.deepEqual(fingerprints, json.findings.map(({ fingerprint }) => fingerprint));
        const held = await page.locator('#report').evaluate((script) => JSON.parse(script.textContent));
        assert.deepEqual(held, json);
      },
      { picture: name, fullPage: true },
    );
  });

  test(`${model}: every fault with a place is drawn where it is`, async () => {
    const { html, json } = await report(name, [corpus(model)]);
    let drawn = 0;
    await opened(html, async (page) => {
      for (let i = 0; i < json.findings.length; ++i) {
        const { where, severity } = json.findings[i];
        if (!where.point && !where.segment) continue;
        await choose(page, `f-0-${i}`);
        const at = await seenAt(page, 0, i);
        assert.ok(at, `finding ${i} is behind the camera`);
        const wanted = await markColour(page, severity);
        const seen = await Promise.all([0, -SIGN_REACH, SIGN_REACH].map((dx) => colourAt(page, { x: at.x + dx / 2, y: at.y })));
        assert.ok(seen.some((colour) => near(colour, wanted)), `finding ${i} at ${JSON.stringify(at)}: ${JSON.stringify(seen)}, not ${wanted}`);
        ++drawn;
      }
    });
    assert.ok(drawn > 0);
  });
}

test('a click on a fault chooses its finding, a click on a finding shows its fault', async () => {
  const { html } = await report('click', [corpus('rules/RL201-t-vertex/fail.obj')]);
  await opened(
    html,
    async (page) => {
      const at = await seenAt(page, 0, 0);
      await page.locator('.canvas canvas').click({ position: at });
      await page.waitForSelector('#f-0-0[aria-current="true"]');
      await page.keyboard.press('Escape');
      assert.equal(await page.locator('[aria-current]').count(), 0);
      const before = await canvasBytes(page);
      await page.locator('#f-0-0 .fly').click();
      await settled(page);
      assert.equal(await page.locator('#f-0-0[aria-current="true"]').count(), 1);
      assert.notEqual(await canvasBytes(page), before);
    },
    { picture: 'chosen' },
  );
});

test('filters hide findings and their marks', async () => {
  const { html, json } = await report('filters', [corpus('models/lamp_post.obj')]);
  await opened(html, async (page) => {
    const shown = () => page.locator('.finding:visible').count();
    const all = json.findings.length;
    assert.equal(await shown(), all);
    const whole = await canvasBytes(page);
    await page.locator('.toggle[data-severity="error"]').click();
    await settled(page);
    assert.equal(await shown(), all - json.summary.errors);
    assert.notEqual(await canvasBytes(page), whole);
    await page.locator('.toggle[data-severity="error"]').click();
    const rule = json.findings[0].rule;
    await page.getByLabel('Rule').selectOption(rule);
    assert.equal(await shown(), json.summary.byRule[rule].findings);
    await page.getByLabel('Rule').selectOption('');
    const word = json.findings[0].where.file.split('/').pop();
    await page.locator('.filters input').fill(`${word}:${json.findings[0].where.line}`);
    assert.ok((await shown()) >= 1 && (await shown()) < all);
    assert.equal(await page.locator('.filters output').textContent(), `${await shown()} of ${all} findings`);
  });
});

test('the keyboard reaches everything', async () => {
  const { html } = await report('keys', [corpus('models/lamp_post.obj')]);
  await opened(html, async (page) => {
    const focused = () => page.evaluate(() => document.activeElement.id || document.activeElement.className || document.activeElement.tagName);
    await page.keyboard.press('Tab');
    assert.equal(await focused(), 'skip');
    const unseen = new Set(['BUTTON', 'SELECT', 'INPUT', 'LI', 'CANVAS']);
    for (let i = 0; i < 400 && unseen.size > 0; ++i) {
      await page.keyboard.press('Tab');
      unseen.delete(await page.evaluate(() => document.activeElement.tagName));
    }
    assert.deepEqual([...unseen], [], 'not reached');
    await page.locator('.canvas canvas').focus();
    const before = await canvasBytes(page);
    await page.keyboard.press('ArrowRight');
    await settled(page);
    assert.notEqual(await canvasBytes(page), before);
    await page.keyboard.press('j');
    await settled(page);
    assert.equal(await focused(), 'f-0-0');
    await page.keyboard.press('j');
    await settled(page);
    assert.equal(await page.locator('#f-0-1[aria-current="true"]').count(), 1);
    await page.keyboard.press('ArrowUp');
    assert.equal(await focused(), 'f-0-0');
    await page.keyboard.press('Enter');
    await settled(page);
    assert.equal(await page.locator('#f-0-0[aria-current="true"]').count(), 1);
    await page.keyboard.press('/');
    assert.equal(await focused(), 'INPUT');
    await page.keyboard.press('Escape');
    assert.equal(await page.locator('[aria-current]').count(), 0);
  });
});

for (const [width, height] of [[1400, 900], [800, 600]]) {
  test(`the model is seen without scrolling at ${width} × ${height}`, async () => {
    const { html } = await report(`first_screen_${width}`, [corpus('models/lamp_post.obj')]);
    await opened(
      html,
      async (page) => {
        const canvas = await page.locator('.canvas').boundingBox();
        assert.ok(canvas.y < height / 2 + 50, `the view begins at ${canvas.y}`);
        const verdict = await page.locator('#verdict').boundingBox();
        assert.ok(verdict.y + verdict.height < height);
        assert.equal(await page.evaluate(() => document.documentElement.scrollWidth > innerWidth), false, 'wider than the window');
      },
      { viewport: { width, height }, picture: `first_screen_${width}` },
    );
  });
}

test('what is only counted is told from what is listed', async () => {
  const { html, json } = await report('short', [corpus('rules/RL201-t-vertex/fail.obj'), corpus('models/lamp_post.obj')], '--no-group', '--max-issues', '1');
  const { errors, warnings, notes } = json.summary;
  await opened(html, async (page) => {
    const listed = await page.locator('.finding[data-severity="error"]').count();
    assert.ok(listed < errors);
    assert.equal(await page.locator('.toggle.error').textContent(), `Errors ${listed} of ${errors}`);
    const all = await page.locator('.finding').count();
    assert.equal(await page.locator('.filters .tally').textContent(), `${all} of ${all} listed, ${errors + warnings + notes} found`);
  });
});

test('it can be read without scripts, by pictures', async () => {
  const { html, json } = await report('static', [corpus('models/lamp_post.obj')]);
  await opened(
    html,
    async (page) => {
      assert.ok(await page.locator('#verdict').isVisible());
      assert.ok(await page.locator('.overview img').isVisible());
      assert.equal(await page.locator('.finding:visible').count(), json.findings.length);
      assert.ok((await page.locator('.thumb:visible').count()) > 0);
      for (const gone of ['.filters', '.stage', '.fly']) assert.equal(await page.locator(`${gone}:visible`).count(), 0, gone);
    },
    { javaScriptEnabled: false, picture: 'without_scripts', fullPage: true },
  );
});

test('on paper there are pictures instead of the view', async () => {
  const { html } = await report('print', [corpus('rules/RL201-t-vertex/fail.obj')]);
  await opened(html, async (page) => {
    await page.emulateMedia({ media: 'print' });
    assert.ok(await page.locator('.overview img').isVisible());
    assert.equal(await page.locator('.stage:visible').count(), 0);
  });
});

test('it follows a dark scheme', async () => {
  const { html } = await report('dark', [corpus('models/lamp_post.obj')]);
  await opened(
    html,
    async (page) => {
      const background = await page.evaluate(() => getComputedStyle(document.body).backgroundColor);
      assert.ok(background.match(/\d+/g).slice(0, 3).every((code) => Number(code) < 60), background);
      assert.ok((await colourAt(page, { x: 3, y: 3 })).every((code) => code < 80));
    },
    { colorScheme: 'dark', picture: 'dark' },
  );
});

test('several files have sections of their own', async () => {
  const models = MODELS.map(corpus);
  const { html, json } = await report('several', models);
  await opened(
    html,
    async (page) => {
      assert.equal(await page.locator('section.model').count(), models.length);
      assert.equal(await page.locator('table.files tbody tr').count(), models.length);
      assert.equal(await page.locator('.finding').count(), json.findings.length);
      const last = models.length - 1;
      await page.locator(`.finding[data-model="${last}"] .fly`).first().click();
      await page.waitForFunction((model) => window.radlint.stage().current === model, last);
    },
    { picture: 'several', fullPage: true },
  );
});

test('a clean model is said to be clean', async () => {
  const { html } = await report('clean', [corpus('rules/RL201-t-vertex/pass.obj')], '--select', 'RL201');
  await opened(html, async (page) => {
    assert.equal(await page.locator('#verdict').getAttribute('data-verdict'), 'pass');
    assert.ok(await page.locator('.clean').isVisible());
    assert.ok(await page.locator('.canvas canvas').isVisible());
  }, { picture: 'clean' });
});

const HOSTILE = '</script><img src=x onerror=alert(1)>"\'&amp;\u2028\u2029<!--<script>';

test('names of files, objects and materials stay names', async () => {
  const model = path.join(folder, 'hostile <b>&"\' .obj');
  const square = ['v 0 0 0', 'v 1 0 0', 'v 1 1 0', 'v 0 1 0', 'v .5 0 0', 'v .5 -1 0', 'v 1 -1 0'];
  const name = HOSTILE.replaceAll(' ', '\u00a0');
  await writeFile(model, [...square, `o ${name}`, `usemtl ${name}`, 'f 1 2 3 4', 'f 5 6 7 2', ''].join('\n'));
  const { html, json } = await report('hostile', [model]);
  await opened(html, async (page) => {
    assert.equal(await page.locator('img[src="x"]').count(), 0);
    assert.equal(await page.locator('h1').textContent(), model);
    const fault = json.findings.findIndex(({ where }) => where.objects.length);
    const wanted = json.findings[fault].where.objects[0];
    assert.ok(wanted.startsWith('</script>'), wanted);
    // What is read is one line of text, as in every report; what programs read is the name itself.
    assert.ok((await page.locator(`#f-0-${fault} .facts`).textContent()).includes(wanted.replaceAll(/[\u2028\u2029]/g, ' ')));
    const held = await page.locator('#report').evaluate((script) => JSON.parse(script.textContent));
    assert.equal(held.findings[fault].where.objects[0], name);
  });
});

test('the same input gives the same bytes, whatever the number of threads', async () => {
  const models = [corpus('models/lamp_post.obj')];
  const pages = [];
  for (const jobs of ['1', '2']) pages.push(await readFile((await report(`jobs${jobs}`, models, '--jobs', jobs)).html, 'utf8'));
  assert.equal(pages[0], pages[1]);
});

test('a large model stays small and opens soon', { skip: !process.env.RAD_SHARED && 'RAD_SHARED is not set' }, async () => {
  const model = path.join(process.env.RAD_SHARED, 'corpus/arch-large/breakfast_room.obj');
  const { html } = await report('large', [model]);
  const { size } = await (await import('node:fs/promises')).stat(html);
  assert.ok(size < 15e6, `${size} bytes`);
  const start = performance.now();
  let taken;
  await opened(html, async (page) => {
    await page.waitForFunction(() => window.radlint.stage().current === 0);
    taken = (performance.now() - start) / 1000;
  }, { picture: 'large' });
  console.log(`breakfast_room: ${(size / 1e6).toFixed(1)} MB, shown after ${taken.toFixed(1)} s`);
  assert.ok(taken < 10, `${taken} s`);
});
