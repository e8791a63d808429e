// An OpenEXR page of a light map, read by three.js.
import { readFile } from 'node:fs/promises';
import { EXRLoader } from 'three/addons/loaders/EXRLoader.js';
import { FloatType } from 'three';

// { width, height, at(column, row) } with rows from the top and linear values.
export async function exrPage(file) {
  const bytes = await readFile(file);
  const loader = new EXRLoader().setDataType(FloatType);
  const { width, height, data } = loader.parse(bytes.buffer.slice(bytes.byteOffset, bytes.byteOffset + bytes.length));
  const channels = data.length / (width * height);
  const at = (column, row) => {
    const first = channels * ((height - 1 - row) * width + column); // the loader has rows from below
    return [data[first], data[first + 1], data[first + 2]];
  };
  return { width, height, at };
}

// What a page shows at (u, v) from its upper left, between the four texels around.
export function bilinear(page, [u, v]) {
  const x = u * page.width - 0.5, y = v * page.height - 0.5;
  const column = Math.floor(x), row = Math.floor(y);
  const value = [0, 0, 0];
  for (const [i, j] of [[0, 0], [1, 0], [0, 1], [1, 1]]) {
    const weight = (i ? x - column : 1 + column - x) * (j ? y - row : 1 + row - y);
    if (weight) page.at(column + i, row + j).forEach((texel, channel) => (value[channel] += weight * texel));
  }
  return value;
}
