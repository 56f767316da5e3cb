// The page: rooms as tabs, language, theme, presentation, print, files that are dropped, and the link.

import { Left, Program } from './program.js';
import { currentLanguage, setLanguage, text } from './texts.js';
import { readLink, writeLink } from './link.js';
import { button, choice, element } from './dom.js';
import { normalsRoom } from './normals-room.js';
import { artefactsRoom } from './artefacts-room.js';
import { probeRoom } from './probe-room.js';
import { exercisesRoom } from './exercises-room.js';
import { inspectRoom } from './inspect-room.js';

/** @type {Record<string, (lab: any) => { element: HTMLElement, fill: () => void | Promise<void>, draw: (dragging: boolean) => Promise<void> }>} */
const ROOMS = { normals: normalsRoom, artefacts: artefactsRoom, probe: probeRoom, inspect: inspectRoom, exercises: exercisesRoom };
/** Controls of a room are made anew when one of these changes. */
const STRUCTURE = ['subject', 'experiment', 'room', 'lang'];
/** After this time without a change, in milliseconds, the picture is drawn in full. */
const REST = 180;

const root = /** @type {HTMLElement} */ (document.getElementById('laboratory'));
const message = element('div', { class: 'message', role: 'alert', hidden: true });
/** @type {any} */
let room = null;
let resting = 0;
let written = '';
/** @type {Uint8Array | null} */
let fileBytes = null;

/** @type {any} */
const lab = {
  state: readLink(location.hash),
  program: new Program(),
  file: null,
  shapes: [],
  /** Called after each change of the state: controls that show it. @type {((state: any) => void)[]} */
  followers: [],

  /** Changes the state, the link and the picture; while `dragging`, the picture is coarse. */
  update(/** @type {any} */ patch, dragging = false) {
    const structural = STRUCTURE.some((name) => name in patch && patch[name] !== lab.state[name]);
    Object.assign(lab.state, 'subject' in patch ? { place: '' } : {}, patch);
    clearTimeout(resting);
    if (!dragging) writeState();
    if ('room' in patch || 'experiment' in patch) lab.program.leave();
    if (structural) {
      show();
      return;
    }
    lab.followers.forEach((/** @type {(state: any) => void} */ follow) => follow(lab.state));
    if (dragging) {
      room.draw(true);
      resting = window.setTimeout(() => { writeState(); room.draw(false); }, REST);
    } else room.draw(false);
  },

  /** Changes the state and the link, and no picture. */
  remember(/** @type {any} */ patch) {
    Object.assign(lab.state, patch);
    writeState();
  },

  /** A message to the user, until the next one. */
  say(/** @type {string} */ words, isError = false) {
    message.hidden = false;
    message.className = `message ${isError ? 'error' : ''}`;
    message.replaceChildren(element('span', isError ? { lang: 'en' } : {}, words),
      button('×', () => { message.hidden = true; }, { 'aria-label': text('close') }));
  },

  /** Says what went wrong, unless it no longer matters. */
  fail(/** @type {unknown} */ error) {
    if (!(error instanceof Left)) lab.say(String(/** @type {Error} */ (error).message), true);
  },

  async open(/** @type {File} */ file) {
    const bytes = new Uint8Array(await file.arrayBuffer());
    try {
      const { value } = await lab.program.ask({ verb: 'open', name: file.name }, bytes);
      lab.file = { name: file.name };
      fileBytes = bytes;
      message.hidden = true;
      Object.assign(lab.state, { subject: 'file', segments: 0, place: '' });
      if (!['normals', 'probe', 'inspect'].includes(lab.state.room)) lab.state.room = 'normals';
      lab.state.against = value.has_normals ? 'stored' : 'uniform';
      writeState();
      show();
    } catch (error) {
      lab.say(text('file-error', { error: String(/** @type {Error} */ (error).message) }), true);
    }
  },
};

lab.program.onwaiting = (/** @type {boolean} */ isWaiting) => root.classList.toggle('waiting', isWaiting);
lab.program.onrestart = () => {
  if (lab.file && fileBytes) lab.program.ask({ verb: 'open', name: lab.file.name }, fileBytes).catch(() => {});
};

function writeState() {
  written = writeLink(lab.state);
  history.replaceState(null, '', written);
}

window.addEventListener('hashchange', () => {
  if (location.hash === written) return;
  written = location.hash;
  Object.assign(lab.state, readLink(location.hash));
  lab.program.leave();
  show();
});

/** Makes the page anew from the state. */
async function show() {
  const { state } = lab;
  delete root.dataset.ready;
  if (state.subject === 'file' && !lab.file) {
    lab.say(text('file-missing'));
    Object.assign(state, { subject: 'sphere', segments: 16 });
  }
  const shape = lab.shapes.find((/** @type {any} */ { id }) => id === state.subject);
  if (shape) state.segments = shape.most ? Math.min(shape.most, Math.max(3, state.segments)) : 0;
  else if (state.subject !== 'file') Object.assign(state, { subject: 'sphere', segments: 16 });
  lab.followers = [];
  setLanguage(state.lang);
  document.documentElement.dataset.theme = state.theme;
  document.documentElement.classList.toggle('present', state.present);
  document.title = `${text(`room-${state.room}`)} – ${text('title')}`;
  const focused = document.activeElement?.getAttribute('data-name');
  room = ROOMS[state.room](lab);
  const tab = (/** @type {string} */ name) => button(text(`room-${name}`), () => lab.update({ room: name }), {
    class: 'tab', 'aria-current': name === state.room ? 'page' : null, 'data-name': `room-${name}`,
  });
  const themes = /** @type {[string, string][]} */ (['', 'light', 'dark'].map((theme) => [theme, text(`theme-${theme || 'system'}`)]));
  root.replaceChildren(
    element('header', {},
      element('h1', {}, text('title')),
      element('nav', { 'aria-label': text('rooms') }, ...Object.keys(ROOMS).map(tab)),
      element('div', { class: 'settings' },
        choice({
          label: text('language'), name: 'lang', value: currentLanguage(),
          options: [['en', 'English'], ['pt', 'Português']], chosen: (lang) => lab.update({ lang }),
        }),
        choice({
          label: text('theme'), name: 'theme', value: state.theme, options: themes,
          chosen: (theme) => { document.documentElement.dataset.theme = theme; lab.update({ theme }); },
        }),
        button(text('present'), present, { 'data-name': 'present', 'aria-pressed': String(state.present) }),
        button(text('print'), () => window.print()))),
    message,
    element('p', { class: 'working', 'aria-hidden': 'true' }, text('working')),
    element('main', {}, room.element),
    element('footer', {}, text('footer')));
  try {
    await room.fill();
  } catch (error) {
    lab.fail(error);
  }
  if (focused) /** @type {HTMLElement | null} */ (root.querySelector(`[data-name="${CSS.escape(focused)}"]`))?.focus();
  await room.draw(false);
  root.dataset.ready = state.room;
}

/** Large type without controls, for a projector; Escape ends it. */
function present() {
  lab.state.present = !lab.state.present;
  writeState();
  document.documentElement.classList.toggle('present', lab.state.present);
  root.querySelector('[data-name="present"]')?.setAttribute('aria-pressed', String(lab.state.present));
  if (lab.state.present) document.documentElement.requestFullscreen?.().catch(() => {});
  else if (document.fullscreenElement) document.exitFullscreen();
  room.draw(false);
}

window.addEventListener('keydown', (event) => {
  if (event.key === 'Escape' && lab.state.present) present();
});
document.addEventListener('fullscreenchange', () => {
  if (!document.fullscreenElement && lab.state.present) present();
});
window.addEventListener('resize', () => {
  clearTimeout(resting);
  resting = window.setTimeout(() => room?.draw(false), REST);
});
// Findings print open, with what they say.
window.addEventListener('beforeprint', () => root.querySelectorAll('details.finding').forEach((it) => { /** @type {any} */ (it).open = true; }));
window.addEventListener('dragover', (event) => {
  event.preventDefault();
  root.classList.add('dropping');
});
window.addEventListener('dragleave', () => root.classList.remove('dropping'));
window.addEventListener('drop', (event) => {
  event.preventDefault();
  root.classList.remove('dropping');
  const file = event.dataTransfer?.files[0];
  if (file) lab.open(file);
});

setLanguage(lab.state.lang);
lab.program.ask({ verb: 'shapes' }).then((/** @type {any} */ answer) => {
  lab.shapes = answer.value;
  show();
}, (/** @type {Error} */ error) => root.replaceChildren(element('p', { role: 'alert' }, text('cannot-start', { error: String(error.message) }))));

// For tests and the console: any request, with its buffers.
/** @type {any} */ (window).laboratory = { ask: (/** @type {any} */ request) => lab.program.ask(request), state: lab.state };
