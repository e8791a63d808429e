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

const AROUND = [[-1, -1], [1, -1], [-1, 1], [1, 1]];

// Triangles as one eye sees them: a front that looks at the eye hides what is behind it, a back hides nothing.
export class Sight {
  constructor(triangles, camera, picture) {
    this.camera = camera;
    this.picture = picture;
    this.triangles = triangles.filter(({ corners: [a, b, c] }) => {
      const normal = cross(minus(b.position, a.position), minus(c.position, a.position));
      return dot(normal, minus(camera.position, a.position)) > 0;
    });
    this.rows = new Float64Array(9 * this.triangles.length);
    this.triangles.forEach(({ corners: [a, b, c] }, i) => {
      const row = [minus(camera.position, a.position), minus(b.position, a.position), minus(c.position, a.position)];
      this.rows.set(row.flat(), 9 * i);
    });
  }

  // The nearest triangle along [x, y, z], with the weights of its corners; null for none. Möller and Trumbore 1997.
  firstHit([x, y, z]) {
    let nearest = null;
    let least = Infinity;
    const { rows } = this;
    for (let i = 0, at = 0; at < rows.length; ++i, at += 9) {
      const sx = rows[at], sy = rows[at + 1], sz = rows[at + 2];
      const bx = rows[at + 3], by = rows[at + 4], bz = rows[at + 5];
      const cx = rows[at + 6], cy = rows[at + 7], cz = rows[at + 8];
      const px = y * cz - z * cy, py = z * cx - x * cz, pz = x * cy - y * cx;
      const facing = bx * px + by * py + bz * pz;
      if (!(facing > 0)) continue;
      const u = (sx * px + sy * py + sz * pz) / facing;
      if (u < 0 || u > 1) continue;
      const qx = sy * bz - sz * by, qy = sz * bx - sx * bz, qz = sx * by - sy * bx;
      const v = (x * qx + y * qy + z * qz) / facing;
      if (v < 0 || u + v > 1) continue;
      const distance = (cx * qx + cy * qy + cz * qz) / facing;
      if (distance > 0 && distance < least) {
        least = distance;
        nearest = { triangle: this.triangles[i], weights: [1 - u - v, u, v] };
      }
    }
    return nearest;
  }

  // What is seen in the middle of pixel (x, y); null for nothing, and where an outline or an edge passes within `reach`
  // pixels, so that single precision decides what is seen, or where it is mixed (with a reach of 1).
  at(x, y, reach = 0.3) {
    const through = (dx, dy) => this.firstHit(direction(this.camera, this.picture, x + 0.5 + dx, y + 0.5 + dy));
    const middle = through(0, 0);
    if (!middle) return null;
    return AROUND.map(([dx, dy]) => through(reach * dx, reach * dy)).every((hit) => hit && agree(middle, hit)) ? middle : null;
  }
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

// `name` of the corners, mixed by the weights of a hit.
export const mixed = ({ triangle, weights }, name) =>
  triangle.corners[0][name].map((_, i) => weights.reduce((sum, weight, k) => sum + weight * triangle.corners[k][name][i], 0));
