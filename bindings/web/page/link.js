// The state of the page, and its form in the fragment of the link: what differs from the defaults.

/** The default of every value that a link can hold. Their types are those of the state. */
export const DEFAULTS = {
  room: 'normals',
  lang: '',
  theme: '',
  present: false,
  // The mesh and its pictures: the members of `View` in view.rs.
  subject: 'sphere',
  segments: 16,
  weight: 'angle',
  crease: 40,
  cone: false,
  groups: true,
  turn: 25,
  tilt: 20,
  zoom: 1,
  lampx: -0.5,
  lampy: 0.5,
  ambient: 0.1,
  diffuse: 0.7,
  specular: 0.3,
  exponent: 32,
  phong: false,
  creases: true,
  hairs: false,
  wire: false,
  against: 'exact',
  most: 10,
  // Probe.
  picture: 'phong',
  px: 0.42,
  py: 0.38,
  // Artefacts: an experiment, and its parameters where they are not the defaults.
  experiment: 'silhouette',
  parameters: '',
  measure: 0,
  // Exercises.
  exercise: 'example-1',
  seed: 0,
};

/** @typedef {typeof DEFAULTS} State */

/**
 * The state of a link. Unknown names and values of another type are ignored.
 * @param {string} fragment
 * @returns {State}
 */
export function readLink(fragment) {
  /** @type {any} */
  const state = { ...DEFAULTS };
  for (const [name, value] of new URLSearchParams(fragment.replace(/^#/, ''))) {
    const usual = /** @type {any} */ (DEFAULTS)[name];
    if (usual === undefined) continue;
    if (typeof usual === 'boolean') state[name] = value === '1';
    else if (typeof usual === 'string') state[name] = value;
    else if (value.trim() !== '' && Number.isFinite(Number(value))) state[name] = Number(value);
  }
  return state;
}

/**
 * The fragment of a state.
 * @param {State} state
 */
export function writeLink(state) {
  const link = new URLSearchParams();
  for (const [name, usual] of Object.entries(DEFAULTS)) {
    const value = /** @type {any} */ (state)[name];
    if (value === usual && name !== 'room') continue;
    link.set(name, typeof value === 'boolean' ? (value ? '1' : '0') : String(value));
  }
  return `#${link}`;
}

/**
 * Parameters of an experiment from their text in a link: `light:30,segments:8`.
 * @param {string} textual
 * @returns {Record<string, string>}
 */
export function readParameters(textual) {
  const pairs = textual.split(',').map((pair) => pair.split(':'));
  return Object.fromEntries(pairs.filter((pair) => pair.length === 2 && pair[0]));
}

/** @param {Record<string, string | number>} parameters */
export function writeParameters(parameters) {
  return Object.entries(parameters).map(([name, value]) => `${name}:${value}`).join(',');
}
