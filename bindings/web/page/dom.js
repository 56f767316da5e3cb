// Elements: making them, sliders, choices, switches.

import { number, text } from './texts.js';

/**
 * An element with attributes, listeners (`onclick`) and children.
 * @param {string} name
 * @param {Record<string, any>} [attributes]
 * @param {...(Node | string | null | undefined)} children
 * @returns {any}
 */
export function element(name, attributes = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) {
    if (value === undefined || value === false || value === null) continue;
    if (key.startsWith('on')) made.addEventListener(key.slice(2), value);
    else if (key === 'html') made.innerHTML = value;
    else if (key === 'value' || key === 'checked') /** @type {any} */ (made)[key] = value;
    else made.setAttribute(key, value === true ? '' : String(value));
  }
  made.append(...children.filter((child) => child !== null && child !== undefined).map((child) => child ?? ''));
  return made;
}

/**
 * @param {string} name
 * @param {Record<string, string | number>} [attributes]
 * @param {...(Node | string)} children
 * @returns {any}
 */
export function drawing(name, attributes = {}, ...children) {
  const made = document.createElementNS('http://www.w3.org/2000/svg', name);
  Object.entries(attributes).forEach(([key, value]) => made.setAttribute(key, String(value)));
  made.append(...children);
  return made;
}

/** Text whose single letters after `_` are subscripts, as in `k_a`. @param {string} words */
export function subscripted(words) {
  const parts = words.split(/_(\w)\b/);
  return element('span', {}, ...parts.map((part, k) => (k % 2 ? element('sub', {}, part) : part)));
}

/** Text in which names and commands are between backquotes. @param {string} words */
export function withCode(words) {
  return element('p', {}, ...words.split('`').map((part, k) => (k % 2 ? element('code', {}, part) : part)));
}

let ids = 0;
const nextId = () => `c${++ids}`;

/** A slider with more steps than this has a field for its value. */
const MOST_STEPS = 2000;

/**
 * A slider with its name and value. `moved(value, isDragging)` is called while it moves and once when it rests. Each step changes
 * the value, on a logarithmic scale too.
 * @param {{ label: string, min: number, max: number, step: number, value: number, unit?: string, logarithmic?: boolean,
 *   name?: string, moved: (value: number, dragging: boolean) => void }} it
 */
export function slider({ label, min, max, step, value, unit = '', logarithmic = false, name = '', moved }) {
  const id = nextId();
  const within = (/** @type {number} */ x) => Math.min(max, Math.max(min, Number((Math.round(x / step) * step).toFixed(6))));
  // The different values of a logarithmic scale; the slider holds the place in this list.
  const scale = logarithmic ? [...new Set(Array.from({ length: 1001 }, (_, k) => within(min * (max / min) ** (k / 1000))))] : [];
  const toPosition = (/** @type {number} */ x) => (logarithmic ? Math.max(0, scale.findLastIndex((other) => other <= x)) : x);
  const hasField = !logarithmic && (max - min) / step > MOST_STEPS;
  const shown = hasField
    ? element('input', { type: 'number', min, max, step, 'aria-label': label, onchange: () => moveTo(Number(shown.value), false) })
    : element('output', { for: id });
  const input = element('input', {
    type: 'range',
    id,
    'data-name': name || null,
    min: logarithmic ? 0 : min,
    max: logarithmic ? scale.length - 1 : max,
    step: logarithmic ? 1 : step,
  });
  const show = (/** @type {number} */ x) => {
    const words = `${number(x, 7)}${unit}`;
    if (hasField) shown.value = String(x);
    else shown.textContent = words;
    input.setAttribute('aria-valuetext', words);
  };
  const row = element('div', { class: 'slider' }, element('label', { for: id }, subscripted(label)), shown, input);
  /** Shows another value without a call. */
  row.set = (/** @type {number} */ x) => {
    input.value = String(toPosition(x));
    show(x);
  };
  row.set(value);
  function moveTo(/** @type {number} */ value, /** @type {boolean} */ dragging) {
    const x = within(value);
    show(x);
    if (!dragging) input.value = String(toPosition(x));
    moved(x, dragging);
  }
  const take = (/** @type {boolean} */ dragging) => moveTo(logarithmic ? scale[Number(input.value)] : Number(input.value), dragging);
  input.addEventListener('input', () => take(true));
  input.addEventListener('change', () => take(false));
  return row;
}

/**
 * A choice among values.
 * @param {{ label: string, options: [string, string][], value: string, name?: string, chosen: (value: string) => void }} it
 */
export function choice({ label, options, value, name = '', chosen }) {
  const id = nextId();
  const items = options.map(([key, shown]) => element('option', { value: key }, shown));
  const select = element('select', { id, 'data-name': name || null, onchange: () => chosen(select.value) }, ...items);
  select.value = value;
  return element('div', { class: 'choice' }, element('label', { for: id }, label), select);
}

/** @param {{ label: string, value: boolean, name?: string, toggled: (on: boolean) => void }} it */
export function toggle({ label, value, name = '', toggled }) {
  const id = nextId();
  const input = element('input', {
    type: 'checkbox', id, checked: value, 'data-name': name || null, onchange: () => toggled(input.checked),
  });
  return element('div', { class: 'toggle' }, input, element('label', { for: id }, label));
}

/**
 * @param {string} label
 * @param {() => void} pressed
 * @param {Record<string, any>} [attributes]
 */
export function button(label, pressed, attributes = {}) {
  return element('button', { type: 'button', onclick: pressed, ...attributes }, label);
}

/**
 * A group of controls under a heading.
 * @param {string} title
 * @param {...(Node | null)} children
 */
export function group(title, ...children) {
  return element('fieldset', {}, element('legend', {}, title), ...children);
}

/**
 * A table with a caption. Cells are HTML of the program, or text.
 * @param {string} caption
 * @param {string[]} headings
 * @param {(string | Node)[][]} rows
 * @param {{ html?: boolean }} [options]
 */
export function table(caption, headings, rows, { html = false } = {}) {
  const cell = (/** @type {string | Node} */ content, /** @type {number} */ column) => {
    const attributes = column === 0 ? { scope: 'row' } : {};
    const name = column === 0 ? 'th' : 'td';
    if (html && typeof content === 'string') return element(name, { ...attributes, html: content });
    return element(name, attributes, content);
  };
  const head = headings.length
    ? element('thead', {}, element('tr', {}, ...headings.map((name) => element('th', { scope: 'col' }, name))))
    : null;
  const body = element('tbody', {}, ...rows.map((row) => element('tr', {}, ...row.map(cell))));
  const inner = element('table', {}, element('caption', {}, caption), head, body);
  return element('div', { class: 'wide', tabindex: 0, role: 'region', 'aria-label': caption }, inner);
}

/** A block of commands with a button that copies them. @param {string[]} commands */
export function commandBlock(commands) {
  const code = element('pre', { tabindex: 0 }, element('code', {}, commands.join('\n')));
  const copy = button(text('copy'), () => {
    navigator.clipboard?.writeText(commands.join('\n')).then(() => { copy.textContent = text('copied'); });
  }, { class: 'small' });
  return element('div', { class: 'command' }, code, copy);
}

/** Offers bytes as a file. @param {string} name @param {Blob} blob */
export function download(name, blob) {
  const address = URL.createObjectURL(blob);
  const link = element('a', { href: address, download: name });
  link.click();
  setTimeout(() => URL.revokeObjectURL(address), 10_000);
}
