// Plots as SVG: a measure along a parameter, and a profile of luminance along a line.

import { drawing, element } from './dom.js';
import { number } from './texts.js';

const [WIDTH, HEIGHT, LEFT, BOTTOM, TOP] = [560, 260, 64, 40, 14];

/**
 * @typedef {{ name: string, points: [number, number][], mark: 'line' | 'dots' | 'dashed' }} Curve
 * @param {{ title: string, x: string, y: string, curves: Curve[], here?: number }} it
 */
export function plot({ title, x, y, curves, here }) {
  const points = curves.flatMap((curve) => curve.points).filter((point) => point.every(Number.isFinite));
  const range = (/** @type {number[]} */ values) => {
    const [low, high] = [Math.min(...values), Math.max(...values)];
    const room = high > low ? 0.05 * (high - low) : Math.abs(high) * 0.1 || 1;
    return [low - room, high + room];
  };
  if (!points.length) return element('p', { class: 'hint' }, '–');
  const xs = points.map((point) => point[0]);
  const [left, right] = Math.max(...xs) > Math.min(...xs) ? [Math.min(...xs), Math.max(...xs)] : range(xs);
  const [low, high] = range(points.map((point) => point[1]));
  const px = (/** @type {number} */ v) => LEFT + (v - left) / (right - left) * (WIDTH - LEFT - 16);
  const py = (/** @type {number} */ v) => TOP + (high - v) / (high - low) * (HEIGHT - TOP - BOTTOM);
  const svg = drawing('svg', { viewBox: `0 0 ${WIDTH} ${HEIGHT}`, class: 'plot', role: 'img', 'aria-label': title });
  for (let k = 0; k <= 4; k++) {
    const [vx, vy] = [left + (right - left) * k / 4, low + (high - low) * k / 4];
    svg.append(
      drawing('line', { class: 'grid', x1: LEFT, x2: WIDTH - 16, y1: py(vy), y2: py(vy) }),
      drawing('text', { x: LEFT - 6, y: py(vy) + 4, 'text-anchor': 'end' }, number(vy, 3)),
      drawing('text', { x: px(vx), y: HEIGHT - BOTTOM + 16, 'text-anchor': 'middle' }, number(vx, 3)),
    );
  }
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
    drawing('text', { x: (LEFT + WIDTH) / 2, y: HEIGHT - 6, 'text-anchor': 'middle' }, x),
    drawing('text', { transform: `translate(14 ${HEIGHT / 2}) rotate(-90)`, 'text-anchor': 'middle' }, y),
  );
  const keys = curves.map((curve, index) => element('li', { class: `key s${index} ${curve.mark}` }, curve.name));
  return element('div', { class: 'plot-box' }, element('h3', {}, title), svg, element('ul', { class: 'keys' }, ...keys));
}
