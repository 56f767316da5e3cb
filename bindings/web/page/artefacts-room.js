// The room Artefacts: the experiments with their parameters, pictures, numbers, plots and verdicts.

import { button, choice, commandBlock, element, group, slider, table } from './dom.js';
import { currentLanguage, text } from './texts.js';
import { WEIGHTS, readParameters, writeParameters } from './link.js';
import { figure, put } from './canvas.js';
import { magnifier } from './magnifier.js';
import { plot } from './plot.js';
import { Left } from './program.js';

/** The size of pictures while a slider moves, and of those that the plot is measured on. Slow experiments have the second. */
const COARSE = [128, 64];
/** An experiment whose pictures take more in the first size, in milliseconds, is slow. */
const SLOW = 400;
/** Runs of a trace. */
const STEPS = 24;
/** An experiment whose pictures take less in the size of the plot, in milliseconds, is traced without being asked. */
const FAST = 400;
/** On wider pages, in pixels, the plot is next to the sliders: it is seen together with them and the pictures. */
const WIDE = '(min-width: 901px)';
/** A measure changes if it does by more than this share of its largest value. */
const CHANGE = 1e-3;
/** @type {Record<string, { step: number, unit?: string, logarithmic?: boolean }>} */
const SLIDERS = {
  size: { step: 1, unit: ' px' },
  segments: { step: 1, logarithmic: true },
  light: { step: 0.01, unit: '°' },
  turn: { step: 1, unit: '°' },
  intensity: { step: 0.05, logarithmic: true },
  exponent: { step: 1, logarithmic: true },
  crease: { step: 1, unit: '°' },
};

/** @param {import('./mesh-controls.js').Lab} lab */
export function artefactsRoom(lab) {
  const controls = element('div', { class: 'controls' });
  const head = element('div');
  const verdict = element('p', { class: 'verdict', 'aria-live': 'polite' }, text('working'));
  const pictures = element('div');
  const panel = element('section', { class: 'panel', hidden: true });
  const liveControls = element('div');
  const livePlot = element('div');
  const live = element('section', { class: 'live' }, liveControls, livePlot);
  const rest = element('div');
  const room = element('div', { class: 'room with-controls' },
    element('div', { class: 'main' }, head, verdict, pictures, panel, rest), controls);
  const isWide = matchMedia(WIDE);
  const placeLive = () => (isWide.matches ? controls.append(live) : rest.before(live));
  isWide.addEventListener('change', placeLive);
  /** @type {any[]} */
  let experiments = [];
  let shown = '';
  /** @type {ReturnType<typeof figure>[]} */
  let figures = [];
  /** @type {ReturnType<typeof magnifier> | null} */
  let glass = null;
  // The trace: the parameter that it is along, and the measures of each value; the latest run of a value counts.
  let along = '';
  // How many parameters no measure with a closed form changes along: the plot begins with another one.
  let passed = 0;
  // Whether a trace goes on along the next one.
  let goesOn = false;
  let [tracing, traceOf, runs] = [0, '', 0];
  /** @type {Map<number, any[]>} */
  let trace = new Map();
  let coarse = COARSE[0];
  const traceButton = button('', () => {
    if (runs) stopTrace();
    else startTrace(true);
  }, { 'data-name': 'trace' });

  const current = () => experiments.find(({ id }) => id === lab.state.experiment) ?? experiments[0];
  const parameter = (/** @type {string} */ name) => current().parameters.find((/** @type {any} */ it) => it.name === name);
  const own = () => readParameters(lab.state.parameters);
  const valueOf = (/** @type {string} */ name) => own()[name] ?? parameter(name)?.default;
  /** Parameters that a trace can be along. @returns {string[]} */
  const movable = () => current().parameters.filter((/** @type {any} */ it) => it.range && it.name !== 'size').map((/** @type {any} */ it) => it.name);

  /** A request for a run. @param {Record<string, any>} more */
  function run(more) {
    /** @type {any} */
    const request = { verb: 'experiment', id: current().id, language: currentLanguage() };
    for (const { name, range } of current().parameters) {
      const value = own()[name];
      if (value !== undefined) request[name] = range ? Number(value) : value;
    }
    return { ...request, ...more };
  }

  /** @param {string} name @param {string | number} value @param {boolean} [dragging] */
  function change(name, value, dragging = false) {
    const changed = { ...own(), [name]: String(value) };
    if (String(value) === parameter(name).default) delete changed[name];
    if (parameter(name).range && name !== 'size') along = name;
    lab.update({ parameters: writeParameters(changed), along }, dragging);
  }

  async function fill() {
    experiments = (await lab.program.ask({ verb: 'experiments', language: currentLanguage() })).value;
    fillControls();
  }

  function fillControls() {
    const experiment = current();
    const sliders = experiment.parameters.map((/** @type {{ name: string, range: [number, number] | null }} */ { name, range }) => {
      if (!range) {
        const options = name === 'weight' ? WEIGHTS : ['scanline', 'affine', 'perspective'];
        return choice({
          label: text(`parameter-${name}`), name, value: valueOf(name),
          options: options.map((key) => [key, text(name === 'weight' ? `weight-${key}` : `interpolation-${key}`)]),
          chosen: (value) => change(name, value),
        });
      }
      const { step, unit, logarithmic } = SLIDERS[name];
      const max = name === 'segments' ? Math.min(range[1], 256) : name === 'exponent' ? 10000 : name === 'size' ? 640 : range[1];
      const min = name === 'exponent' ? 1 : range[0];
      return slider({
        label: text(`parameter-${name}`), name, min, max, step, unit, logarithmic, value: Number(valueOf(name)),
        moved: (value, dragging) => change(name, value, dragging),
      });
    });
    controls.replaceChildren(
      group(text('experiment'), choice({
        label: text('experiment-choice'), name: 'experiment', value: experiment.id,
        options: experiments.map(({ id, title }) => [id, title]),
        chosen: (id) => lab.update({ experiment: id, parameters: '', measure: -1, along: '', magnified: '' }),
      })),
      group(text('parameters'), ...sliders,
        button(text('defaults'), () => { lab.update({ parameters: '' }); fillControls(); }, { class: 'small' })),
    );
    placeLive();
    head.replaceChildren(
      element('h2', {}, experiment.title),
      element('p', { class: 'lead', html: experiment.claim }),
    );
    shown = experiment.id;
  }

  /** @param {any} value @param {Uint8Array[]} buffers */
  function showPictures(value, buffers) {
    const key = JSON.stringify(value.series.map((/** @type {any[]} */ shots) => shots.map(({ name, label }) => [name, label])));
    if (pictures.dataset.key !== key) {
      pictures.dataset.key = key;
      figures = [];
      glass = null;
      panel.hidden = true;
      const [magnified, line = ''] = lab.state.magnified.split(':');
      /** @type {() => void} */
      let openMagnified = () => {};
      pictures.replaceChildren(...value.series.map((/** @type {any[]} */ shots) => element('div', { class: 'pictures large' },
        ...shots.map((shot) => {
          const made = figure(shot.caption, '');
          figures.push(made);
          const own = magnifier(made.stage, made.canvas, panel, (ends) => {
            const shares = ends?.map((share) => Math.round(10_000 * share) / 10_000);
            if (!ends) glass = null;
            lab.remember({ magnified: shares ? `${shot.name}:${shares}` : '' });
          });
          const open = (/** @type {number[]} */ ends) => {
            glass?.close();
            glass = own;
            // Below the pictures of its row, which those after it fill up: the line and its profile are seen together.
            made.element.after(panel);
            own.open(ends);
          };
          if (shot.name === magnified) openMagnified = () => open(line.split(',').map(Number));
          made.element.append(button(text('magnify'), () => {
            open([0, 0.5, 0.9999, 0.5]);
            lab.remember({ magnified: `${shot.name}:0,0.5,0.9999,0.5` });
            made.element.scrollIntoView({ block: 'nearest' });
            if (panel.getBoundingClientRect().bottom > innerHeight) made.element.scrollIntoView();
          }, { class: 'small', 'aria-label': `${text('magnify')}: ${shot.name}` }));
          return made.element;
        }))));
      openMagnified();
    }
    value.series.flat().forEach((/** @type {any} */ shot, /** @type {number} */ k) => {
      put(figures[k].canvas, shot.size, buffers[k]);
      figures[k].canvas.dataset.file = `${current().id}-${shot.name}`;
      figures[k].canvas.setAttribute('aria-label', shot.caption);
      const caption = figures[k].element.querySelector('figcaption');
      caption.innerHTML = `<span class="role ${shot.role}">${text(`role-${shot.role}`)}</span> ${shot.label}`;
      figures[k].element.className = shot.role;
    });
    glass?.show();
  }

  /** The measure that is plotted: its number among those with a closed form. @param {any[]} measures */
  function showLive(measures) {
    const known = measures.map((measure, index) => ({ ...measure, index })).filter(({ expected }) => expected);
    const picked = known.find(({ index }) => index === lab.state.measure) ?? known.find(({ index }) => changes(index)) ?? known[0];
    live.hidden = !picked || !along;
    if (live.hidden) return;
    traceButton.textContent = runs ? text('trace-stop', { done: runs, total: STEPS + 1 }) : text('trace', { name: text(`parameter-${along}`) });
    const names = known.map(({ name, index }) => /** @type {[string, string]} */ ([String(index), name]));
    const key = JSON.stringify([names, picked.index, along, lab.state.experiment]);
    if (liveControls.dataset.key !== key) {
      liveControls.dataset.key = key;
      liveControls.replaceChildren(
        element('h2', {}, text('live')),
        element('div', { class: 'row' },
          choice({
            label: text('measure'), name: 'measure', value: String(picked.index), options: names,
            chosen: (value) => lab.update({ measure: Number(value) }),
          }),
          choice({
            label: text('along'), name: 'along', value: along, options: movable().map((name) => [name, text(`parameter-${name}`)]),
            chosen: (name) => lab.update({ along: name }),
          }),
          traceButton));
    }
    const { size } = plotSize();
    const sorted = [...trace].sort((a, b) => a[0] - b[0]);
    const values = (/** @type {(measure: any) => number} */ of) => /** @type {[number, number][]} */ (
      sorted.filter(([, list]) => list[picked.index]).map(([at, list]) => [at, of(list[picked.index])]));
    const unit = picked.unit ? ` (${picked.unit})` : '';
    livePlot.replaceChildren(...[plot({
      width: isWide.matches ? 300 : 560,
      title: picked.name, x: text(`parameter-${along}`), y: `${text('value')}${unit}`, here: Number(valueOf(along)),
      curves: [
        { name: text('closed-form'), points: values((measure) => measure.expected?.[1] ?? NaN), mark: 'dashed' },
        { name: text('measured'), points: values((measure) => measure.value), mark: 'dots' },
      ],
    }), ...size ? [element('p', { class: 'hint' }, text('live-size', { size }))] : []]);
  }

  /** Whether a measure has changed in the runs so far. @param {number} index */
  function changes(index) {
    const values = [...trace.values()].map((list) => list[index]?.value).filter(Number.isFinite);
    return Math.max(...values) - Math.min(...values) > CHANGE * Math.max(...values.map(Math.abs));
  }

  /** The size of the pictures that the plot is measured on: all of them have the same. */
  function plotSize() {
    return parameter('size') ? { size: Math.min(coarse, Number(valueOf('size'))) } : {};
  }

  function stopTrace() {
    tracing++;
    runs = 0;
    const latest = trace.get(Number(valueOf(along)));
    if (latest) showLive(latest);
  }

  /** Runs the experiment over the range of a parameter. @param {boolean} asked whether its button says so */
  async function startTrace(asked) {
    const mine = ++tracing;
    const { range } = parameter(along);
    const [low, high] = along === 'segments' ? [Math.max(range[0], 3), Math.min(range[1], 64)]
      : along === 'exponent' ? [1, 256] : along === 'light' ? [Math.max(range[0], -90), Math.min(range[1], 90)] : range;
    const { logarithmic, step } = SLIDERS[along];
    for (let k = 0; k <= STEPS; k++) {
      const share = k / STEPS;
      const value = logarithmic ? Number((Math.round(low * (high / low) ** share / step) * step).toFixed(4)) : low + (high - low) * share;
      if (asked) runs = k + 1;
      try {
        const answer = await lab.program.ask(run({ ...plotSize(), [along]: value, brief: true }));
        if (mine !== tracing) return;
        if (!trace.has(value)) trace.set(value, answer.value.measures);
        showLive(answer.value.measures);
      } catch (error) {
        // A value of the range that this experiment refuses has no point.
        if (mine !== tracing || error instanceof Left) return;
      }
    }
    const [latest] = trace.values();
    const isFlat = latest && !latest.some((/** @type {any} */ { expected }, /** @type {number} */ index) => expected && changes(index));
    if (isFlat && !lab.state.along && passed + 1 < movable().length) {
      passed++;
      [goesOn, runs] = [true, 0];
      await draw(false);
      return;
    }
    stopTrace();
    room.dataset.traced = String(Number(room.dataset.traced ?? 0) + 1);
  }

  /** @param {any} value */
  function showRest(value) {
    const experiment = current();
    rest.replaceChildren(
      element('div', { class: 'charts' }, ...value.charts.map((/** @type {any} */ chart) => element('figure', { class: 'chart' },
        element('div', { html: chart.svg }), element('figcaption', { html: chart.caption })))),
      element('h2', {}, text('measured-values')),
      element('div', { class: 'measures' }, table(text('measured-values'), value.table.headings, value.table.rows, { html: true })),
      element('h2', {}, text('explanation')),
      ...value.notes.map((/** @type {string} */ note) => element('p', { html: note })),
      ...experiment.formulas.map((/** @type {any} */ formula) => element('div', { class: 'formula' },
        element('div', { html: formula.math }), element('p', { html: formula.says }))),
      element('h2', {}, text('sources')),
      element('ul', {}, ...experiment.sources.map((/** @type {string} */ source) => element('li', { html: source }))),
      element('h2', {}, text('command')),
      commandBlock([value.command]),
    );
  }

  /** @param {boolean} dragging */
  async function draw(dragging) {
    if (!experiments.length) return;
    if (shown !== current().id) {
      coarse = COARSE[0];
      passed = 0;
      fillControls();
    }
    along = movable().includes(lab.state.along) ? lab.state.along : movable()[passed] ?? '';
    const key = writeParameters(Object.fromEntries(Object.entries(own()).filter(([name]) => name !== along))) + current().id + along;
    if (key !== traceOf) {
      [trace, traceOf, runs] = [new Map(), key, 0];
      tracing++;
    }
    const [at, isPlotted] = [Number(valueOf(along)), dragging || !parameter('size') || plotSize().size === Number(valueOf('size'))];
    try {
      const answer = await lab.program.latest('experiment', run(dragging ? plotSize() : {}));
      if (!answer) return;
      const { value, buffers } = answer;
      verdict.className = `verdict ${value.verdict}`;
      verdict.innerHTML = `<strong>${value.verdict_name}</strong>: ${value.condition}`;
      showPictures(value, buffers);
      if (along && isPlotted) trace.set(at, value.measures);
      if (dragging && answer.milliseconds > SLOW && coarse > COARSE[1]) {
        coarse = COARSE[1];
        trace.clear();
        tracing++;
        runs = 0;
      }
      showLive(value.measures);
      if (!dragging) showRest(value);
      let { milliseconds } = answer;
      if (along && !trace.has(at) && traceOf === key) {
        const point = await lab.program.ask(run({ ...plotSize(), [along]: at, brief: true }));
        if (traceOf !== key) return;
        milliseconds = point.milliseconds;
        trace.set(at, point.value.measures);
        showLive(value.measures);
      }
      room.dataset.drawn = String(Number(room.dataset.drawn ?? 0) + 1);
      if (!dragging && along && trace.size === 1 && (goesOn || milliseconds < FAST)) startTrace(goesOn);
      goesOn = false;
    } catch (error) {
      lab.fail(error);
    }
  }

  return { element: room, fill, draw };
}
