// The page of a report comes readable as it is; this adds what can be clicked: filters, the 3-D view, keys.
import { element } from './element.js';
import { Filters } from './filters.js';
import { Stages } from './stages.js';
import { unpackJson } from './unpack.js';
import { startViewer } from './viewer.js';

const findings = [...document.querySelectorAll('.finding')];
const views = {};
const geometry = (side, model) =>
  document.querySelector(`script.geometry[data-model="${model}"][data-side="${side}"]`).textContent;
const hasView = (model) => Object.values(views).some((side) => side.has(model));

let stage = null;
let chosen = null;

const modelOf = (item) => Number(item.dataset.model);
const number = (text) => (text ? Number(text) : null);
const faultsOf = (item) => ({ now: number(item.dataset.fault), old: number(item.dataset.oldFault) });
const listed = () => findings.filter((item) => !item.hidden);

function mark(item) {
  chosen?.removeAttribute('aria-current');
  chosen = item;
  chosen?.setAttribute('aria-current', 'true');
}

// Where a finding is, in words and in space. `focus` moves the keyboard there as well.
async function choose(item, { focus = true } = {}) {
  mark(item);
  item.closest('details')?.setAttribute('open', '');
  if (focus) item.focus({ preventScroll: true });
  bringIntoView(item);
  if (stage && hasView(modelOf(item))) {
    caption.textContent = `${item.dataset.rule}: ${item.querySelector('.message').textContent}`;
    await stage.showFault(modelOf(item), faultsOf(item));
  }
}

// The finding, and the whole of the 3-D view beside it.
function bringIntoView(item) {
  const canvas = document.querySelector('.canvas')?.getBoundingClientRect();
  const work = document.querySelector('.work');
  if (canvas && (canvas.bottom > innerHeight || canvas.top < 0)) work.scrollIntoView({ block: 'start' });
  item.scrollIntoView({ block: 'nearest' });
}

async function chooseNone() {
  mark(null);
  if (!stage) return;
  caption.textContent = overallCaption();
  await stage.showWhole();
}

function step(by) {
  const items = listed();
  if (!items.length) return;
  const at = items.indexOf(chosen);
  const next = at < 0 ? (by > 0 ? 0 : items.length - 1) : Math.min(items.length - 1, Math.max(0, at + by));
  choose(items[next]);
}

const caption = element('p', { class: 'caption', 'aria-live': 'polite' });

function overallCaption() {
  const view = views.now?.get(stage.current) ?? views.old?.get(stage.current);
  if (!view) return '';
  const name = document.getElementById(`model-${stage.current}`).dataset.path;
  const part = view.leftOut ? `, ${view.triangles} of ${view.triangles + view.leftOut} triangles` : '';
  return `${name}${part}`;
}

function switchButton(text, option, on) {
  const button = element('button', { type: 'button', 'aria-pressed': String(on), text });
  button.addEventListener('click', () => {
    const pressed = button.getAttribute('aria-pressed') !== 'true';
    button.setAttribute('aria-pressed', String(pressed));
    stage.apply({ [option]: pressed });
  });
  return button;
}

// Edges of more triangles blacken the model from afar, and cost a machine without a graphics card seconds a picture.
const MOST_EDGED_TRIANGLES = 100_000;

const startsWithEdges = () =>
  Object.values(views).every((side) => [...side.values()].every((view) => view.triangles <= MOST_EDGED_TRIANGLES));

function toolbar() {
  const whole = element('button', { type: 'button', text: 'Whole model', title: 'Escape' });
  whole.addEventListener('click', chooseNone);
  const previous = element('button', { type: 'button', text: '‹', title: 'Previous finding (K)', 'aria-label': 'Previous finding' });
  previous.addEventListener('click', () => step(-1));
  const next = element('button', { type: 'button', text: '›', title: 'Next finding (J)', 'aria-label': 'Next finding' });
  next.addEventListener('click', () => step(1));
  return element('div', { class: 'toolbar', role: 'toolbar', 'aria-label': '3-D view' }, [
    previous,
    next,
    whole,
    switchButton('Backs', 'backs', false),
    switchButton('See through', 'seeThrough', false),
    switchButton('Edges', 'edges', startsWithEdges()),
  ]);
}

const TURN_DEG = 6;
const CANVAS_KEYS = {
  ArrowLeft: () => stage.turn(-TURN_DEG, 0),
  ArrowRight: () => stage.turn(TURN_DEG, 0),
  ArrowUp: () => stage.turn(0, TURN_DEG),
  ArrowDown: () => stage.turn(0, -TURN_DEG),
  '+': () => stage.turn(0, 0, 0.85),
  '=': () => stage.turn(0, 0, 0.85),
  '-': () => stage.turn(0, 0, 1 / 0.85),
};

function helpLine() {
  const key = (text) => element('kbd', { text });
  return element('p', { class: 'keys' }, [
    'Drag to turn, wheel to zoom, right button to move. ',
    ...[key('J'), ' ', key('K'), ' next and previous finding, ', key('/'), ' search, ', key('Esc'), ' whole model'],
  ]);
}

function watchCanvas(canvas) {
  canvas.addEventListener('keydown', (event) => {
    const act = CANVAS_KEYS[event.key];
    if (!act || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    act();
  });
}

function makeStage() {
  if (!Object.keys(views).length) return;
  const aside = document.querySelector('.stage');
  const stages = new Stages(views, geometry);
  aside.append(toolbar(), stages.frame, caption, helpLine());
  aside.hidden = false;
  document.documentElement.classList.add('has-stage');
  try {
    stages.start();
  } catch {
    document.documentElement.classList.remove('has-stage');
    aside.replaceChildren(element('p', { class: 'remark', text: 'This browser shows no 3-D; the pictures stand beside the findings.' }));
    return;
  }
  stage = stages;
  stage.apply({ edges: startsWithEdges() });
  stage.clicked = (side, model, fault) => {
    const name = side === 'old' ? 'old-fault' : 'fault';
    const item = document.querySelector(`.finding[data-model="${model}"][data-${name}="${fault}"]`);
    if (item) choose(item, { focus: false });
  };
  for (const { canvas } of stages.canvases) watchCanvas(canvas);
}

function watchFindings() {
  for (const item of findings) {
    item.tabIndex = 0;
    const button = item.querySelector('.fly');
    if (button && stage) button.hidden = false;
    item.addEventListener('click', (event) => {
      if (event.target.closest('a, summary, details')) return;
      if (!event.target.closest('.fly, .thumb')) return;
      choose(item);
    });
    item.addEventListener('keydown', (event) => {
      if (event.target !== item) return;
      if (event.key === 'Enter') choose(item);
      if (event.key === 'ArrowDown' || event.key === 'ArrowUp') {
        event.preventDefault();
        const items = listed();
        items[items.indexOf(item) + (event.key === 'ArrowDown' ? 1 : -1)]?.focus();
      }
    });
  }
}

function watchKeys(filters) {
  document.addEventListener('keydown', (event) => {
    if (event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.key === 'Escape') {
      const back = chosen;
      if (document.activeElement === filters?.text) filters.text.blur();
      chooseNone();
      back?.focus({ preventScroll: true });
      return;
    }
    if (event.target.closest('input, select, textarea')) return;
    if (event.key === 'j') step(1);
    else if (event.key === 'k') step(-1);
    else if (event.key === '/' && filters) {
      event.preventDefault();
      filters.text.focus();
    }
  });
}

function hideInStage() {
  if (!stage) return;
  for (const [side, models] of Object.entries(views)) {
    for (const model of models.keys()) {
      const hidden = findings.filter((item) => item.hidden && modelOf(item) === model);
      stage.hideFaults(side, model, new Set(hidden.map((item) => faultsOf(item)[side])));
    }
  }
}

function addDownload() {
  const link = element('a', { href: '#', text: 'Save the JSON report' });
  link.addEventListener('click', () => {
    const report = JSON.parse(document.getElementById('report').textContent);
    link.href = URL.createObjectURL(new Blob([JSON.stringify(report, null, 2)], { type: 'application/json' }));
    link.download = 'radlint.json';
  });
  if (document.getElementById('report')) document.querySelector('footer').append(element('p', {}, [link]));
}

async function readViews() {
  for (const script of document.querySelectorAll('script.view')) {
    const { side, model } = script.dataset;
    views[side] ??= new Map();
    views[side].set(Number(model), await unpackJson(script.textContent));
  }
}

async function start() {
  document.documentElement.classList.add('scripted');
  await readViews();
  makeStage();
  let filters = null;
  if (findings.length) {
    filters = new Filters(findings, hideInStage);
    document.querySelector('.list').prepend(filters.form);
  }
  watchFindings();
  watchKeys(filters);
  addDownload();
  if (!stage) return;
  const first = findings.find((item) => hasView(modelOf(item)));
  await stage.show(first ? modelOf(first) : Object.values(views)[0].keys().next().value);
  hideInStage();
  caption.textContent = overallCaption();
  for (const link of document.querySelectorAll('table.files a')) {
    link.addEventListener('click', async () => {
      const model = Number(link.hash.replace('#model-', ''));
      if (hasView(model)) {
        mark(null);
        await stage.show(model);
        caption.textContent = overallCaption();
      }
    });
  }
}

// For tests: the view, and a promise that the first model stands in it; of a solution the viewer.
if (document.getElementById('light')) window.radfix = { ready: startViewer() };
else window.radlint = { ready: start(), stage: () => stage?.now, stages: () => stage, choose };
