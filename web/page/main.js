// The page of a report comes readable as it is; this adds what can be clicked: filters, the 3-D view, keys.
import { element } from './element.js';
import { Filters } from './filters.js';
import { Stage } from './stage.js';
import { unpackJson } from './unpack.js';

const findings = [...document.querySelectorAll('.finding')];
const views = new Map();
const geometry = (model) => document.querySelector(`script.geometry[data-model="${model}"]`).textContent;

let stage = null;
let chosen = null;

const modelOf = (item) => Number(item.dataset.model);
const faultOf = (item) => Number(item.dataset.fault);
const listed = () => findings.filter((item) => !item.hidden);

function mark(item) {
  chosen?.removeAttribute('aria-current');
  chosen = item;
  chosen?.setAttribute('aria-current', 'true');
}

// Where a finding is, in words and in space. `focus` moves the keyboard there as well.
async function choose(item, { focus = true } = {}) {
  mark(item);
  if (focus) item.focus({ preventScroll: true });
  bringIntoView(item);
  if (stage && views.has(modelOf(item))) {
    caption.textContent = `${item.dataset.rule}: ${item.querySelector('.message').textContent}`;
    await stage.showFault(modelOf(item), faultOf(item));
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
  const view = views.get(stage.current);
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
    switchButton('Edges', 'edges', true),
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

function makeStage() {
  if (!views.size) return;
  const aside = document.querySelector('.stage');
  const canvas = element('canvas', {
    tabindex: '0',
    role: 'application',
    'aria-label': '3-D view of the model. Arrow keys turn it, plus and minus zoom, Escape shows the whole model.',
  });
  const help = element('p', { class: 'keys' }, [
    'Drag to turn, wheel to zoom, right button to move. ',
    element('kbd', { text: 'J' }),
    ' ',
    element('kbd', { text: 'K' }),
    ' next and previous finding, ',
    element('kbd', { text: '/' }),
    ' search, ',
    element('kbd', { text: 'Esc' }),
    ' whole model',
  ]);
  aside.append(toolbar(), element('div', { class: 'canvas' }, [canvas]), caption, help);
  aside.hidden = false;
  try {
    stage = new Stage(canvas, views, geometry);
  } catch {
    aside.replaceChildren(element('p', { class: 'remark', text: 'This browser shows no 3-D; the pictures stand beside the findings.' }));
    return;
  }
  document.documentElement.classList.add('has-stage');
  stage.resize();
  stage.clicked = (model, fault) => {
    const item = document.getElementById(`f-${model}-${fault}`);
    if (item) choose(item, { focus: false });
  };
  canvas.addEventListener('keydown', (event) => {
    const act = CANVAS_KEYS[event.key];
    if (!act || event.ctrlKey || event.metaKey || event.altKey) return;
    event.preventDefault();
    act();
  });
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
  for (const model of views.keys()) {
    const hidden = findings.filter((item) => item.hidden && modelOf(item) === model).map(faultOf);
    stage.hideFaults(model, new Set(hidden));
  }
}

function addDownload() {
  const link = element('a', { href: '#', text: 'Save the JSON report' });
  link.addEventListener('click', () => {
    const report = JSON.parse(document.getElementById('report').textContent);
    link.href = URL.createObjectURL(new Blob([JSON.stringify(report, null, 2)], { type: 'application/json' }));
    link.download = 'radlint.json';
  });
  document.querySelector('footer').append(element('p', {}, [link]));
}

async function readViews() {
  for (const script of document.querySelectorAll('script.view')) {
    views.set(Number(script.dataset.model), await unpackJson(script.textContent));
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
  const first = findings.find((item) => views.has(modelOf(item)));
  await stage.show(first ? modelOf(first) : views.keys().next().value);
  hideInStage();
  caption.textContent = overallCaption();
  for (const link of document.querySelectorAll('table.files a')) {
    link.addEventListener('click', async () => {
      const model = Number(link.hash.replace('#model-', ''));
      if (views.has(model)) {
        mark(null);
        await stage.show(model);
        caption.textContent = overallCaption();
      }
    });
  }
}

// For tests: the view, and a promise that the first model stands in it.
window.radlint = { ready: start(), stage: () => stage, choose };
