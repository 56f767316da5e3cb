// The room Exercises: those of the lectures and the same with random numbers, checked to the printed digits.

import { button, choice, commandBlock, drawing, element, group, subscripted, table } from './dom.js';
import { number, numbersIn, text } from './texts.js';
import { figure, put } from './canvas.js';
import { drawArrows, termRows } from './probe-room.js';

/** What was typed for an exercise, for when the room is made anew. */
let kept = { exercise: '', values: /** @type {string[]} */ ([]) };

/**
 * The colours of corners that a pixel is mixed from, each with its share, and their sum.
 * @param {any} report
 */
function shareRows(report) {
  const colour = (/** @type {number[]} */ rgb) => `(${rgb.map((x) => number(x, 5)).join('; ')})`;
  const { lit, vertices } = report.samples[0];
  const rows = lit.flatMap((/** @type {any} */ { share, given }, /** @type {number} */ k) => (share === 0 ? [] : [[
    subscripted(text('way-share', { number: vertices[k] + 1, share: number(share, 6) })),
    `${colour(given)} → ${colour(given.map((/** @type {number} */ x) => share * x))}`,
  ]]));
  return [...rows, [text('term-sum'), colour(report.linear)]];
}

/** @param {import('./mesh-controls.js').Lab} lab */
export function exercisesRoom(lab) {
  const controls = element('div', { class: 'controls' });
  const givens = element('div');
  const view = figure(text('alt-exercise'), text('exercise-picture'));
  const arrows = drawing('svg', { class: 'arrows', 'aria-hidden': 'true' });
  view.stage.append(arrows);
  const inputs = ['R', 'G', 'B'].map((name) => element('input', {
    type: 'text', inputmode: 'decimal', autocomplete: 'off', 'aria-label': text('component', { name }), 'data-name': `answer-${name}`,
    oninput: () => { kept = { exercise: shown, values: inputs.map((input) => input.value) }; },
  }));
  const result = element('p', { class: 'result', role: 'status' });
  const way = element('div');
  const form = element('form', { class: 'answer', onsubmit: (/** @type {Event} */ event) => { event.preventDefault(); check(); } },
    element('p', {}, text('exercise-question')),
    element('div', { class: 'components' }, 'I = ( ', ...inputs.flatMap((input, k) => (k ? ['; ', input] : [input])), ' )'),
    element('button', { type: 'submit' }, text('check')), ' ',
    button(text('show-way'), () => showWay(), { 'data-name': 'way' }));
  const statement = element('p', { class: 'lead' });
  const room = element('div', { class: 'room with-controls' },
    element('div', { class: 'main' }, element('p', { class: 'lead' }, text('exercises-lead')), statement,
      element('div', { class: 'split' }, view.element, element('div', {}, givens, form, result, way))),
    controls);
  /** @type {any[]} */
  let exercises = [];
  let shown = '';
  /** @type {any} */
  let about = null;

  const request = () => ({ id: lab.state.exercise, seed: lab.state.seed > 0 ? Math.round(lab.state.seed) : null });

  async function fill() {
    exercises = (await lab.program.ask({ verb: 'exercises' })).value;
    if (!exercises.some(({ id }) => id === lab.state.exercise)) lab.state.exercise = exercises[0].id;
    fillControls();
  }

  function fillControls() {
    const seed = element('input', {
      type: 'number', min: 0, max: 4294967295, id: 'seed', value: lab.state.seed, 'data-name': 'seed',
      onchange: () => lab.update({ seed: Math.max(0, Math.min(4294967295, Math.round(Number(seed.value) || 0))) }),
    });
    lab.followers.push(({ seed: own }) => { seed.value = String(own); });
    controls.replaceChildren(
      group(text('exercise'), choice({
        label: text('exercise-choice'), name: 'exercise', value: lab.state.exercise,
        options: exercises.map(({ id }) => [id, text(`exercise-${id}`)]),
        chosen: (exercise) => lab.update({ exercise }),
      })),
      group(text('random'),
        element('p', { class: 'hint' }, text('random-hint')),
        element('div', { class: 'choice' }, element('label', { for: 'seed' }, text('seed')), seed),
        element('div', { class: 'buttons' },
          button(text('random-new'), () => lab.update({ seed: 1 + Math.floor(Math.random() * 99_999) }), { 'data-name': 'random' }),
          button(text('random-off'), () => lab.update({ seed: 0 })))));
  }

  /** The numbers that were typed, with a comma or a point; `null` if one is missing. */
  function typed() {
    const numbers = inputs.map((input) => (input.value.trim() === '' ? NaN : Number(input.value.trim().replace(',', '.'))));
    return numbers.every(Number.isFinite) ? numbers : null;
  }

  async function check() {
    const answer = typed();
    if (!answer) {
      inputs.forEach((input) => { input.className = ''; input.removeAttribute('aria-invalid'); });
      result.className = 'result wrong';
      result.textContent = text('three-numbers');
      return;
    }
    const { value } = await lab.program.ask({ verb: 'check', ...request(), answer });
    inputs.forEach((input, k) => {
      input.setAttribute('aria-invalid', String(!value.right[k]));
      input.className = value.right[k] ? 'right' : 'wrong';
    });
    const right = value.right.every(Boolean);
    result.className = `result ${right ? 'right' : 'wrong'}`;
    result.textContent = right ? text('right', { tolerance: number(value.tolerance, 2) })
      : text('wrong', { names: ['R', 'G', 'B'].filter((_, k) => !value.right[k]).join(', ') });
  }

  async function showWay() {
    const { value } = await lab.program.ask({ verb: 'check', ...request(), answer: [0, 0, 0] });
    drawArrows(arrows, about.size, value.arrows);
    markPoint();
    const terms = termRows(value.report);
    const rows = terms.length ? terms : shareRows(value.report);
    const formula = terms.length ? text('way-formula', { cosine: value.cosine_of }) : text('way-shares');
    way.replaceChildren(
      element('h2', {}, text('way')),
      element('p', {}, text('way-answer', { colour: value.colour.map((/** @type {number} */ x) => number(x, 9)).join('; ') })),
      element('p', {}, subscripted(formula)),
      element('div', { class: 'terms' }, table(text('way-terms'), [], rows)),
      element('details', {}, element('summary', {}, text('probe-text')), element('pre', { tabindex: 0, lang: 'en' }, value.way)),
      ...(lab.state.seed > 0 ? [] : [commandBlock([about.command])]));
  }

  /** Marks the point that is asked for. */
  function markPoint() {
    const [x, y] = about.pixel;
    arrows.append(...['spot halo', 'spot'].map((name) => drawing('circle', { class: name, cx: x + 0.5, cy: y + 0.5, r: 9 })));
  }

  async function draw() {
    const key = JSON.stringify(request());
    if (key === shown) return;
    try {
      const answer = await lab.program.latest('exercise', { verb: 'exercise', ...request() });
      if (!answer) return;
      shown = key;
      about = answer.value;
      view.canvas.dataset.file = lab.state.exercise;
      put(view.canvas, about.size, answer.buffers[0]);
      arrows.setAttribute('viewBox', `0 0 ${about.size[0]} ${about.size[1]}`);
      arrows.replaceChildren();
      markPoint();
      statement.textContent = text(about.given_colours ? 'statement-given' : 'statement-lit', { decimals: about.decimals });
      const rows = about.givens.map((/** @type {any} */ row) => {
        const more = [row.colour ? text('given-colour', { colour: row.colour }) : '', row.offset !== null && row.offset !== undefined ? text('given-offset', { k: row.offset }) : ''];
        return [subscripted(text(`given-${row.key}`, { number: row.number ?? '' })), numbersIn([row.value, ...more].filter(Boolean).join(', '))];
      });
      givens.replaceChildren(table(text('givens'), [], rows));
      inputs.forEach((input, k) => {
        input.value = kept.exercise === key ? kept.values[k] : '';
        input.className = '';
        input.removeAttribute('aria-invalid');
      });
      result.textContent = '';
      way.replaceChildren();
      room.dataset.drawn = String(Number(room.dataset.drawn ?? 0) + 1);
    } catch (error) {
      lab.fail(error);
    }
  }

  return { element: room, fill, draw };
}
