// usage: node viewer_page.mjs RADFIX ROOT
//
// The page of a solution in a browser: what it shows beside the solution, exposure, curve, false colours, mesh, keys.
// RAD_SCREENSHOTS=FOLDER keeps pictures of it.
import assert from 'node:assert/strict';
import { mkdtemp, readFile, rm } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { launch } from './browser.mjs';
import { opened as openedIn, run } from './opened_page.mjs';
import { mixed, Sight } from './sight.mjs';
import { writtenGlb } from './written_glb.mjs';

const [RADFIX, ROOT] = process.argv.slice(2).map((word) => path.resolve(word));
const MODEL = path.join(ROOT, 'corpus/models/lamp_post_repaired.obj');
const CODES = 3; // half floats, and places on a grid of 2^20 steps
// The page and the GLB may cut a quadrilateral along different diagonals: where a shadow ends within it, this share differs.
const BEYOND = 0.03;

let browser, folder, html, glb;
before(async () => {
  browser = await launch();
  folder = await mkdtemp(path.join(tmpdir(), 'rad-viewer-'));
  [html, glb] = ['html', 'glb'].map((kind) => path.join(folder, `lit.${kind}`));
  await run(RADFIX, MODEL, '-o', glb, '--solve', '--patch-size', '0.8', '--viewer', html);
});
after(async () => {
  await browser.close();
  await rm(folder, { recursive: true });
});

const viewer = (act, options) =>
  openedIn(browser, html, async (page) => {
    await page.waitForFunction(() => window.radfix);
    await page.evaluate(async () => ((window.viewer = await window.radfix.ready), null));
    await act(page);
  }, options);

const srgb = (linear) => 255 * (linear <= 0.0031308 ? 12.92 * linear : 1.055 * linear ** (1 / 2.4) - 0.055);

// Codes of the canvas at CSS pixels.
const pixels = (page, points) =>
  page.evaluate((where) => {
    const { canvas, renderer, scene, camera } = window.viewer.stage;
    renderer.render(scene, camera);
    const gl = renderer.getContext();
    const code = new Uint8Array(4);
    return where.map(([x, y]) => {
      gl.readPixels(x, canvas.height - 1 - y, 1, 1, gl.RGBA, gl.UNSIGNED_BYTE, code);
      return [...code.subarray(0, 3)];
    });
  }, points);

// The camera of the page in the places of the model, and the size of its canvas.
async function seenFrom(page, { triangles }) {
  const low = [0, 1, 2].map((axis) => triangles.reduce((least, { corners }) => Math.min(least, ...corners.map((c) => c.position[axis])), Infinity));
  const size = Math.max(...[0, 1, 2].map((axis) => triangles.reduce((most, { corners }) => Math.max(most, ...corners.map((c) => c.position[axis] - low[axis])), 0)));
  const { position, target, up, fov, width, height } = await page.evaluate(() => {
    const { camera, controls, canvas } = window.viewer.stage;
    return { position: camera.position.toArray(), target: controls.target.toArray(), up: camera.up.toArray(), fov: camera.fov, width: canvas.width, height: canvas.height };
  });
  const place = (p) => p.map((value, axis) => low[axis] + ((value + 1) / 2) * size);
  return [{ position: place(position), target: place(target), up, fieldOfView: fov }, { width, height }];
}

test('what is shown is the solution, exposed', () =>
  viewer(async (page) => {
    const model = await writtenGlb(glb);
    const [camera, picture] = await seenFrom(page, model);
    const sight = new Sight(model.triangles, camera, picture);
    const points = [];
    for (let y = 15; y < picture.height; y += 30) {
      for (let x = 15; x < picture.width; x += 30) {
        const hit = sight.at(x, y, 1);
        if (hit) points.push({ at: [x, y], b: mixed(hit, 'radiosity') });
      }
    }
    assert.ok(points.length > 100, `${points.length} points`);
    const codes = await pixels(page, points.map(({ at }) => at));
    const off = points.map(({ b }, i) =>
      Math.max(...b.map((value, channel) => Math.abs(codes[i][channel] - srgb(Math.min(1, model.record.exposure * value))))));
    const beyond = off.filter((codes) => codes > CODES);
    console.log(`${points.length} points, ${beyond.length} of them off by more than ${CODES} codes: ${beyond.map((codes) => codes.toFixed(1))}`);
    assert.ok(beyond.length <= BEYOND * points.length, `${beyond.length} points`);
    const read = await page.evaluate(([x, y]) => window.viewer.radiosityAt(x + 0.5, y + 0.5), points[50].at);
    read.forEach((value, i) => assert.ok(Math.abs(value / points[50].b[i] - 1) < 0.02, `${read} and not ${points[50].b}`));
  }, { picture: 'viewer' }));

test('exposure, curve and false colours change what is seen', () =>
  viewer(async (page) => {
    const middle = async () => {
      const { width, height } = await page.evaluate(() => ({ width: window.viewer.stage.canvas.width, height: window.viewer.stage.canvas.height }));
      return (await pixels(page, [[width >> 1, Math.round(height * 0.6)]]))[0];
    };
    const first = await middle();
    await page.locator('#exposure').fill('-2');
    const darker = await middle();
    assert.ok(darker[1] < first[1] - 10, `${first} ${darker}`);
    await page.getByRole('button', { name: 'Reset' }).click();
    assert.deepEqual(await middle(), first);
    await page.locator('#curve').selectOption('reinhard');
    assert.notDeepEqual(await middle(), first);
    assert.ok(await page.locator('.legend').isHidden());
    await page.getByRole('button', { name: 'False colours' }).click();
    assert.ok(await page.locator('.legend').isVisible());
    assert.notDeepEqual(await middle(), first);
    const top = await page.locator('.legend .ticks span').first().textContent();
    const exposure = await page.evaluate(() => window.viewer.exposure);
    assert.ok(Math.abs(Number(top) * exposure - 1) < 0.01, top);
  }, { picture: 'viewer_false_colours' }));

test('the mesh lies over it, and keys turn it', () =>
  viewer(async (page) => {
    const shot = () => page.evaluate(() => (window.viewer.stage.renderer.render(window.viewer.stage.scene, window.viewer.stage.camera), window.viewer.stage.canvas.toDataURL()));
    const plain = await shot();
    await page.getByRole('button', { name: 'Mesh' }).click();
    const meshed = await shot();
    assert.ok(meshed !== plain, 'no mesh');
    await page.locator('.canvas canvas').focus();
    await page.keyboard.press('ArrowLeft');
    assert.ok((await shot()) !== meshed, 'the key does nothing');
  }, { picture: 'viewer_mesh' }));

test('the same solution gives the same page', async () => {
  const again = path.join(folder, 'again.html');
  await run(RADFIX, MODEL, '-o', glb, '--solve', '--patch-size', '0.8', '--viewer', again, '--jobs', '1');
  assert.equal(await readFile(again, 'utf8'), await readFile(html, 'utf8'));
});
