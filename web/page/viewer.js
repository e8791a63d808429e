// The page of a solution: its light in three dimensions, with exposure, curve, false colours and the mesh.
import * as THREE from 'three';
import { element } from './element.js';
import { CURVES, lightMaterial, luminance, scaleCodes } from './light.js';
import { Stages } from './stages.js';
import { unpackJson, unpackLight } from './unpack.js';

const STOPS = 8; // of the slider, to both sides
const FALSE_COLOURS = 3;

const short = (value) => (value === 0 ? '0' : Number(value.toPrecision(3)).toString());

function button(text, act, pressed) {
  const result = element('button', { type: 'button', text, ...(pressed === undefined ? {} : { 'aria-pressed': String(pressed) }) });
  result.addEventListener('click', () => {
    if (pressed !== undefined) {
      pressed = !pressed;
      result.setAttribute('aria-pressed', String(pressed));
    }
    act(pressed);
  });
  return result;
}

class Viewer {
  constructor(light) {
    this.light = light;
    this.stops = 0;
    this.mode = CURVES.indexOf(light.curve);
    this.curve = Math.max(0, this.mode);
    if (this.mode < 0) this.mode = FALSE_COLOURS;
    this.material = lightMaterial(light.palette);
    this.reading = element('p', { class: 'caption', 'aria-live': 'polite', text: 'Click on a surface to read its radiosity.' });
  }

  get exposure() {
    return this.light.exposure * 2 ** this.stops;
  }

  show() {
    this.material.uniforms.exposure.value = this.exposure;
    this.material.uniforms.mode.value = this.mode;
    this.exposureText.textContent = `${this.stops >= 0 ? '+' : '−'}${Math.abs(this.stops).toFixed(1)} stops, white is ${short(1 / this.exposure)} W/m²`;
    this.legend.hidden = this.mode !== FALSE_COLOURS;
    const last = this.ticks.length - 1;
    this.ticks.forEach((tick, i) => (tick.textContent = short((last - i) / last / this.exposure)));
    this.stage.draw();
  }

  makeLegend() {
    const codes = this.light.palette.map((_, i) => `rgb(${scaleCodes(this.light.palette, i / (this.light.palette.length - 1))})`);
    const bar = element('div', { class: 'bar' });
    bar.style.background = `linear-gradient(to top, ${codes.join(', ')})`;
    this.ticks = [0, 1, 2, 3, 4].map(() => element('span'));
    this.legend = element('div', { class: 'legend', role: 'img', 'aria-label': 'Scale of the false colours, W/m²' }, [
      element('p', { text: 'W/m²' }), bar, element('div', { class: 'ticks' }, this.ticks),
    ]);
    return this.legend;
  }

  makeToolbar() {
    const slider = element('input', { type: 'range', min: String(-STOPS), max: String(STOPS), step: '0.1', value: '0', id: 'exposure' });
    slider.addEventListener('input', () => ((this.stops = Number(slider.value)), this.show()));
    const reset = button('Reset', () => ((slider.value = '0'), (this.stops = 0), this.show()));
    this.exposureText = element('output', { for: 'exposure' });
    const curve = element('select', { id: 'curve' }, CURVES.map((name) => element('option', { value: name, text: name })));
    curve.value = CURVES[this.curve];
    curve.addEventListener('change', () => {
      this.curve = curve.selectedIndex;
      if (this.mode !== FALSE_COLOURS) this.mode = this.curve;
      this.show();
    });
    return element('div', { class: 'toolbar', role: 'toolbar', 'aria-label': 'Light' }, [
      element('label', { for: 'exposure', text: 'Exposure' }), slider, reset, this.exposureText,
      element('label', { for: 'curve', text: 'Curve' }), curve,
      button('False colours', (on) => ((this.mode = on ? FALSE_COLOURS : this.curve), this.show()), this.mode === FALSE_COLOURS),
      button('Mesh', (on) => this.stage.apply({ edges: on }), false),
      button('Backs', (on) => this.stage.apply({ backs: on }), false),
      button('Whole model', () => this.stages.showWhole()),
    ]);
  }

  async start(views, geometry, packed) {
    const aside = document.querySelector('.stage');
    this.stages = new Stages(views, geometry);
    this.stages.frame.append(this.makeLegend());
    aside.append(this.makeToolbar(), this.stages.frame, this.reading, element('p', {
      class: 'keys', text: `${this.light.elements.toLocaleString('en')} elements. Drag to turn, wheel to zoom, right button to move.`,
    }));
    aside.hidden = false;
    document.documentElement.classList.add('has-stage');
    this.stages.start();
    this.stage = this.stages.now;
    this.stage.options.edges = false;
    await this.stages.show(0);
    const { surface } = this.stage.model;
    const radiosity = await unpackLight(packed, surface.geometry.getAttribute('position').count, this.light.largest);
    surface.geometry.setAttribute('radiosity', new THREE.BufferAttribute(radiosity, 3));
    surface.material = this.material;
    this.stage.place(this.stage.fitted(views.now.get(0).camera));
    this.show();
    this.watchClicks();
  }

  watchClicks() {
    const { canvas } = this.stage;
    let down = null;
    canvas.addEventListener('pointerdown', (event) => (down = [event.offsetX, event.offsetY]));
    canvas.addEventListener('pointerup', (event) => {
      if (down && Math.hypot(event.offsetX - down[0], event.offsetY - down[1]) < 4) this.read(event.offsetX, event.offsetY);
    });
    canvas.addEventListener('keydown', (event) => {
      const turn = { ArrowLeft: [-6, 0], ArrowRight: [6, 0], ArrowUp: [0, 6], ArrowDown: [0, -6], '+': [0, 0, 0.85], '-': [0, 0, 1 / 0.85] }[event.key];
      if (event.key === 'Escape') this.stages.showWhole();
      if (!turn || event.ctrlKey || event.metaKey || event.altKey) return;
      event.preventDefault();
      this.stages.turn(...turn);
    });
  }

  // The radiosity under a point of the canvas, CSS pixels; null where there is nothing.
  radiosityAt(x, y) {
    const { canvas, camera, model } = this.stage;
    const ray = new THREE.Raycaster();
    ray.setFromCamera(new THREE.Vector2((2 * x) / canvas.clientWidth - 1, 1 - (2 * y) / canvas.clientHeight), camera);
    const [hit] = ray.intersectObject(model.surface);
    if (!hit?.face) return null;
    const { geometry } = model.surface;
    const position = geometry.getAttribute('position');
    const value = geometry.getAttribute('radiosity');
    const corners = [hit.face.a, hit.face.b, hit.face.c];
    const places = corners.map((corner) => new THREE.Vector3().fromBufferAttribute(position, corner));
    const share = THREE.Triangle.getBarycoord(model.surface.worldToLocal(hit.point.clone()), ...places, new THREE.Vector3());
    const shares = share.toArray();
    return [0, 1, 2].map((channel) => corners.reduce((sum, corner, i) => sum + shares[i] * value.getComponent(corner, channel), 0));
  }

  read(x, y) {
    const b = this.radiosityAt(x, y);
    this.reading.textContent = b
      ? `Radiosity ${short(luminance(b))} W/m² by luminance: red ${short(b[0])}, green ${short(b[1])}, blue ${short(b[2])}`
      : 'Nothing there.';
  }
}

export async function startViewer() {
  document.documentElement.classList.add('scripted');
  const text = (name) => document.querySelector(`script.${name}`).textContent;
  const light = JSON.parse(document.getElementById('light').textContent);
  const views = { now: new Map([[0, await unpackJson(text('view'))]]) };
  const viewer = new Viewer(light);
  await viewer.start(views, () => text('geometry'), text('light'));
  return viewer;
}
