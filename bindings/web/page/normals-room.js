// The room Normals: one mesh, flat, Gouraud, Phong and exact under one lamp, with its normals computed as chosen.

import { button, choice, commandBlock, download, element, group, table, toggle } from './dom.js';
import { number, text } from './texts.js';
import { figure, put, stageWidth } from './canvas.js';
import { PICTURES, WEIGHTS } from './link.js';
import { lampOn, lightGroups, meshGroup, placeLamp, stateSlider, viewOf } from './mesh-controls.js';

const KINDS = [...PICTURES, 'deviation'];
const FORMATS = ['obj', 'glb', 'ply'];

/** @param {import('./mesh-controls.js').Lab} lab */
export function normalsRoom(lab) {
  const figures = KINDS.map((kind) => figure(text(`alt-${kind}`), text(`picture-${kind}`)));
  const lamps = figures.slice(0, 4).map(({ stage }) => lampOn(lab, stage));
  const legend = element('div', { class: 'legend', 'aria-hidden': 'true' });
  const against = element('div');
  figures[4].element.append(legend, against);
  const counts = element('div', { class: 'counts' });
  const controls = element('div', { class: 'controls' });
  const saving = element('section', { class: 'saving' });
  const room = element('div', { class: 'room with-controls' },
    element('div', { class: 'main' },
      element('p', { class: 'lead' }, text('normals-lead')),
      element('div', { class: 'overview' },
        element('div', { class: 'pictures four' }, ...figures.slice(0, 4).map((it) => it.element)),
        element('div', { class: 'facts' }, figures[4].element, counts)),
      saving),
    controls);

  function fillControls() {
    const { state } = lab;
    const { light, material } = lightGroups(lab);
    controls.replaceChildren(
      meshGroup(lab),
      group(text('normals'),
        choice({
          label: text('weight'), name: 'weight', value: state.weight,
          options: WEIGHTS.map((weight) => [weight, text(`weight-${weight}`)]),
          chosen: (weight) => lab.update({ weight }),
        }),
        stateSlider(lab, 'crease', { min: 0, max: 180, step: 1, unit: '°' }),
        choice({
          label: text('rule'), name: 'cone', value: state.cone ? 'cone' : 'fan',
          options: [['fan', text('rule-fan')], ['cone', text('rule-cone')]],
          chosen: (rule) => lab.update({ cone: rule === 'cone' }),
        }),
        toggle({ label: text('groups'), name: 'groups', value: state.groups, toggled: (groups) => lab.update({ groups }) })),
      group(text('overlays'),
        toggle({ label: text('creases'), name: 'creases', value: state.creases, toggled: (creases) => lab.update({ creases }) }),
        toggle({ label: text('hairs'), name: 'hairs', value: state.hairs, toggled: (hairs) => lab.update({ hairs }) }),
        toggle({ label: text('wire'), name: 'wire', value: state.wire, toggled: (wire) => lab.update({ wire }) })),
      light,
      material,
    );
    against.replaceChildren(
      choice({
        label: text('against'), name: 'against', value: state.against,
        options: [['exact', text('against-exact')], ['stored', text('against-stored')],
          ...WEIGHTS.map((weight) => /** @type {[string, string]} */ ([weight, text(`weight-${weight}`)]))],
        chosen: (value) => lab.update({ against: value }),
      }),
      stateSlider(lab, 'most', { min: 0.1, max: 90, step: 0.1, unit: '°', logarithmic: true }),
    );
    saving.replaceChildren(
      element('h2', {}, text('save')),
      element('div', { class: 'buttons' },
        ...FORMATS.map((format) => button(text('save-as', { format: format.toUpperCase() }), () => saveMesh(format)))),
      element('div', { class: 'commands' }),
    );
  }

  /** The format that was saved last, which the command writes. */
  let saved = 'obj';

  /** @param {string} format */
  async function saveMesh(format) {
    saved = format;
    showCommands(viewOf(lab.state, [1, 1]));
    try {
      const { value, buffers } = await lab.program.ask({ verb: 'save', view: viewOf(lab.state, [1, 1]), format });
      download(value.name, new Blob([/** @type {any} */ (buffers[0])]));
      const left = value.left.length ? text('left', { files: value.left.join(', ') }) : '';
      lab.say([text('saved', { name: value.name, vertices: value.vertices }), left, ...value.notes].filter(Boolean).join(' '));
    } catch (error) {
      lab.fail(error);
    }
  }

  /** @param {any} view */
  async function showCommands(view) {
    const commands = await lab.program.latest('command', { verb: 'command', view, format: saved });
    if (commands) saving.querySelector('.commands')?.replaceChildren(commandBlock(commands.value));
  }

  /** @param {any} value */
  function showCounts(value, /** @type {any} */ deviation) {
    // Below this, angles are rounding.
    const degrees = (/** @type {number} */ x) => `${number(x < 1e-9 ? 0 : x, 3)}°`;
    const rows = [
      [text('count-faces'), number(value.facts.faces, 8)],
      [text('count-vertices'), number(value.referenced, 8)],
      [text('count-after'), `${number(value.after, 8)} (+${number(value.splits, 8)})`],
      [text('count-hard'), number(value.hard + value.marked, 8)],
      [text('count-smooth'), number(value.smooth, 8)],
      [text('count-boundary'), number(value.boundary, 8)],
      [text('count-faults'), number(value.faults, 8)],
      [text('deviation-rms'), deviation.missing ? '–' : degrees(deviation.rms)],
      [text('deviation-largest'), deviation.missing ? '–' : degrees(deviation.largest)],
    ];
    counts.replaceChildren(table(text('counts'), [], rows), ...(lab.state.subject === 'file' ? value.facts.notes : []).map((/** @type {string} */ note) => element('p', { class: 'hint', lang: 'en' }, note)));
  }

  const unknown = { key: '', side: 0, file: lab.file };
  /** The deviation map that is shown with its numbers: what it depends on, and its size. */
  let map = unknown;

  /** What the deviation map depends on: all of a view but light, material and overlays. @param {any} view */
  function mapKey({ subject, segments, weight, crease, cone, groups, turn, tilt, zoom, against, most }) {
    return JSON.stringify([subject, segments, weight, crease, cone, groups, turn, tilt, zoom, against, most]);
  }

  /** @param {boolean} dragging */
  async function draw(dragging) {
    const full = stageWidth(figures[0].stage, 480);
    const side = dragging ? Math.max(120, Math.round(full * 0.5)) : full;
    const view = viewOf(lab.state, [side, side]);
    const { file } = lab;
    const key = mapKey(view);
    // The lamp changes the other four pictures only.
    const isMapped = map.key === key && map.file === file && map.side >= side;
    // If another map is requested before the numbers of this one arrive, this one is not the map that is shown.
    const waiting = isMapped ? map : { ...unknown };
    map = waiting;
    lamps.forEach((mark) => placeLamp(mark, lab.state));
    const ticks = [0, 0.25, 0.5, 0.75, 1].map((share) => `${share === 1 ? '≥ ' : ''}${number(share * lab.state.most)}°`);
    legend.replaceChildren(...ticks.map((tick) => element('span', {}, tick)));
    try {
      const pictures = isMapped ? PICTURES : KINDS;
      const answer = await lab.program.latest('draw', { verb: 'draw', view, pictures, marks: [] });
      if (!answer) return;
      answer.value.pictures.forEach((/** @type {any} */ picture, /** @type {number} */ k) => {
        const { stage, canvas, note } = figures[k];
        canvas.dataset.file = `${lab.state.subject}-${KINDS[k]}`;
        stage.hidden = picture.missing !== undefined;
        note.hidden = picture.missing === undefined;
        if (picture.missing) note.textContent = picture.missing.startsWith('no-') ? text(picture.missing) : picture.missing;
        else put(canvas, picture.size, answer.buffers[picture.buffer]);
      });
      room.dataset.drawn = String(Number(room.dataset.drawn ?? 0) + 1);
      const [normals, deviation] = await Promise.all([
        isMapped ? null : lab.program.latest('counts', { verb: 'normals', view }),
        isMapped ? null : lab.program.latest('deviation', { verb: 'deviation', view }),
        dragging ? null : showCommands(view),
      ]);
      if (!normals || !deviation) return;
      showCounts(normals.value, deviation.value);
      if (map === waiting) map = { key, side, file };
    } catch (error) {
      lab.fail(error);
    }
  }

  return { element: room, fill: fillControls, draw };
}
