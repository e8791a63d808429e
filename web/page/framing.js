// Where a camera has to be to see a whole box.
import * as THREE from 'three';

const MARGIN = 0.08; // of the picture, on each side

// How far the corners reach to both sides of an axis of the picture, each measured where it meets the plane of the eye
// along the border of the view.
function reach(corners, axis, backward, slope) {
  const sides = [1, -1].map((sign) => Math.max(...corners.map((p) => sign * p.dot(axis) + slope * p.dot(backward))));
  return { distance: (sides[0] + sides[1]) / (2 * slope), middle: (sides[0] - sides[1]) / 2 };
}

export function framing(box, { position, target, fieldOfView }, up, aspect) {
  const backward = new THREE.Vector3(...position).sub(new THREE.Vector3(...target)).normalize();
  const right = new THREE.Vector3(...up).cross(backward).normalize();
  const above = backward.clone().cross(right);
  const centre = box.getCenter(new THREE.Vector3());
  const corners = [0, 1, 2, 3, 4, 5, 6, 7].map((i) =>
    new THREE.Vector3(
      i & 1 ? box.max.x : box.min.x,
      i & 2 ? box.max.y : box.min.y,
      i & 4 ? box.max.z : box.min.z,
    ).sub(centre),
  );
  const slope = Math.tan((fieldOfView * Math.PI) / 360) * (1 - 2 * MARGIN);
  const wide = reach(corners, right, backward, slope * aspect);
  const high = reach(corners, above, backward, slope);
  const goal = centre.clone().addScaledVector(right, wide.middle).addScaledVector(above, high.middle);
  const distance = Math.max(wide.distance, high.distance, 1e-3);
  return { position: goal.clone().addScaledVector(backward, distance).toArray(), target: goal.toArray(), fieldOfView };
}
