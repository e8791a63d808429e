// Which triangle a camera sees in a pixel, told without any renderer.

const minus = (a, b) => [a[0] - b[0], a[1] - b[1], a[2] - b[2]];
const dot = (a, b) => a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
const cross = (a, b) => [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
const unit = (a) => a.map((value) => value / Math.hypot(...a));

// Direction through (x, y) of a picture, pixels from its upper left; the centre of the first pixel is (0.5, 0.5).
export function direction({ position, target, up, fieldOfView }, { width, height }, x, y) {
  const forward = unit(minus(target, position));
  const right = unit(cross(forward, up));
  const above = cross(right, forward);
  const slope = Math.tan((fieldOfView * Math.PI) / 360);
  const across = ((2 * x) / width - 1) * slope * (width / height);
  const upward = (1 - (2 * y) / height) * slope;
  return forward.map((value, axis) => value + across * right[axis] + upward * above[axis]);
}

// The nearest triangle that is met from its front, with the weights of its corners; null where there is none.
// Möller and Trumbore 1997.
export function firstHit(triangles, from, along) {
  let nearest = null;
  for (const triangle of triangles) {
    const [a, b, c] = triangle.corners.map(({ position }) => position);
    const ab = minus(b, a), ac = minus(c, a), p = cross(along, ac);
    const facing = dot(ab, p);
    if (!(facing > 0)) continue;
    const s = minus(from, a), u = dot(s, p) / facing;
    if (u < 0 || u > 1) continue;
    const q = cross(s, ab), v = dot(along, q) / facing;
    if (v < 0 || u + v > 1) continue;
    const distance = dot(ac, q) / facing;
    if (distance > 0 && (!nearest || distance < nearest.distance)) {
      nearest = { triangle, weights: [1 - u - v, u, v], distance };
    }
  }
  return nearest;
}

const normalOf = ({ corners: [a, b, c] }) => unit(cross(minus(b.position, a.position), minus(c.position, a.position)));

// Of two hits, whether they lie in one plane of one material.
function agree(one, other) {
  if (one.triangle === other.triangle) return true;
  if (one.triangle.material !== other.triangle.material) return false;
  const normal = normalOf(one.triangle);
  const off = dot(normal, minus(other.triangle.corners[0].position, one.triangle.corners[0].position));
  return dot(normal, normalOf(other.triangle)) > 1 - 1e-6 && Math.abs(off) < 1e-3;
}

const AROUND = [[-0.3, -0.3], [0.3, -0.3], [-0.3, 0.3], [0.3, 0.3]];

// What is seen in the middle of pixel (x, y); null for nothing, and where an outline or an edge passes near it, so that
// single precision decides what is seen.
export function seen(triangles, camera, picture, x, y) {
  const through = (dx, dy) => firstHit(triangles, camera.position, direction(camera, picture, x + 0.5 + dx, y + 0.5 + dy));
  const middle = through(0, 0);
  if (!middle) return null;
  return AROUND.map(([dx, dy]) => through(dx, dy)).every((hit) => hit && agree(middle, hit)) ? middle : null;
}

export const mixed = ({ triangle, weights }, name) =>
  triangle.corners[0][name].map((_, i) => weights.reduce((sum, weight, k) => sum + weight * triangle.corners[k][name][i], 0));
