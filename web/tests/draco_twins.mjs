// usage: node draco_twins.mjs RADLINT PLAIN.glb…
//
// Beside each PLAIN.glb lies its twin PLAIN.draco.glb. Google's decoder finds in the twin the same triangles with the
// same bits; radlint finds no error in it. The same triangles under Draco's default settings, each primitive on a grid
// of its own box, crack: what radlint then finds, and the sizes of all, make a table.
import assert from 'node:assert/strict';
import { execFile } from 'node:child_process';
import { mkdtemp, readFile, rm, writeFile } from 'node:fs/promises';
import { tmpdir } from 'node:os';
import path from 'node:path';
import { after, before, test } from 'node:test';
import { decoded, encodedAlone } from './draco.mjs';
import { glbOf, glbParts, numbers, placements } from './written_glb.mjs';

const [RADLINT, ...FILES] = process.argv.slice(2);
const CRACKS = ['RL301', 'RL302']; // not ziplocked, crack

let folder;
before(async () => (folder = await mkdtemp(path.join(tmpdir(), 'rad-draco-'))));
after(() => rm(folder, { recursive: true }));

const primitivesOf = (json) => json.meshes.flatMap(({ primitives }) => primitives);

function plainPart(parts, { attributes, indices }) {
  const rows = Object.entries(attributes).map(([name, accessor]) => [name, numbers(parts, accessor)]);
  return { corners: Uint32Array.from(numbers(parts, indices)), attributes: Object.fromEntries(rows) };
}

function streamOf({ json, buffer }, { bufferView }) {
  const { byteOffset = 0, byteLength } = json.bufferViews[bufferView];
  return new Uint8Array(buffer.subarray(byteOffset, byteOffset + byteLength));
}

// All that the corners of each triangle have, as text, from the least corner on.
function triangles({ corners, attributes }) {
  const rows = Object.keys(attributes).sort().map((name) => attributes[name]);
  const vertices = attributes.POSITION.length / 3;
  const vertex = Array.from({ length: vertices }, (_, i) =>
    rows.map((values) => {
      const width = values.length / vertices;
      const row = values.subarray(i * width, (i + 1) * width);
      return Buffer.from(row.buffer, row.byteOffset, row.byteLength).toString('hex');
    }).join());
  const result = [];
  for (let i = 0; i < corners.length; i += 3) {
    const ring = [...corners.subarray(i, i + 3)].map((corner) => vertex[corner]);
    const first = ring.indexOf(ring.toSorted()[0]);
    result.push([0, 1, 2].map((k) => ring[(first + k) % 3]).join(' '));
  }
  return result.sort();
}

function lint(file) {
  return new Promise((resolve, reject) =>
    execFile(RADLINT, [file, '--stage', 'display', '--format', 'json'], { maxBuffer: 1 << 28 }, (error, stdout) => {
      if (error && ![1].includes(error.code)) return reject(error);
      const { findings } = JSON.parse(stdout);
      const faults = findings.filter(({ severity }) => severity === 'error');
      const places = (list) => list.reduce((sum, { count }) => sum + count, 0);
      resolve({ places: places(faults), cracks: places(faults.filter(({ rule }) => CRACKS.includes(rule))) });
    }));
}

// The triangles of a file as each primitive's own quantisation leaves them: { bytes, places, cracks }.
async function quantised(name, parts, bits) {
  let bytes = 0;
  const meshes = [];
  for (const { mesh, at } of placements(parts.json)) {
    for (const primitive of parts.json.meshes[mesh].primitives) {
      const part = plainPart(parts, primitive);
      const stream = await encodedAlone(part, bits);
      bytes += stream.bytes.length;
      const { corners, attributes } = await decoded(stream.bytes, { POSITION: stream.ids.POSITION });
      meshes.push({ corners, positions: attributes.POSITION, at });
    }
  }
  const file = path.join(folder, `${name}_${bits}.glb`);
  await writeFile(file, glbOf(meshes, { radfix: parts.json.asset.extras.radfix }));
  return { bytes, ...(await lint(file)) };
}

for (const plain of FILES) {
  const name = path.basename(plain, '.glb');
  test(`${name}: the twin has the same bits, and default settings crack`, async () => {
    const twin = plain.replace(/glb$/, 'draco.glb');
    const parts = glbParts(await readFile(plain));
    const packed = glbParts(await readFile(twin));
    const streams = primitivesOf(packed.json).map(({ extensions }) => extensions.KHR_draco_mesh_compression);
    const primitives = primitivesOf(parts.json);
    assert.equal(streams.length, primitives.length);
    let triangleCount = 0;
    for (let i = 0; i < streams.length; ++i) {
      const wanted = plainPart(parts, primitives[i]);
      const found = await decoded(streamOf(packed, streams[i]), streams[i].attributes);
      assert.deepEqual(triangles(found), triangles(wanted), `primitive ${i}`);
      triangleCount += wanted.corners.length / 3;
    }
    const ours = await lint(twin);
    assert.equal(ours.places, 0);
    const eleven = await quantised(name, parts, 11);
    const fourteen = await quantised(name, parts, 14);
    for (const each of [eleven, fourteen]) assert.ok(each.cracks > 0, 'default settings do not crack');
    const [size, twinSize] = (await Promise.all([plain, twin].map((file) => readFile(file)))).map((b) => b.length);
    const kilobytes = (bytes) => `${Math.round(bytes / 1000)} kB`;
    console.log(`| ${name} | ${triangleCount} | ${kilobytes(size)} | ${kilobytes(twinSize)} |`,
      [eleven, fourteen].map((q) => `${kilobytes(q.bytes)}, ${q.cracks} of ${q.places} |`).join(' '));
  });
}
