// A GLB that radfix wrote, as plain arrays: what its triangles are and what is recorded of their light.
import { readFile } from 'node:fs/promises';

const ARRAYS = { 5121: Uint8Array, 5123: Uint16Array, 5125: Uint32Array, 5126: Float32Array };
const WIDTHS = { SCALAR: 1, VEC2: 2, VEC3: 3, VEC4: 4 };

export function glbParts(bytes) {
  const view = new DataView(bytes.buffer, bytes.byteOffset, bytes.byteLength);
  const length = view.getUint32(12, true);
  return { json: JSON.parse(bytes.subarray(20, 20 + length).toString('utf8')), buffer: bytes.subarray(28 + length) };
}

// Numbers of one accessor, without what lies between them.
export function numbers({ json, buffer }, accessor) {
  const { bufferView, byteOffset = 0, componentType, count, type } = json.accessors[accessor];
  const { byteOffset: start = 0, byteStride } = json.bufferViews[bufferView];
  const Numbers = ARRAYS[componentType];
  const width = WIDTHS[type];
  const stride = byteStride ?? width * Numbers.BYTES_PER_ELEMENT;
  const result = new Numbers(width * count);
  for (let i = 0; i < count; ++i) {
    const at = buffer.byteOffset + start + byteOffset + i * stride;
    const copy = buffer.buffer.slice(at, at + width * Numbers.BYTES_PER_ELEMENT);
    result.set(new Numbers(copy), i * width);
  }
  return result;
}

// Where each mesh is put: radfix writes translations only.
export function placements(json) {
  const placed = [];
  const visit = (index, above) => {
    const { translation = [0, 0, 0], mesh, children = [], ...other } = json.nodes[index];
    const moved = ['rotation', 'scale', 'matrix'].filter((name) => name in other);
    if (moved.length) throw new Error(`node ${index} has a ${moved.join(' and a ')}`);
    const at = above.map((value, axis) => value + translation[axis]);
    if (mesh !== undefined) placed.push({ mesh, at });
    for (const child of children) visit(child, at);
  };
  for (const root of json.scenes[json.scene].nodes) visit(root, [0, 0, 0]);
  return placed;
}

// { record, materials, triangles: [{ corners: 3 × { position, radiosity, place }, record }] }; positions are the scene's, radiosity in
// W/m², place on the page from its upper left.
export async function writtenGlb(file) {
  const parts = glbParts(await readFile(file));
  const triangles = [];
  for (const { mesh, at } of placements(parts.json)) {
    for (const { attributes, indices, material } of parts.json.meshes[mesh].primitives) {
      const position = numbers(parts, attributes.POSITION);
      const radiosity = numbers(parts, attributes._RADIOSITY);
      const place = attributes.TEXCOORD_1 === undefined ? null : numbers(parts, attributes.TEXCOORD_1);
      const corner = (i) => ({
        position: [0, 1, 2].map((axis) => at[axis] + position[3 * i + axis]),
        radiosity: [...radiosity.subarray(3 * i, 3 * i + 3)],
        place: place && [...place.subarray(2 * i, 2 * i + 2)],
      });
      const order = numbers(parts, indices);
      for (let i = 0; i < order.length; i += 3) {
        triangles.push({ corners: [...order.subarray(i, i + 3)].map(corner), material });
      }
    }
  }
  return { record: parts.json.asset.extras.radfix, materials: parts.json.materials, triangles };
}

// A GLB of `meshes`: { corners, positions, at }, and what the extras of its asset are.
export function glbOf(meshes, extras) {
  const blocks = [];
  let length = 0;
  const json = {
    asset: { version: '2.0', extras },
    scene: 0,
    scenes: [{ nodes: meshes.map((_, i) => i) }],
    nodes: meshes.map(({ at }, mesh) => ({ mesh, translation: at })),
    meshes: [],
    accessors: [],
    bufferViews: [],
  };
  const add = (values, componentType, type, width, more) => {
    json.bufferViews.push({ buffer: 0, byteOffset: length, byteLength: values.byteLength });
    json.accessors.push({ bufferView: json.bufferViews.length - 1, componentType, count: values.length / width, type, ...more });
    blocks.push(Buffer.from(values.buffer, values.byteOffset, values.byteLength));
    length += values.byteLength;
    return json.accessors.length - 1;
  };
  for (const { corners, positions } of meshes) {
    const range = (pick) =>
      [0, 1, 2].map((axis) => positions.filter((_, i) => i % 3 === axis).reduce((a, b) => pick(a, b)));
    const POSITION = add(positions, 5126, 'VEC3', 3, { min: range(Math.min), max: range(Math.max) });
    json.meshes.push({ primitives: [{ attributes: { POSITION }, indices: add(corners, 5125, 'SCALAR', 1) }] });
  }
  json.buffers = [{ byteLength: length }];
  const text = Buffer.from(JSON.stringify(json));
  const padded = Buffer.concat([text, Buffer.alloc((4 - (text.length % 4)) % 4, ' ')]);
  const words = (...values) => Buffer.from(Uint32Array.from(values).buffer);
  const total = 12 + 8 + padded.length + 8 + length;
  return Buffer.concat([words(0x46546c67, 2, total, padded.length, 0x4e4f534a), padded, words(length, 0x004e4942), ...blocks]);
}
