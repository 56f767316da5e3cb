// The room Probe: a pixel of a picture, the vectors at its point drawn in the scene, and every term of its colour.

import { choice, drawing, element, group, table } from './dom.js';
import { number, text } from './texts.js';
import { draggable, figure, put } from './canvas.js';
import { PICTURES } from './link.js';
import { lightGroups, meshGroup, stateSlider, viewOf } from './mesh-controls.js';

/** The side of the picture in pixels, whatever the page's width: a link names the same pixel everywhere. */
const SIDE = 512;
/** The names of vectors, with the classes of their colours. */
const ARROWS = ['N', 'L', 'V', 'R', 'H'];

/**
 * Arrows over a picture of a size.
 * @param {any} svg
 * @param {[number, number]} size
 * @param {{ name: string, from: [number, number], to: [number, number] }[]} arrows
 */
export function drawArrows(svg, [width, height], arrows) {
  svg.setAttribute('viewBox', `0 0 ${width} ${height}`);
  const unit = Math.max(width, height) / 480;
  const margin = 14 * unit;
  /** @type {[number, number][]} */
  const taken = [];
  /** The first place for a name that is in the picture and free: at its arrow, or on a circle around it. @param {number} x @param {number} y */
  const free = (x, y) => {
    const around = [0, 1, 2, 3, 4, 5, 6, 7].flatMap((k) => [1.5, 2.5].map((turns) => [turns * margin * Math.cos(k * Math.PI / 4), turns * margin * Math.sin(k * Math.PI / 4)]));
    const places = [[0, 0], ...around].map(([dx, dy]) => /** @type {[number, number]} */ ([x + dx, y + dy]));
    const isFree = (/** @type {[number, number]} */ [a, b]) => a > margin && a < width - margin && b > margin && b < height - margin
      && taken.every(([c, d]) => Math.hypot(a - c, b - d) > 1.4 * margin);
    const place = places.find(isFree) ?? places[0];
    taken.push(place);
    return place;
  };
  svg.replaceChildren(...arrows.flatMap(({ name, from, to }) => {
    const [dx, dy] = [to[0] - from[0], to[1] - from[1]];
    const whole = Math.hypot(dx, dy) || 1;
    const [ux, uy] = [dx / whole, dy / whole];
    // An arrow out of the picture ends at its border.
    const limit = (/** @type {number} */ at, /** @type {number} */ d, /** @type {number} */ side) => (d > 0 ? (side - margin - at) / d : d < 0 ? (margin - at) / d : Infinity);
    const length = Math.min(whole, Math.max(0, limit(from[0], ux, width)), Math.max(0, limit(from[1], uy, height)));
    const tip = [from[0] + length * ux, from[1] + length * uy];
    const written = (/** @type {number} */ x, /** @type {number} */ y) => {
      const [left, top] = free(x, y);
      return drawing('text', { class: `name ${name}`, x: left, y: top + 5 * unit, 'font-size': 17 * unit, 'stroke-width': 4 * unit, 'text-anchor': 'middle' }, name);
    };
    // It points at the viewer, as V does: a name without a shaft.
    if (length < margin) return [written(from[0] - 15 * unit, from[1] + 17 * unit)];
    const barbs = [-1, 1].map((side) => `${tip[0] - 9 * unit * (ux - side * 0.45 * uy)},${tip[1] - 9 * unit * (uy + side * 0.45 * ux)}`);
    const ends = { x1: from[0], y1: from[1], x2: tip[0], y2: tip[1] };
    return [
      drawing('line', { class: `halo`, ...ends, 'stroke-width': 6 * unit }),
      drawing('line', { class: `arrow ${name}`, ...ends, 'stroke-width': 3 * unit }),
      drawing('polygon', { class: `tip ${name}`, points: `${tip.join()} ${barbs.join(' ')}` }),
      written(tip[0] + 12 * unit * ux, tip[1] + 12 * unit * uy),
    ];
  }));
}

/**
 * The terms of a pixel, each with its name; none if nothing is lit there. Under Gouraud shading those of each vertex.
 * @param {any} report
 */
export function termRows(report) {
  /** @type {(string | Node)[][]} */
  const rows = [];
  const point = report.samples[0];
  const lit = point?.lit?.every((/** @type {any} */ it) => it.light?.lights.length) ? point.lit : [];
  const vector = (/** @type {number[] | null} */ v) => (v ? `(${v.map((x) => number(x, 5)).join('; ')})` : '–');
  const name = (/** @type {string} */ letter) => element('span', { class: `letter ${letter}` }, letter);
  lit.forEach((/** @type {any} */ { light, share }, /** @type {number} */ k) => {
    if (lit.length > 1) rows.push([text('share-of-vertex', { vertex: point.vertices[k] ?? k }), number(share, 6)]);
    rows.push([name('N'), vector(light.normal)], [name('V'), vector(light.view)], [text('term-ambient'), vector(light.ambient)]);
    light.lights.forEach((/** @type {any} */ lamp) => {
      if (light.lights.length > 1) rows.push([text('lamp-number', { number: lamp.light }), '']);
      rows.push([name('L'), vector(lamp.towards)]);
      if (lamp.attenuation !== 1) rows.push([text('attenuation'), number(lamp.attenuation, 7)]);
      rows.push([name('R'), vector(lamp.reflected)], [name('H'), vector(lamp.half)],
        ['N·L', number(lamp.n_dot_l, 7)], ['V·R', number(lamp.v_dot_r, 7)], ['N·H', lamp.n_dot_h === null ? '–' : number(lamp.n_dot_h, 7)]);
      if (lamp.highlight) {
        rows.push([`(${lamp.highlight.cosine_of})ⁿ, n = ${number(lamp.highlight.exponent)}`, number(lamp.highlight.power, 7)]);
      }
      for (const [key, term] of [[text('term-diffuse'), lamp.diffuse], [text('term-specular'), lamp.specular]]) {
        if (vector(term.literal) !== vector(term.guarded)) rows.push([`${key}, ${text('without-guards')}`, vector(term.literal)]);
        rows.push([key, vector(term.guarded)]);
      }
    });
    rows.push([lit.length > 1 ? text('light-there') : text('term-sum'), vector(light.sum)]);
  });
  if (lit.length > 1) rows.push([text('term-sum'), vector(report.linear)]);
  return rows;
}

/** @param {import('./mesh-controls.js').Lab} lab */
export function probeRoom(lab) {
  const controls = element('div', { class: 'controls' });
  const view = figure(text('alt-probe'), text('probe-hint'));
  const arrows = drawing('svg', { class: 'arrows', 'aria-hidden': 'true' });
  view.stage.append(arrows);
  const terms = element('div', { class: 'terms', 'aria-live': 'polite' });
  const full = element('details', {}, element('summary', {}, text('probe-text')), element('pre', { tabindex: 0, lang: 'en' }));
  const room = element('div', { class: 'room with-controls' },
    element('div', { class: 'main' },
      element('p', { class: 'lead' }, text('probe-lead')),
      element('div', { class: 'split' }, view.element, element('div', {}, terms, full))),
    controls);

  draggable(view.stage, (x, y, dragging) => {
    const share = (/** @type {number} */ z) => Math.round(10_000 * Math.max(0, Math.min(0.9999, z))) / 10_000;
    lab.update({ px: share(x), py: share(y) }, dragging);
  });

  function fill() {
    const { light, material } = lightGroups(lab);
    const place = (/** @type {string} */ name) => stateSlider(lab, name, { min: 0, max: 0.999, step: 0.001 });
    controls.replaceChildren(
      group(text('pixel'), place('px'), place('py'),
        choice({
          label: text('shading'), name: 'picture', value: lab.state.picture,
          options: PICTURES.map((kind) => [kind, text(`picture-${kind}`)]),
          chosen: (picture) => lab.update({ picture }),
        })),
      material, light, meshGroup(lab));
  }

  /** @param {any} value */
  function showTerms(value) {
    const { report } = value;
    const rows = termRows(report);
    if (!rows.length) {
      terms.replaceChildren(element('p', {}, text('background-only')));
      return;
    }
    rows.push([text('codes-8'), `(${report.picture.join(', ')})`]);
    terms.replaceChildren(table(text('terms', { x: report.pixel[0], y: report.pixel[1] }), [], rows));
  }

  /** @param {boolean} dragging */
  async function draw(dragging) {
    const side = dragging ? SIDE / 2 : SIDE;
    const size = /** @type {[number, number]} */ ([side, side]);
    const request = { ...viewOf(lab.state, size), creases: false, hairs: false, wire: false };
    const picture = lab.state.picture;
    const pixel = [lab.state.px, lab.state.py].map((share) => Math.floor(share * side));
    try {
      const answer = await lab.program.latest('draw', { verb: 'draw', view: request, pictures: [picture], marks: [] });
      const drawn = answer?.value.pictures[0];
      view.stage.hidden = Boolean(drawn?.missing);
      view.note.hidden = !drawn?.missing;
      if (drawn?.missing) {
        view.note.textContent = text(drawn.missing);
        terms.replaceChildren();
        full.hidden = true;
        return;
      }
      full.hidden = false;
      view.canvas.dataset.file = `${lab.state.subject}-${lab.state.picture}`;
      if (answer) put(view.canvas, size, answer.buffers[0]);
      const probed = await lab.program.latest('probe', { verb: 'probe', view: request, picture, pixel });
      if (!probed) return;
      drawArrows(arrows, size, probed.value.arrows);
      const at = { cx: pixel[0] + 0.5, cy: pixel[1] + 0.5, r: size[0] / 90 };
      arrows.append(drawing('circle', { class: 'spot halo', ...at }), drawing('circle', { class: 'spot', ...at }));
      showTerms(probed.value);
      const pre = full.querySelector('pre');
      if (pre) pre.textContent = probed.value.text;
      room.dataset.drawn = String(Number(room.dataset.drawn ?? 0) + 1);
    } catch (error) {
      lab.fail(error);
    }
  }

  return { element: room, fill, draw };
}
