// Faults over the model: signs whose shape says how severe, and lines with a casing. Always on top.
import * as THREE from 'three';
import { LineMaterial } from 'three/addons/lines/LineMaterial.js';
import { LineSegments2 } from 'three/addons/lines/LineSegments2.js';
import { LineSegmentsGeometry } from 'three/addons/lines/LineSegmentsGeometry.js';

export const SEVERITIES = ['note', 'warning', 'error'];
const SIGN_PIXELS = 15;
const SMALL_SIGN_PIXELS = 11;
const CHOSEN_PIXELS = 24;
const LINES_OF_OTHERS = 24;
const MANY_FAULTS = 100;
const DIM_OPACITY = 0.45;

// Drawn at four times the size at which it is shown.
function signTexture(severity, colour) {
  const canvas = document.createElement('canvas');
  canvas.width = canvas.height = 96;
  const context = canvas.getContext('2d');
  context.translate(48, 48);
  context.beginPath();
  if (severity === 'error') {
    for (const [x, y] of [[0, -40], [40, 0], [0, 40], [-40, 0]]) context.lineTo(x, y);
  } else if (severity === 'warning') {
    for (const [x, y] of [[0, -38], [40, 30], [-40, 30]]) context.lineTo(x, y);
  } else {
    context.arc(0, 0, 32, 0, 2 * Math.PI);
  }
  context.closePath();
  context.lineJoin = 'round';
  context.lineWidth = 14;
  context.strokeStyle = '#fff';
  context.stroke();
  context.lineWidth = 5;
  context.strokeStyle = '#1b1b1b';
  context.stroke();
  context.fillStyle = colour;
  context.fill();
  const texture = new THREE.CanvasTexture(canvas);
  texture.colorSpace = THREE.SRGBColorSpace;
  return texture;
}

function pointsObject(coordinates, texture, size, opacity) {
  const geometry = new THREE.BufferGeometry();
  geometry.setAttribute('position', new THREE.BufferAttribute(new Float32Array(coordinates), 3));
  const material = new THREE.PointsMaterial({
    map: texture,
    size,
    sizeAttenuation: false,
    opacity,
    transparent: true,
    depthTest: false,
    depthWrite: false,
  });
  return new THREE.Points(geometry, material);
}

function linesObject(coordinates, colour, width) {
  const geometry = new LineSegmentsGeometry().setPositions(coordinates);
  const material = new LineMaterial({
    color: colour,
    linewidth: width,
    depthTest: false,
    depthWrite: false,
    transparent: true,
  });
  return new LineSegments2(geometry, material);
}

// All marks of one model. `faults` are those of the page's view data.
export class Marks {
  constructor(faults, colours) {
    this.faults = faults;
    this.colours = colours;
    this.textures = Object.fromEntries(SEVERITIES.map((name) => [name, signTexture(name, colours[name])]));
    this.group = new THREE.Group();
    this.hidden = new Set();
    this.chosen = null;
    this.build();
  }

  add(object, order) {
    object.renderOrder = order;
    object.frustumCulled = false;
    this.group.add(object);
  }

  build() {
    this.clear();
    SEVERITIES.forEach((severity, level) => {
      const shown = this.faults.filter((fault, i) => fault.severity === severity && !this.hidden.has(i) && i !== this.chosen);
      const opacity = this.chosen === null ? 1 : DIM_OPACITY;
      const size = this.faults.length > MANY_FAULTS ? SMALL_SIGN_PIXELS : SIGN_PIXELS;
      const lines = shown.flatMap((fault) => this.drawn(fault).lines);
      if (lines.length) this.addLines(lines, this.colours[severity], 2.5, 10 + 4 * level);
      const points = shown.flatMap((fault) => this.drawn(fault).points);
      if (points.length) this.add(pointsObject(points, this.textures[severity], size, opacity), 12 + 4 * level);
    });
    const fault = this.faults[this.chosen];
    if (!fault) return;
    if (fault.lines.length) this.addLines(fault.lines, this.colours[fault.severity], 4.5, 30);
    if (fault.points.length) this.add(pointsObject(fault.points, this.textures[fault.severity], CHOSEN_PIXELS, 1), 32);
  }

  addLines(coordinates, colour, width, order) {
    this.add(linesObject(coordinates, '#ffffff', width + 2.5), order);
    this.add(linesObject(coordinates, colour, width), order + 1);
  }

  clear() {
    for (const object of this.group.children) {
      object.geometry.dispose();
      object.material.dispose();
    }
    this.group.clear();
  }

  choose(index) {
    this.chosen = index;
    this.build();
  }

  // Leaves out the faults with these numbers.
  hide(indices) {
    this.hidden = indices;
    this.build();
  }

  // The fault that is drawn nearest to a point of the canvas, at most `reach` pixels away; the more severe of two.
  // `project` takes x, y, z to pixels, or to null for what is behind the eye.
  nearest(x, y, reach, project) {
    let best = null;
    this.faults.forEach((fault, index) => {
      if (this.hidden.has(index)) return;
      const distance = distanceTo(this.drawn(fault, index), x, y, project) - SEVERITIES.indexOf(fault.severity) * 0.5;
      if (distance <= reach && (best === null || distance < best.distance)) best = { index, distance };
    });
    return best?.index ?? null;
  }

  // What is seen of a fault; of those that are not chosen the worst places.
  drawn(fault, index = -1) {
    if (index === this.chosen) return fault;
    const lines = this.chosen !== null ? 0 : this.faults.length > MANY_FAULTS ? 1 : LINES_OF_OTHERS;
    return { points: fault.points.slice(0, 3), lines: fault.lines.slice(0, 6 * lines) };
  }

  dispose() {
    this.clear();
    for (const texture of Object.values(this.textures)) texture.dispose();
  }
}

function distanceToSegment(x, y, from, to) {
  const dx = to.x - from.x;
  const dy = to.y - from.y;
  const square = dx * dx + dy * dy;
  const share = square > 0 ? Math.min(1, Math.max(0, ((x - from.x) * dx + (y - from.y) * dy) / square)) : 0;
  return Math.hypot(x - from.x - share * dx, y - from.y - share * dy);
}

function distanceTo(fault, x, y, project) {
  let least = Infinity;
  for (let i = 0; i < fault.points.length; i += 3) {
    const at = project(fault.points[i], fault.points[i + 1], fault.points[i + 2]);
    if (at) least = Math.min(least, Math.hypot(x - at.x, y - at.y));
  }
  for (let i = 0; i < fault.lines.length; i += 6) {
    const from = project(...fault.lines.slice(i, i + 3));
    const to = project(...fault.lines.slice(i + 3, i + 6));
    if (from && to) least = Math.min(least, distanceToSegment(x, y, from, to));
  }
  return least;
}
