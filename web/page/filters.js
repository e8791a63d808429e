// Which findings are listed: by severity, rule, object and text.
import { element } from './element.js';

const SEVERITIES = ['error', 'warning', 'note'];
const LISTED_NAMES = 500;

function counted(items, key) {
  const counts = new Map();
  for (const item of items) for (const value of key(item)) counts.set(value, (counts.get(value) ?? 0) + 1);
  return [...counts].sort(([a], [b]) => (a < b ? -1 : 1));
}

function choice(label, everything, counts) {
  const select = element('select', {}, [
    element('option', { value: '', text: everything }),
    ...counts.slice(0, LISTED_NAMES).map(([name, count]) => element('option', { value: name, text: `${name} (${count})` })),
  ]);
  return { select, field: element('label', {}, [element('span', { text: label }), select]) };
}

// Of all findings, listed or only counted; nothing where the page does not count severities.
function totalOf(severity) {
  const badge = document.querySelector(`.counts .${severity}[data-count]`);
  return badge ? Number(badge.dataset.count) : null;
}

const objectsOf = (item) => (item.dataset.objects ?? '').split('\n').filter(Boolean);

export class Filters {
  constructor(findings, changed) {
    this.findings = findings;
    this.changed = changed;
    this.texts = findings.map((item) => item.textContent.toLowerCase());
    this.toggles = SEVERITIES.map((severity) => this.toggle(severity));
    const rules = choice('Rule', 'All rules', counted(findings, (item) => [item.dataset.rule]));
    const objects = choice('Object', 'All objects', counted(findings, objectsOf));
    const changes = choice('Change', 'All', counted(findings, (item) => [item.dataset.status ?? '']));
    this.change = changes.select;
    changes.field.hidden = !findings.some((item) => item.dataset.status);
    this.rule = rules.select;
    this.object = objects.select;
    this.text = element('input', { type: 'search', placeholder: 'Message, material, line…' });
    this.tally = element('output', { class: 'tally', 'aria-live': 'polite' });
    const totals = SEVERITIES.map(totalOf);
    this.found = totals.includes(null) ? findings.length : totals.reduce((sum, total) => sum + total, 0);
    this.form = element('form', { class: 'filters', role: 'search', 'aria-label': 'Filter findings' }, [
      element('fieldset', {}, [element('legend', { text: 'Severity' }), ...this.toggles]),
      changes.field,
      rules.field,
      objects.field,
      element('label', {}, [element('span', { text: 'Text' }), this.text]),
      this.tally,
    ]);
    this.form.addEventListener('submit', (event) => event.preventDefault());
    for (const control of [this.change, this.rule, this.object]) control.addEventListener('change', () => this.apply());
    this.text.addEventListener('input', () => this.apply());
    this.apply();
  }

  toggle(severity) {
    const count = this.findings.filter((item) => item.dataset.severity === severity).length;
    const total = totalOf(severity) ?? count;
    const button = element('button', {
      type: 'button',
      class: `toggle ${severity}`,
      'aria-pressed': 'true',
      text: `${severity[0].toUpperCase()}${severity.slice(1)}s ${count}${total > count ? ` of ${total}` : ''}`,
    });
    if (total > count) button.title = `${count} of ${total} are listed: at most so many of a rule as --max-issues says`;
    button.dataset.severity = severity;
    button.disabled = count === 0;
    button.addEventListener('click', () => {
      button.setAttribute('aria-pressed', button.getAttribute('aria-pressed') === 'true' ? 'false' : 'true');
      this.apply();
    });
    return button;
  }

  matches(item, index, severities, words) {
    return (
      severities.has(item.dataset.severity) &&
      (!this.change.value || item.dataset.status === this.change.value) &&
      (!this.rule.value || item.dataset.rule === this.rule.value) &&
      (!this.object.value || objectsOf(item).includes(this.object.value)) &&
      words.every((word) => this.texts[index].includes(word))
    );
  }

  apply() {
    const pressed = this.toggles.filter((button) => button.getAttribute('aria-pressed') === 'true');
    const severities = new Set(pressed.map((button) => button.dataset.severity));
    const words = this.text.value.toLowerCase().split(/\s+/).filter(Boolean);
    let shown = 0;
    this.findings.forEach((item, index) => {
      item.hidden = !this.matches(item, index, severities, words);
      if (!item.hidden) ++shown;
    });
    for (const section of document.querySelectorAll('section.rule')) {
      section.hidden = !section.querySelector('.finding:not([hidden])');
    }
    const listed = this.findings.length;
    this.tally.textContent =
      this.found > listed ? `${shown} of ${listed} listed, ${this.found} found` : `${shown} of ${listed} findings`;
    this.changed();
  }
}
