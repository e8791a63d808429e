// One stage, or two that show the same place before and after: cameras and switches are common.
import { element } from './element.js';
import { Stage } from './stage.js';

const NAMES = { old: 'Before', now: 'After' };

function canvasElement(side, sides) {
  const canvas = element('canvas', {
    tabindex: '0',
    role: 'application',
    'aria-label': `3-D view of the model${sides.length > 1 ? `, ${NAMES[side].toLowerCase()}` : ''}. Arrow keys turn it, plus and minus zoom, Escape shows the whole model.`,
  });
  const name = sides.length > 1 ? [element('p', { class: 'side', text: NAMES[side] })] : [];
  return { canvas, frame: element('div', { class: 'canvas' }, [canvas, ...name]) };
}

export class Stages {
  // `views` are maps of view data by model, by side; `geometry(side, model)` gives the packed text.
  constructor(views, geometry) {
    this.sides = Object.keys(NAMES).filter((side) => views[side]);
    this.views = views;
    this.clicked = () => {};
    this.frame = element('div', { class: 'frame' });
    this.frame.dataset.sides = this.sides.length;
    this.canvases = this.sides.map((side) => canvasElement(side, this.sides));
    this.frame.append(...this.canvases.map(({ frame }) => frame));
    this.geometry = geometry;
  }

  // To be called once the frame is in the document; throws where there is no WebGL.
  start() {
    this.stages = this.sides.map((side, i) => {
      const stage = new Stage(this.canvases[i].canvas, this.views[side], (model) => this.geometry(side, model));
      stage.clicked = (model, fault) => this.clicked(side, model, fault);
      stage.controls.addEventListener('change', () => this.link(stage));
      return stage;
    });
  }

  get now() {
    return this.stages[this.stages.length - 1];
  }

  get current() {
    return this.now.current;
  }

  link(leader) {
    for (const stage of this.stages) if (stage !== leader) stage.follow(leader);
  }

  // The side that moves the others: the newest that has the model.
  leader() {
    return [...this.stages].reverse().find((stage) => stage.model);
  }

  async show(model) {
    await Promise.all(this.stages.map((stage) => stage.show(model)));
    const leader = this.leader();
    if (leader) this.link(leader);
  }

  // `faults` are numbers by side, null for none.
  async showFault(model, faults) {
    await this.show(model);
    const cameras = await Promise.all(this.stages.map((stage, i) => stage.choose(model, faults[this.sides[i]] ?? null)));
    const goal = cameras.reverse().find((camera) => camera);
    if (goal) await this.leader().fly(goal);
  }

  async showWhole() {
    const leader = this.leader();
    if (!leader) return;
    await Promise.all(this.stages.map((stage) => stage.choose(stage.current, null)));
    await leader.fly(leader.whole());
  }

  hideFaults(side, model, faults) {
    this.stages[this.sides.indexOf(side)].hideFaults(model, faults);
  }

  apply(options) {
    for (const stage of this.stages) stage.apply(options);
  }

  turn(...angles) {
    this.leader()?.turn(...angles);
  }
}
