// The three-dimensional view: one canvas that shows one model at a time, a camera that flies, and what is clicked.
import * as THREE from 'three';
import { OrbitControls } from 'three/addons/controls/OrbitControls.js';
import { framing } from './framing.js';
import { Marks } from './marks.js';
import { Model } from './model.js';
import { unpack } from './unpack.js';

const FLIGHT_MS = 550;
const CLICK_REACH = 14; // pixels
const STILL = 4; // pixels that a click may move

const ease = (t) => (t < 0.5 ? 4 * t ** 3 : 1 - (2 - 2 * t) ** 3 / 2);

function themeOf(element) {
  const style = getComputedStyle(element);
  const value = (name) => style.getPropertyValue(name).trim();
  return {
    background: value('--stage'),
    surface: value('--surface'),
    back: value('--surface-back'),
    edge: value('--surface-edge'),
    colours: { error: value('--mark-error'), warning: value('--mark-warning'), note: value('--mark-note') },
  };
}

export class Stage {
  // `views` are view data by model number, `geometry(model)` gives the packed text.
  constructor(canvas, views, geometry) {
    this.canvas = canvas;
    this.views = views;
    this.geometry = geometry;
    this.loaded = new Map();
    this.hidden = new Map();
    this.options = { backs: false, seeThrough: false, edges: true };
    this.theme = themeOf(canvas);
    this.renderer = new THREE.WebGLRenderer({ canvas, antialias: true, preserveDrawingBuffer: true });
    this.scene = new THREE.Scene();
    this.camera = new THREE.PerspectiveCamera(35, 1, 0.001, 50);
    this.controls = new OrbitControls(this.camera, canvas);
    this.controls.addEventListener('change', () => this.draw());
    this.controls.addEventListener('start', () => this.stop());
    this.clicked = () => {};
    this.watchClicks();
    this.paint();
    new ResizeObserver(() => this.resize()).observe(canvas.parentElement);
    matchMedia('(prefers-color-scheme: dark)').addEventListener('change', () => this.paint());
    this.resize();
  }

  paint() {
    this.theme = themeOf(this.canvas);
    this.scene.background = new THREE.Color(this.theme.background);
    for (const { model } of this.loaded.values()) model.paint(this.theme);
    this.draw();
  }

  resize() {
    const { clientWidth, clientHeight } = this.canvas.parentElement;
    if (!clientWidth || !clientHeight) return;
    this.renderer.setPixelRatio(window.devicePixelRatio);
    this.renderer.setSize(clientWidth, clientHeight, false);
    this.camera.aspect = clientWidth / clientHeight;
    this.camera.updateProjectionMatrix();
    this.draw();
  }

  draw() {
    if (this.waiting) return;
    this.waiting = requestAnimationFrame(() => {
      this.waiting = 0;
      this.fitDepth();
      this.renderer.render(this.scene, this.camera);
    });
  }

  // The model lies in a cube from -1 to 1; the range of depths is no wider than that asks for.
  fitDepth() {
    const distance = this.camera.position.length();
    this.camera.near = Math.max(distance - 1.8, this.camera.position.distanceTo(this.controls.target) / 200, 1e-5);
    this.camera.far = distance + 1.8;
    this.camera.updateProjectionMatrix();
  }

  // Looks from where another stage looks.
  follow(other) {
    this.stop();
    this.camera.up.copy(other.camera.up);
    this.camera.fov = other.camera.fov;
    this.camera.position.copy(other.camera.position);
    this.camera.quaternion.copy(other.camera.quaternion);
    this.controls.target.copy(other.controls.target);
    this.draw();
  }

  watchClicks() {
    let down = null;
    this.canvas.addEventListener('pointerdown', (event) => (down = { x: event.offsetX, y: event.offsetY }));
    this.canvas.addEventListener('pointerup', (event) => {
      const moved = !down || Math.hypot(event.offsetX - down.x, event.offsetY - down.y) > STILL;
      down = null;
      if (moved || !this.model) return;
      const fault = this.marks.nearest(event.offsetX, event.offsetY, CLICK_REACH, (...p) => this.project(...p));
      if (fault !== null) this.clicked(this.current, fault);
    });
  }

  // Where a point is seen, in CSS pixels of the canvas; null for what is behind the eye.
  project(x, y, z) {
    this.camera.updateMatrixWorld();
    const point = new THREE.Vector3(x, y, z).applyMatrix4(this.camera.matrixWorldInverse);
    if (point.z >= 0) return null;
    point.applyMatrix4(this.camera.projectionMatrix);
    const { clientWidth, clientHeight } = this.canvas;
    return { x: ((point.x + 1) / 2) * clientWidth, y: ((1 - point.y) / 2) * clientHeight };
  }

  async load(index) {
    if (!this.loaded.has(index)) {
      const content = await unpack(this.geometry(index));
      this.loaded.set(index, {
        model: new Model(content, this.theme, this.views.get(index).place),
        marks: new Marks(this.views.get(index).faults, this.theme.colours),
      });
      this.loaded.get(index).marks.hide(this.hidden.get(index) ?? new Set());
    }
    return this.loaded.get(index);
  }

  // Shows a model as a whole. Of calls that overlap the last one counts.
  async show(index) {
    if (this.current === index) return;
    const wanted = (this.wanted = Symbol('model'));
    if (!this.views.has(index)) return this.showNothing(index);
    const { model, marks } = await this.load(index);
    if (this.wanted !== wanted) return;
    this.scene.clear();
    this.scene.add(model.group, marks.group);
    this.current = index;
    this.model = model;
    this.marks = marks;
    this.marks.choose(null);
    this.apply(this.options);
    this.place(this.whole());
  }

  // Where there is no such model on this side.
  showNothing(index) {
    this.scene.clear();
    this.current = index;
    this.model = this.marks = null;
    this.draw();
  }

  apply(options) {
    this.options = { ...this.options, ...options };
    this.model?.showBacks(this.options.backs);
    this.model?.seeThrough(this.options.seeThrough);
    this.model?.showEdges(this.options.edges);
    this.draw();
  }

  // The camera of a fault for this canvas: from farther where that is narrower than high.
  fitted({ position, target, fieldOfView }) {
    const farther = Math.max(1, 1 / this.camera.aspect);
    return { position: position.map((value, axis) => target[axis] + (value - target[axis]) * farther), target, fieldOfView };
  }

  // The model as a whole, from the direction in which the page's data looks at it, as near as this canvas allows.
  whole() {
    const { camera, up } = this.views.get(this.current);
    return framing(this.model.box(), camera, up, this.camera.aspect);
  }

  place({ position, target, fieldOfView }) {
    this.stop();
    this.camera.up.fromArray(this.views.get(this.current).up);
    this.camera.fov = fieldOfView;
    this.camera.position.fromArray(position);
    this.controls.target.fromArray(target);
    this.camera.updateProjectionMatrix();
    this.controls.update();
    this.draw();
  }

  stop() {
    cancelAnimationFrame(this.flight);
  }

  // From where the camera is to another place, on an arc around what it looks at. Resolves on arrival.
  fly(goal) {
    this.stop();
    if (matchMedia('(prefers-reduced-motion: reduce)').matches) {
      this.place(goal);
      return Promise.resolve();
    }
    const from = { target: this.controls.target.clone(), offset: new THREE.Spherical() };
    const turn = new THREE.Quaternion().setFromUnitVectors(this.camera.up.clone().normalize(), new THREE.Vector3(0, 1, 0));
    const spherical = (position, target) =>
      new THREE.Spherical().setFromVector3(position.clone().sub(target).applyQuaternion(turn));
    const end = { target: new THREE.Vector3(...goal.target) };
    from.offset = spherical(this.camera.position, from.target);
    end.offset = spherical(new THREE.Vector3(...goal.position), end.target);
    const around = end.offset.theta - from.offset.theta;
    const theta = Math.atan2(Math.sin(around), Math.cos(around));
    const back = turn.clone().invert();
    const start = performance.now();
    return new Promise((resolve) => {
      const step = (now) => {
        const t = Math.min(1, (now - start) / FLIGHT_MS);
        const share = ease(t);
        const mix = (a, b) => a + (b - a) * share;
        const offset = new THREE.Spherical(
          Math.exp(mix(Math.log(from.offset.radius), Math.log(end.offset.radius))),
          mix(from.offset.phi, end.offset.phi),
          from.offset.theta + theta * share,
        );
        this.controls.target.lerpVectors(from.target, end.target, share);
        this.camera.position.setFromSpherical(offset).applyQuaternion(back).add(this.controls.target);
        this.controls.update();
        this.draw();
        if (t < 1) this.flight = requestAnimationFrame(step);
        else resolve(this.place(goal));
      };
      this.flight = requestAnimationFrame(step);
    });
  }

  // Marks a fault, or none for null. Returns the camera that sees it best, null where it has no place.
  async choose(index, fault) {
    await this.show(index);
    if (!this.model) return null;
    const chosen = fault === null ? null : this.views.get(index).faults[fault];
    this.marks.choose(fault);
    this.model.highlight(chosen?.triangles ?? [], chosen ? this.theme.colours[chosen.severity] : '#000');
    this.draw();
    return chosen?.camera ? this.fitted(chosen.camera) : null;
  }

  hideFaults(index, faults) {
    this.hidden.set(index, faults);
    this.loaded.get(index)?.marks.hide(faults);
    this.draw();
  }

  // Turns around what is looked at by degrees; nearer for a factor below 1.
  turn(right, up, factor = 1) {
    this.stop();
    const axis = this.camera.up.clone().normalize();
    const upright = new THREE.Quaternion().setFromUnitVectors(axis, new THREE.Vector3(0, 1, 0));
    const offset = this.camera.position.clone().sub(this.controls.target).applyQuaternion(upright);
    const spherical = new THREE.Spherical().setFromVector3(offset);
    spherical.theta += (right * Math.PI) / 180;
    spherical.phi = Math.min(Math.PI - 0.01, Math.max(0.01, spherical.phi - (up * Math.PI) / 180));
    spherical.radius *= factor;
    offset.setFromSpherical(spherical).applyQuaternion(upright.invert());
    this.camera.position.copy(this.controls.target).add(offset);
    this.controls.update();
    this.draw();
  }
}
