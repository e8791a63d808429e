// Small GLBs made here: a sound one and some with one fault each.

function glb(json, binary) {
  const pad = (buffer, fill) => Buffer.concat([buffer, Buffer.alloc((4 - (buffer.length % 4)) % 4, fill)]);
  const chunk = (type, body) => {
    const head = Buffer.alloc(8);
    head.writeUInt32LE(body.length, 0);
    head.write(type, 4, 'latin1');
    return Buffer.concat([head, body]);
  };
  const chunks = Buffer.concat([
    chunk('JSON', pad(Buffer.from(JSON.stringify(json)), ' ')),
    chunk('BIN\0', pad(binary, 0)),
  ]);
  const head = Buffer.alloc(12);
  head.write('glTF', 0, 'latin1');
  head.writeUInt32LE(2, 4);
  head.writeUInt32LE(head.length + chunks.length, 8);
  return Buffer.concat([head, chunks]);
}

// A baked pyramid without a base: unlit, one colour for each of its 12 corners.
function pyramid({ colour = [0.8, 0.4, 0.1, 1], corner = [1, -0.5, 1] } = {}) {
  const ring = [corner, [1, -0.5, -1], [-1, -0.5, -1], [-1, -0.5, 1]];
  const points = ring.flatMap((point, i) => [point, ring[(i + 1) % 4], [0, 1, 0]]);
  const positions = Float32Array.from(points.flat());
  const colours = Float32Array.from(points.flatMap(() => colour));
  const binary = Buffer.concat([Buffer.from(positions.buffer), Buffer.from(colours.buffer)]);
  const axis = (i) => points.map((point) => Math.fround(point[i]));
  const json = {
    asset: { version: '2.0' },
    extensionsUsed: ['KHR_materials_unlit'],
    scene: 0,
    scenes: [{ nodes: [0] }],
    nodes: [{ mesh: 0 }],
    meshes: [{ primitives: [{ attributes: { POSITION: 0, COLOR_0: 1 }, material: 0 }] }],
    materials: [{ extensions: { KHR_materials_unlit: {} } }],
    accessors: [
      {
        bufferView: 0,
        componentType: 5126,
        count: 12,
        type: 'VEC3',
        min: [0, 1, 2].map((i) => Math.min(...axis(i))),
        max: [0, 1, 2].map((i) => Math.max(...axis(i))),
      },
      { bufferView: 1, componentType: 5126, count: 12, type: 'VEC4' },
    ],
    bufferViews: [
      { buffer: 0, byteOffset: 0, byteLength: positions.byteLength, target: 34962 },
      { buffer: 0, byteOffset: positions.byteLength, byteLength: colours.byteLength, target: 34962 },
    ],
    buffers: [{ byteLength: binary.length }],
  };
  return { json, binary };
}

const write = ({ json, binary }) => glb(json, binary);

export const sound = () => write(pyramid());

export const faulty = {
  truncated: () => sound().subarray(0, 200),
  bright: () => write(pyramid({ colour: [3, 0, 0, 1] })),
  notFinite: () => write(pyramid({ corner: [NaN, 0, 0] })),
  speck: () => {
    const model = pyramid();
    model.json.nodes = [{ mesh: 0, scale: [1e-3, 1e-3, 1e-3] }, { mesh: 0, translation: [1e3, 0, 0] }];
    model.json.scenes[0].nodes = [0, 1];
    return write(model);
  },
  reachesOut: () => {
    const model = pyramid();
    model.json.images = [{ uri: 'https://elsewhere.invalid/picture.png' }];
    model.json.textures = [{ source: 0 }];
    model.json.materials[0].pbrMetallicRoughness = { baseColorTexture: { index: 0 } };
    return write(model);
  },
  warns: () => {
    const model = pyramid();
    model.json.extensionsUsed.push('RAD_unknown');
    model.json.extensionsRequired = ['RAD_unknown'];
    return write(model);
  },
};
