// Controls and requests that the rooms with a mesh share: mesh, view, lamp, material; files that are opened or dropped.

import { button, choice, element, group, slider } from './dom.js';
import { text } from './texts.js';
import { draggable } from './canvas.js';

/** @typedef {import('./link.js').State} State */
/** @typedef {{ state: State, program: import('./program.js').Program, update: (patch: Partial<State>, dragging?: boolean) => void,
 *   remember: (patch: Partial<State>) => void, followers: ((state: State) => void)[], file: { name: string } | null, shapes: any[],
 *   open: (file: File) => Promise<void>, say: (message: string, isError?: boolean) => void, fail: (error: unknown) => void }} Lab */

/** Degrees that a drag over the whole picture rotates by. */
const DRAG = 180;

/**
 * A slider of a number of the state, which follows the state when something else changes it.
 * @param {Lab} lab
 * @param {any} name a name of the state
 * @param {{ min: number, max: number, step: number, unit?: string, logarithmic?: boolean }} range
 */
export function stateSlider(lab, name, range) {
  const state = /** @type {any} */ (lab.state);
  let shown = state[name];
  const row = slider({
    label: text(name), name, value: shown, ...range,
    moved: (value, dragging) => {
      shown = value;
      lab.update({ [name]: value }, dragging);
    },
  });
  lab.followers.push(() => {
    if (shown !== state[name]) row.set(shown = state[name]);
  });
  return row;
}

/** Sliders of the viewer. @param {Lab} lab */
export const viewSliders = (lab) => [
  stateSlider(lab, 'turn', { min: -180, max: 180, step: 1, unit: '°' }),
  stateSlider(lab, 'tilt', { min: -89, max: 89, step: 1, unit: '°' }),
  stateSlider(lab, 'zoom', { min: 0.5, max: 20, step: 0.1, logarithmic: true }),
];

/** The view after a drag by these shares of the picture. @param {State} state @param {number} dx @param {number} dy */
export function dragged(state, dx, dy) {
  const tenth = (/** @type {number} */ x) => Math.round(10 * x) / 10;
  return {
    turn: tenth(((state.turn - dx * DRAG + 540) % 360) - 180),
    tilt: tenth(Math.max(-89, Math.min(89, state.tilt + dy * DRAG))),
  };
}

/**
 * The view of a request.
 * @param {State} state
 * @param {[number, number]} size
 */
export function viewOf(state, size) {
  const { subject, segments, weight, crease, cone, groups, turn, tilt, zoom, ambient, diffuse, specular, exponent } = state;
  const { phong, creases, hairs, wire, against, most, lampx, lampy } = state;
  return {
    subject, segments, weight, crease, cone, groups, turn, tilt, zoom, ambient, diffuse, specular, exponent, phong, creases,
    hairs, wire, against, most, size, lamp: [lampx, lampy],
  };
}

/** Choice of the mesh, segments, and the user's file. @param {Lab} lab */
export function meshGroup(lab) {
  const { state } = lab;
  const shape = lab.shapes.find(({ id }) => id === state.subject);
  /** @type {[string, string][]} */
  const options = lab.shapes.map(({ id }) => [id, text(`shape-${id}`)]);
  if (lab.file) options.push(['file', lab.file.name]);
  const chosen = (/** @type {string} */ subject) => {
    const other = lab.shapes.find(({ id }) => id === subject);
    lab.update({ subject, segments: other?.segments ?? 0, against: other?.segments ? 'exact' : 'uniform' });
  };
  const input = element('input', {
    type: 'file', accept: '.obj,.ply,.stl,.glb,.gltf', class: 'visually-hidden', tabindex: -1, 'aria-label': text('open-file'),
    onchange: () => { if (input.files?.[0]) lab.open(input.files[0]); },
  });
  return group(
    text('mesh'),
    choice({ label: text('mesh-choice'), options, value: state.subject, name: 'subject', chosen }),
    shape?.most
      ? stateSlider(lab, 'segments', { min: 3, max: shape.most, step: 1 })
      : null,
    button(text('open-file'), () => input.click(), { class: 'open' }),
    input,
    element('p', { class: 'hint' }, text('drop-hint')),
  );
}

/** Sliders of the lamp, the viewer and the material. @param {Lab} lab */
export function lightGroups(lab) {
  const { state } = lab;
  const one = (/** @type {string} */ name, /** @type {any} */ range) => stateSlider(lab, name, range);
  const unit = { min: -1, max: 1, step: 0.01 };
  const share = { min: 0, max: 1, step: 0.01 };
  return {
    light: group(text('lamp-and-view'), one('lampx', unit), one('lampy', unit), ...viewSliders(lab)),
    material: group(text('material'), one('ambient', share), one('diffuse', share), one('specular', share),
      one('exponent', { min: 1, max: 2000, step: 1, logarithmic: true }),
      choice({
        label: text('reflection'), options: [['blinn', text('blinn')], ['phong', text('phong-model')]], name: 'phong',
        value: state.phong ? 'phong' : 'blinn', chosen: (value) => lab.update({ phong: value === 'phong' }),
      })),
  };
}

/**
 * Lets the pointer move the lamp on a stage, or with Shift, the right button or a second finger the view. Returns the lamp's mark.
 * @param {Lab} lab
 * @param {HTMLElement} stage
 */
export function lampOn(lab, stage) {
  const mark = element('span', { class: 'lamp', 'aria-hidden': 'true' });
  stage.append(mark);
  stage.addEventListener('contextmenu', (event) => event.preventDefault());
  let turns = false;
  let [fromX, fromY] = [0, 0];
  let lamp = { lampx: 0, lampy: 0 };
  draggable(stage, (x, y, dragging, event) => {
    if (event.type === 'pointerdown') {
      turns = event.shiftKey || event.button === 2 || !event.isPrimary;
      [fromX, fromY] = [x, y];
      // Before a second finger, the first one has moved the lamp.
      if (event.isPrimary) lamp = { lampx: lab.state.lampx, lampy: lab.state.lampy };
      else Object.assign(lab.state, lamp);
    }
    if (turns) {
      const view = dragged(lab.state, x - fromX, y - fromY);
      [fromX, fromY] = [x, y];
      lab.update(view, dragging);
      return;
    }
    const [lampx, lampy] = [2 * x - 1, 1 - 2 * y].map((z) => Math.round(100 * Math.max(-1, Math.min(1, z))) / 100);
    lab.update({ lampx, lampy }, dragging);
  });
  return mark;
}

/** @param {HTMLElement} mark @param {State} state */
export function placeLamp(mark, state) {
  mark.style.left = `${50 + 50 * state.lampx}%`;
  mark.style.top = `${50 - 50 * state.lampy}%`;
}
