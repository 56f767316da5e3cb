// Pictures: RGBA on a canvas, a lamp or a view that is dragged on them.

import { button, download, element } from './dom.js';
import { text } from './texts.js';

/**
 * A canvas in a figure, with an overlay for arrows and marks, and a button that saves the picture. The name of its file is
 * `canvas.dataset.file`.
 * @param {string} label
 * @param {string} caption
 */
export function figure(label, caption) {
  const canvas = element('canvas', { width: 1, height: 1, role: 'img', 'aria-label': label });
  const stage = element('div', { class: 'stage' }, canvas);
  const note = element('p', { class: 'missing', hidden: true });
  const keep = async () => {
    const drawn = await withArrows(canvas, stage.querySelector('svg.arrows')).catch(() => canvas);
    drawn.toBlob((/** @type {Blob | null} */ blob) => { if (blob) download(`${canvas.dataset.file ?? 'picture'}.png`, blob); });
  };
  const named = { title: text('save-picture'), 'aria-label': `${text('save-picture')}: ${label}` };
  const save = button('⤓', keep, { class: 'save', ...named });
  const made = element('figure', {}, stage, save, note, element('figcaption', {}, caption));
  return { element: made, stage, canvas, note };
}

/** The properties of arrows that the style of the page sets. */
const STYLE = ['stroke-opacity', 'vector-effect', 'fill', 'stroke', 'stroke-width', 'stroke-linecap', 'stroke-linejoin', 'paint-order', 'font-family', 'font-size', 'font-weight', 'font-style', 'opacity'];

/**
 * A picture with the arrows over it; the picture itself if there are none.
 * @param {HTMLCanvasElement} canvas
 * @param {SVGSVGElement | null} arrows
 */
async function withArrows(canvas, arrows) {
  if (!arrows?.childElementCount) return canvas;
  const copy = /** @type {SVGSVGElement} */ (arrows.cloneNode(true));
  const styled = [...arrows.querySelectorAll('*')];
  copy.querySelectorAll('*').forEach((it, k) => {
    const style = getComputedStyle(styled[k]);
    STYLE.forEach((name) => /** @type {SVGElement} */ (it).style.setProperty(name, style.getPropertyValue(name)));
  });
  copy.setAttribute('width', String(canvas.width));
  copy.setAttribute('height', String(canvas.height));
  const image = new Image();
  image.src = `data:image/svg+xml,${encodeURIComponent(new XMLSerializer().serializeToString(copy))}`;
  await image.decode();
  const drawn = element('canvas', { width: canvas.width, height: canvas.height });
  const context = drawn.getContext('2d');
  context.drawImage(canvas, 0, 0);
  context.drawImage(image, 0, 0);
  return drawn;
}

/**
 * @param {HTMLCanvasElement} canvas
 * @param {[number, number]} size
 * @param {Uint8Array} pixels
 */
export function put(canvas, [width, height], pixels) {
  if (canvas.width !== width || canvas.height !== height) {
    canvas.width = width;
    canvas.height = height;
  }
  const data = new Uint8ClampedArray(/** @type {ArrayBuffer} */ (pixels.buffer), pixels.byteOffset, pixels.length);
  canvas.getContext('2d', { willReadFrequently: true })?.putImageData(new ImageData(data, width, height), 0, 0);
}

/**
 * Calls `moved(x, y, isDragging)` with the place of the pointer in the stage, from 0 to 1, while it is pressed, and once when it
 * is released. `x` and `y` may lie outside. Of several fingers, the last one counts.
 * @param {HTMLElement} stage
 * @param {(x: number, y: number, dragging: boolean, event: PointerEvent) => void} moved
 */
export function draggable(stage, moved) {
  /** @type {number | null} */
  let pressed = null;
  stage.classList.add('drag');
  const place = (/** @type {PointerEvent} */ event, /** @type {boolean} */ dragging) => {
    const box = stage.getBoundingClientRect();
    moved((event.clientX - box.left) / box.width, (event.clientY - box.top) / box.height, dragging, event);
  };
  stage.addEventListener('pointerdown', (event) => {
    pressed = event.pointerId;
    stage.setPointerCapture(event.pointerId);
    place(event, true);
    event.preventDefault();
  });
  stage.addEventListener('pointermove', (event) => { if (event.pointerId === pressed) place(event, true); });
  const release = (/** @type {PointerEvent} */ event) => {
    if (event.pointerId !== pressed) return;
    pressed = null;
    place(event, false);
  };
  stage.addEventListener('pointerup', release);
  stage.addEventListener('pointercancel', release);
}

/** The width in device pixels that a stage shows, within limits. @param {HTMLElement} stage @param {number} most */
export function stageWidth(stage, most) {
  const width = stage.clientWidth * Math.min(window.devicePixelRatio || 1, 2);
  return Math.max(96, Math.min(most, Math.round(width)));
}
