// usage: node bake_pixels.mjs SCENE VERTEX.glb LIGHTMAP.glb EMISSIVE.glb
//
// What three.js and Babylon.js show of a solved scene, beside what the solver found. Camera and points are fixed, tone
// mapping is off, codes are sRGB. Expected is srgb(curve(exposure × radiosity)) with exposure and curve as the file
// records them: the radiosity of the corners (_RADIOSITY) under --bake vertex, that of the OpenEXR page, which three.js
// reads, under the others. The curve is taken where the light is kept, at corners and texels, and mixed after it.
// RAD_SCREENSHOTS=FOLDER keeps the pictures.
import assert from 'node:assert/strict';
import { readFile } from 'node:fs/promises';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { launch } from './browser.mjs';
import { bilinear, exrPage } from './exr_page.mjs';
import { PICTURE, shownPixels } from './shown_pixels.mjs';
import { mixed, Sight } from './sight.mjs';
import { writtenGlb } from './written_glb.mjs';

const [SCENE, ...FILES] = process.argv.slice(2);
const MODES = ['vertex', 'lightmap', 'emissive'];
const CAMERAS = {
  lamp_post: { position: [9, -2, 6], target: [4, 4, 1.2], fieldOfView: 50 },
  room: { position: [4.6, 0.4, 2.1], target: [1.5, 2.6, 0.9], fieldOfView: 70 },
  flat: { position: [0.6, 0.6, 1.9], target: [4, 3.2, 1], fieldOfView: 70 },
};
const CAMERA = { ...CAMERAS[SCENE], up: [0, 0, 1], near: 0.05, far: 50 };
const STEP = 24; // pixels
const LEAST_POINTS = 150;
const CODES = 2;
// Between corners a page is bilinear over quads where the GLB has two triangles, and holds no more than its texels:
// this share of the points may be farther than CODES from what the corners say.
const BEYOND = 0.01;

const shown = (linear) => Math.min(1, Math.max(0, linear));
const srgb = (linear) =>
  255 * (linear <= 0.0031308 ? 12.92 * linear : 1.055 * linear ** (1 / 2.4) - 0.055);
const linear = (code) => (code <= 0.04045 * 255 ? code / 255 / 12.92 : ((code / 255 + 0.055) / 1.055) ** 2.4);

let browser;
before(async () => (browser = await launch()));
after(() => browser.close());

const models = new Map();

// The file, its pages, and what the camera sees of it at the points of a grid.
async function modelOf(mode) {
  if (!models.has(mode)) models.set(mode, await opened(mode, FILES[MODES.indexOf(mode)]));
  return models.get(mode);
}

async function opened(mode, file) {
  const glb = await writtenGlb(file);
  const sight = new Sight(glb.triangles, CAMERA, PICTURE);
  const points = [];
  for (let y = STEP / 2; y < PICTURE.height; y += STEP) {
    for (let x = STEP / 2; x < PICTURE.width; x += STEP) {
      const hit = sight.at(x, y);
      if (hit) points.push({ x, y, hit, material: glb.materials[hit.triangle.material] });
    }
  }
  const pages = [];
  if (mode !== 'vertex') {
    const atlas = JSON.parse(await readFile(file.replace(/glb$/, 'atlas.json'), 'utf8'));
    for (const { exr } of atlas.pages) pages.push(await exrPage(path.join(path.dirname(file), exr)));
  }
  return { file, points, pages, exposure: glb.record.exposure, curve: glb.record.curve };
}

// Linear, of one point: what the file records.
function recorded({ exposure, pages }, mode, { hit, material }) {
  if (mode === 'vertex') {
    const colours = hit.triangle.corners.map(({ radiosity }) => ({ colour: radiosity.map((b) => shown(exposure * b)) }));
    return mixed({ triangle: { corners: colours }, weights: hit.weights }, 'colour');
  }
  const white = mode === 'lightmap' ? 1 / exposure : whiteOf(material);
  const page = pages[material.extras.radfix.lightMap];
  const clipped = { ...page, at: (i, j) => page.at(i, j).map((value) => shown(value / white)) };
  return bilinear(clipped, mixed(hit, 'place')).map((value) => shown(exposure * white * value));
}

// In W/m², of an emissive material.
const whiteOf = ({ extensions }) => Math.PI * extensions.KHR_materials_emissive_strength.emissiveStrength;

// Linear, of one point: what the solver found at the corners around.
const solved = ({ exposure }, { hit }) => mixed(hit, 'radiosity').map((value) => shown(exposure * value));

// Half a code of an emissive page, in codes of the picture: its white may be far above that of the picture.
function halfCode({ exposure }, mode, material, value) {
  if (mode !== 'emissive') return 0;
  const scale = exposure * whiteOf(material);
  const code = srgb(value / scale);
  return srgb(shown(scale * linear(code + 0.5))) - srgb(shown(scale * linear(code)));
}

const differences = (codes, expected) => codes.map((code, channel) => Math.abs(code - srgb(expected[channel])));

for (const mode of MODES) {
  for (const renderer of ['three', 'babylon']) {
    test(`${SCENE}, ${mode}, ${renderer}: pixels are what the solver found, exposed`, async () => {
      const model = await modelOf(mode);
      assert.equal(model.curve, 'linear');
      assert.ok(model.points.length >= LEAST_POINTS, `${model.points.length} points`);
      const folder = process.env.RAD_SCREENSHOTS;
      const { result, problems } = await shownPixels(
        browser, renderer, model.file, { camera: CAMERA, perLuminance: Math.PI * model.exposure },
        model.points.map(({ x, y }) => [x, y]),
        { screenshot: folder && path.join(folder, `${SCENE}_${mode}_${renderer}.png`) },
      );
      assert.deepEqual(problems, []);
      let worst = 0, worstAtCorners = 0, beyond = 0;
      model.points.forEach((point, i) => {
        const expected = recorded(model, mode, point);
        differences(result[i], expected).forEach((off, channel) => {
          worst = Math.max(worst, off);
          const least = halfCode(model, mode, point.material, expected[channel]);
          assert.ok(off <= Math.max(CODES, 1 + least), `(${point.x}, ${point.y}): ${result[i]} and not ${expected.map(srgb)}`);
        });
        const off = Math.max(...differences(result[i], solved(model, point)));
        worstAtCorners = Math.max(worstAtCorners, off);
        if (off > CODES) ++beyond;
      });
      console.log(
        `${SCENE} ${mode} ${renderer}: ${model.points.length} points, off by ${worst.toFixed(2)} codes at most; ` +
          `from the corners by ${worstAtCorners.toFixed(2)}, ${beyond} points by more than ${CODES}`,
      );
      assert.ok(beyond <= BEYOND * model.points.length, `${beyond} points are not what the corners say`);
    });
  }
}
