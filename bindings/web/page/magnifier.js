// The magnifier: the 8-bit codes of the pixels around a point, and the luminance along a line that is drawn on a picture.

import { button, drawing, element } from './dom.js';
import { number, text } from './texts.js';
import { plot } from './plot.js';
import { draggable } from './canvas.js';

/** Pixels on each side of the magnified one. */
const REACH = 4;
/** The coordinates of the ends of a line. */
const NAMES = ['x₁', 'y₁', 'x₂', 'y₂'];

/** The linear luminance of 8-bit sRGB codes (Rec. 709 primaries). @param {ArrayLike<number>} codes */
function luminanceOf(codes) {
  const linear = [0, 1, 2].map((k) => {
    const coded = codes[k] / 255;
    return coded <= 0.04045 ? coded / 12.92 : ((coded + 0.055) / 1.055) ** 2.4;
  });
  return 0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2];
}

/**
 * Lets a line be drawn on a picture. `open` shows codes and profile in `panel`, `show` brings them up to date, `close` removes
 * both. `changed` is called with the ends of the line, in shares of the picture, or with `null` when it is closed.
 * @param {HTMLElement} stage
 * @param {HTMLCanvasElement} canvas
 * @param {HTMLElement} panel
 * @param {(ends: number[] | null) => void} changed
 */
export function magnifier(stage, canvas, panel, changed) {
  const line = drawing('svg', { class: 'arrows', viewBox: '0 0 1 1', preserveAspectRatio: 'none', 'aria-hidden': 'true' });
  const stroke = drawing('line', { class: 'profile-line' });
  line.append(stroke);
  /** @type {[number, number, number, number]} */
  let ends = [0, 0.5, 1, 0.5];
  const inputs = NAMES.map((name, k) => element('input', {
    type: 'number', min: 0, step: 1, 'aria-label': `${text('line')} ${name}`,
    onchange: () => {
      const side = k % 2 ? canvas.height : canvas.width;
      ends[k] = Math.max(0, Math.min(1, (Number(inputs[k].value) + 0.5) / side));
      show();
      reportEnds();
    },
  }));
  const codes = element('div', { class: 'wide codes', tabindex: 0, role: 'region', 'aria-label': text('codes') });
  const profile = element('div');
  const content = [
    button('×', () => { close(); changed(null); }, { class: 'small close', 'aria-label': text('close-magnifier') }),
    element('h3', {}, text('magnifier')),
    element('p', { class: 'hint' }, text('magnifier-hint')),
    element('div', { class: 'line-inputs' }, `${text('line')}: `, ...inputs.flatMap((input, k) => [NAMES[k], input])),
    element('div', { class: 'magnifier' }, codes, profile),
  ];

  function show() {
    const context = canvas.getContext('2d', { willReadFrequently: true });
    if (!context || canvas.width < 2) return;
    const { width, height } = canvas;
    const { data } = context.getImageData(0, 0, width, height);
    const pixel = (/** @type {number} */ share, /** @type {number} */ side) => Math.max(0, Math.min(side - 1, Math.floor(share * side)));
    const [x1, y1, x2, y2] = ends.map((share, k) => pixel(share, k % 2 ? height : width));
    [x1, y1, x2, y2].forEach((value, k) => { inputs[k].value = String(value); });
    ['x1', 'y1', 'x2', 'y2'].forEach((name, k) => stroke.setAttribute(name, String(ends[k])));
    const at = (/** @type {number} */ x, /** @type {number} */ y) => data.subarray(4 * (y * width + x), 4 * (y * width + x) + 3);

    const rows = [];
    for (let y = y2 - REACH; y <= y2 + REACH; y++) {
      const cells = [];
      for (let x = x2 - REACH; x <= x2 + REACH; x++) {
        if (x < 0 || y < 0 || x >= width || y >= height) {
          cells.push(element('td', {}, ''));
          continue;
        }
        const own = at(x, y);
        const dark = luminanceOf(own) < 0.18;
        const grey = own[0] === own[1] && own[1] === own[2];
        cells.push(element('td', {
          style: `background: rgb(${own.join()}); color: ${dark ? '#fff' : '#000'}`, class: x === x2 && y === y2 ? 'middle' : null,
        }, grey ? String(own[0]) : `${own[0]} ${own[1]} ${own[2]}`));
      }
      rows.push(element('tr', {}, ...cells));
    }
    codes.replaceChildren(element('table', {}, element('caption', {}, text('codes-at', { x: x2, y: y2 })), element('tbody', {}, ...rows)));

    const steps = Math.max(Math.abs(x2 - x1), Math.abs(y2 - y1), 1);
    /** @type {[number, number][]} */
    const points = [];
    for (let k = 0; k <= steps; k++) {
      const [x, y] = [Math.round(x1 + (x2 - x1) * k / steps), Math.round(y1 + (y2 - y1) * k / steps)];
      points.push([k, luminanceOf(at(x, y))]);
    }
    profile.replaceChildren(plot({
      title: text('profile'), x: text('profile-x'), y: text('profile-y'),
      curves: [{ name: text('profile-range', { low: number(Math.min(...points.map((p) => p[1])), 3), high: number(Math.max(...points.map((p) => p[1])), 3) }), points, mark: 'line' }],
    }));
  }

  /** The line between the middles of its pixels, which a link keeps exactly. */
  function reportEnds() {
    changed(ends.map((share, k) => {
      const side = k % 2 ? canvas.height : canvas.width;
      return (Math.max(0, Math.min(side - 1, Math.floor(share * side))) + 0.5) / side;
    }));
  }

  let listens = false;
  function listen() {
    listens = true;
    draggable(stage, (x, y, dragging, event) => {
      if (!line.isConnected) return;
      const [a, b] = [x, y].map((share) => Math.max(0, Math.min(0.9999, share)));
      if (event.type === 'pointerdown') ends = [a, b, a, b];
      else ends = [ends[0], ends[1], a, b];
      show();
      if (!dragging) reportEnds();
    });
  }

  /** @param {number[]} [at] ends of a line */
  function open(at) {
    if (at?.length === 4 && at.every((share) => share >= 0 && share <= 1)) ends = /** @type {[number, number, number, number]} */ (at);
    panel.replaceChildren(...content);
    panel.hidden = false;
    stage.append(line);
    if (!listens) listen();
    show();
  }

  function close() {
    line.remove();
    panel.hidden = true;
  }

  return { open, show, close };
}
