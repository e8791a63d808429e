// The geometry of a model out of the page: what report/html/packed_geometry.h writes.
import { DataUtils } from 'three';

function bytesOf(base64) {
  const text = atob(base64);
  const bytes = new Uint8Array(text.length);
  for (let i = 0; i < text.length; ++i) bytes[i] = text.charCodeAt(i);
  return bytes;
}

async function inflated(bytes) {
  const stream = new Blob([bytes]).stream().pipeThrough(new DecompressionStream('deflate'));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

// Reads whole numbers of seven bits a byte. `difference` adds to the number before.
function reader(bytes) {
  let at = 0;
  let last = 0;
  const number = () => {
    let value = 0;
    let scale = 1;
    for (;;) {
      const byte = bytes[at++];
      value += (byte & 127) * scale;
      if (byte < 128) return value;
      scale *= 128;
    }
  };
  return {
    number,
    restart: () => (last = 0),
    difference: () => {
      const coded = number();
      last += coded % 2 ? -(coded + 1) / 2 : coded / 2;
      return last;
    },
  };
}

// Radiosity of so many vertices, W/m²: what packed_light() of report/html/packed_geometry.h writes.
export async function unpackLight(base64, vertices, largest) {
  const read = reader(await inflated(bytesOf(base64)));
  const radiosity = new Float32Array(3 * vertices);
  for (let channel = 0; channel < 3; ++channel) {
    read.restart();
    for (let i = 0; i < vertices; ++i) radiosity[3 * i + channel] = largest * DataUtils.fromHalfFloat(read.difference());
  }
  return radiosity;
}

const STEPS = 2 ** 20 - 1;

// View data of a model: what report/html/view_data.h describes.
export async function unpackJson(base64) {
  return JSON.parse(new TextDecoder().decode(await inflated(bytesOf(base64))));
}

// Positions in the cube from -1 to 1, corners of triangles, and of each triangle which edges are edges of its face.
export async function unpack(base64) {
  const read = reader(await inflated(bytesOf(base64)));
  const vertices = read.number();
  const triangles = read.number();
  const positions = new Float32Array(3 * vertices);
  for (let axis = 0; axis < 3; ++axis) {
    read.restart();
    for (let i = 0; i < vertices; ++i) positions[3 * i + axis] = (read.difference() / STEPS) * 2 - 1;
  }
  read.restart();
  const corners = new Uint32Array(3 * triangles);
  for (let i = 0; i < corners.length; ++i) corners[i] = read.difference();
  const outlines = new Uint8Array(triangles);
  for (let i = 0; i < triangles; ++i) outlines[i] = read.number();
  return { positions, corners, outlines };
}
