// Plots as SVG: a measure along a parameter, and a profile of luminance along a line.

import { drawing, element } from './dom.js';
import { number } from './texts.js';

const [HEIGHT, LEFT, BOTTOM, TOP] = [260, 64, 40, 14];

/**
 * @typedef {{ name: string, points: [number, number][], mark: 'line' | 'dots' | 'dashed' }} Curve
 * @param {{ title: string, x: string, y: string, curves: Curve[], here?: number, width?: number }} it `width` is in units of the font, 12 high
 */
export function plot({ title, x, y, curves, here, width = 560 }) {
  const points = curves.flatMap((curve) => curve.points).filter((point) => point.every(Number.isFinite));
  const range = (/** @type {number[]} */ values) => {
    const [low, high] = [Math.min(...values), Math.max(...values)];
    const isOne = high - low <= 1e-3 * Math.max(Math.abs(low), Math.abs(high));
    const room = isOne ? Math.abs(high) * 0.1 || 1 : 0.05 * (high - low);
    return [low >= 0 ? Math.max(0, low - room) : low - room, high + room];
  };
  // Multiples of 1, 2 or 5 and a power of ten, about five of them.
  const ticks = (/** @type {number} */ from, /** @type {number} */ to, most = 6) => {
    const power = 10 ** Math.floor(Math.log10((to - from) / most));
    const step = [1, 2, 5, 10].map((factor) => factor * power).find((size) => (to - from) / size <= most) ?? power;
    const first = Math.ceil(from / step - 1e-9);
    return Array.from({ length: Math.floor(to / step + 1e-9) - first + 1 }, (_, k) => Number(((first + k) * step).toPrecision(12)));
  };
  if (!points.length) return element('p', { class: 'hint' }, '–');
  const xs = points.map((point) => point[0]);
  const [left, right] = Math.max(...xs) > Math.min(...xs) ? [Math.min(...xs), Math.max(...xs)] : range(xs);
  const [low, high] = range(points.map((point) => point[1]));
  const px = (/** @type {number} */ v) => LEFT + (v - left) / (right - left) * (width - LEFT - 16);
  const py = (/** @type {number} */ v) => TOP + (high - v) / (high - low) * (HEIGHT - TOP - BOTTOM);
  const svg = drawing('svg', { viewBox: `0 0 ${width} ${HEIGHT}`, class: 'plot', role: 'img', 'aria-label': title });
  ticks(low, high).forEach((value) => svg.append(
    drawing('line', { class: 'grid', x1: LEFT, x2: width - 16, y1: py(value), y2: py(value) }),
    drawing('text', { x: LEFT - 6, y: py(value) + 4, 'text-anchor': 'end' }, number(value, 6))));
  ticks(left, right, Math.floor(width / 90)).forEach((value) => svg.append(
    drawing('text', { x: px(value), y: HEIGHT - BOTTOM + 16, 'text-anchor': 'middle' }, number(value, 6))));
  if (here !== undefined && here >= left && here <= right) {
    svg.append(drawing('line', { class: 'here', x1: px(here), x2: px(here), y1: TOP, y2: HEIGHT - BOTTOM }));
  }
  curves.forEach((curve, index) => {
    const own = curve.points.filter((point) => point.every(Number.isFinite));
    if (curve.mark === 'dots') {
      own.forEach(([a, b]) => svg.append(drawing('circle', { class: `series s${index}`, cx: px(a), cy: py(b), r: 4 })));
      return;
    }
    const path = own.map(([a, b]) => `${px(a).toFixed(1)},${py(b).toFixed(1)}`).join(' ');
    svg.append(drawing('polyline', { class: `series s${index} ${curve.mark}`, points: path }));
  });
  svg.append(
    drawing('text', { x: (LEFT + width) / 2, y: HEIGHT - 6, 'text-anchor': 'middle' }, x),
    drawing('text', { transform: `translate(14 ${HEIGHT / 2}) rotate(-90)`, 'text-anchor': 'middle' }, y),
  );
  const keys = curves.map((curve, index) => element('li', { class: `key s${index} ${curve.mark}` }, curve.name));
  return element('div', { class: 'plot-box' }, element('h3', {}, title), svg, element('ul', { class: 'keys' }, ...keys));
}
