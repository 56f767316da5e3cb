// The room Inspect: the findings of a mesh, each turning the view to its place.

import { button, commandBlock, drawing, element, group, withCode } from './dom.js';
import { currentLanguage, number, text } from './texts.js';
import { draggable, figure, put, stageWidth } from './canvas.js';
import { dragged, meshGroup, viewOf, viewSliders } from './mesh-controls.js';

/** Places of one finding that are listed. */
const MOST_PLACES = 8;

/** @param {import('./mesh-controls.js').Lab} lab */
export function inspectRoom(lab) {
  const controls = element('div', { class: 'controls' });
  const view = figure(text('alt-inspect'), text('inspect-hint'));
  const marks = drawing('svg', { class: 'arrows', 'aria-hidden': 'true' });
  view.stage.append(marks);
  const list = element('div', { class: 'findings', 'aria-live': 'polite' });
  const room = element('div', { class: 'room with-controls' },
    element('div', { class: 'main' },
      element('p', { class: 'lead' }, text('inspect-lead')),
      element('div', { class: 'split' }, view.element, list)),
    controls);
  let inspected = '';
  /** @type {number[] | null} */
  let mark = null;

  let [fromX, fromY] = [0, 0];
  draggable(view.stage, (x, y, dragging, event) => {
    if (event.type === 'pointerdown') [fromX, fromY] = [x, y];
    const turned = dragged(lab.state, x - fromX, y - fromY);
    [fromX, fromY] = [x, y];
    lab.update(turned, dragging);
  });

  function fill() {
    controls.replaceChildren(meshGroup(lab), group(text('view'), ...viewSliders(lab)));
  }

  /** @param {any} place @param {string} key its finding and its number there */
  function go(place, key) {
    mark = place.position;
    lab.update({ place: key, turn: Math.round(place.turn), tilt: Math.max(-89, Math.min(89, Math.round(place.tilt))) });
    view.element.scrollIntoView({ block: 'nearest' });
  }

  /** @param {any} value */
  function showFindings(value) {
    if (!value.findings.length) {
      list.replaceChildren(element('p', {}, text('no-findings', { name: value.name })));
      return;
    }
    list.replaceChildren(...value.findings.map((/** @type {any} */ finding, /** @type {number} */ index) => {
      const nameOf = (/** @type {any} */ place, /** @type {number} */ k) => (place.line ? text('place-line', { line: place.line })
        : place.face !== null ? text('place-face', { face: place.face }) : text('place', { number: k + 1 }));
      // Several corners of a face are one place.
      const named = new Map(finding.places.map((/** @type {any} */ place, /** @type {number} */ k) => [nameOf(place, k), place]));
      const listed = [...named].slice(0, MOST_PLACES);
      const places = listed.map(([name, place], k) => button(name, () => go(place, `${index}:${k}`), { class: 'small' }));
      const [opened, at] = lab.state.place.split(':').map(Number);
      if (lab.state.place && opened === index) mark = listed[at]?.[1].position ?? null;
      const details = finding.cause[currentLanguage()].slice(finding.title[currentLanguage()].length + 2);
      const amount = `${number(finding.count, 8)}\u00a0/\u00a0${number(finding.of, 8)}`;
      return element('details', { class: `finding ${finding.severity}`, open: Boolean(lab.state.place) && opened === index },
        element('summary', {}, element('span', { class: `role ${finding.severity}` }, text(`severity-${finding.severity}`)),
          ' ', element('strong', {}, finding.title[currentLanguage()]), ` ${amount}`),
        details ? withCode(`${details[0].toUpperCase()}${details.slice(1)}.`) : null,
        withCode(finding.meaning[currentLanguage()]), withCode(finding.advice[currentLanguage()]),
        places.length ? element('div', { class: 'buttons' }, ...places) : null,
        finding.count > places.length && places.length ? element('p', { class: 'hint' }, text('more-places')) : null,
        finding.command ? commandBlock([finding.command]) : null);
    }));
  }

  /** @param {boolean} dragging */
  async function draw(dragging) {
    const most = stageWidth(view.stage, 560);
    const side = dragging ? Math.round(most / 2) : most;
    const size = /** @type {[number, number]} */ ([side, side]);
    const { subject, segments } = lab.state;
    const key = `${subject} ${segments} ${lab.file?.name} ${currentLanguage()}`;
    const request = { ...viewOf(lab.state, size), hairs: false };
    try {
      if (key !== inspected) mark = null;
      const answer = await lab.program.latest('draw', { verb: 'draw', view: request, pictures: ['phong'], marks: mark ? [mark] : [] });
      if (answer) {
        view.canvas.dataset.file = `${lab.state.subject}-findings`;
        put(view.canvas, size, answer.buffers[0]);
        marks.setAttribute('viewBox', `0 0 ${side} ${side}`);
        marks.replaceChildren(...answer.value.marks.filter(Boolean).flatMap((/** @type {[number, number]} */ [cx, cy]) => ['spot halo', 'spot'].map((name) => drawing('circle', { class: name, cx, cy, r: side / 30 }))));
      }
      if (key !== inspected && !dragging) {
        inspected = key;
        const found = await lab.program.latest('inspect', { verb: 'inspect', view: request });
        if (found) showFindings(found.value);
        if (mark) await draw(false);
      }
      room.dataset.drawn = String(Number(room.dataset.drawn ?? 0) + 1);
    } catch (error) {
      lab.fail(error);
    }
  }

  return { element: room, fill, draw };
}
