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
  experiment: 'lost-highlight',
  parameters: '',
  // The parameter and the measure of the plot, the first one that changes if it is -1; the picture that is magnified, and the ends
  // of the line on it.
  along: '',
  measure: -1,
  magnified: '',
  // Inspect: a finding and one of its places, as `2:0`.
  place: '',
  // Exercises.
  exercise: 'example-1',
  seed: 0,
};

/** @typedef {typeof DEFAULTS} State */

export const WEIGHTS = ['uniform', 'area', 'angle', 'angle-area', 'max', 'edge', 'quadric', 'jet', 'best'];
export const PICTURES = ['flat', 'gouraud', 'phong', 'exact'];

/** The values of some choices. @type {Record<string, string[]>} */
const CHOICES = {
  room: ['normals', 'artefacts', 'probe', 'inspect', 'exercises'],
  lang: ['en', 'pt'],
  theme: ['light', 'dark'],
  weight: WEIGHTS,
  picture: PICTURES,
  against: ['exact', 'stored', ...WEIGHTS],
};

/** Limits of numbers; those with `whole` are rounded. @type {Record<string, { min: number, max: number, whole?: boolean }>} */
const LIMITS = {
  segments: { min: 0, max: 4096, whole: true },
  crease: { min: 0, max: 180 },
  turn: { min: -180, max: 180 },
  tilt: { min: -89, max: 89 },
  zoom: { min: 0.5, max: 20 },
  lampx: { min: -1, max: 1 },
  lampy: { min: -1, max: 1 },
  ambient: { min: 0, max: 1 },
  diffuse: { min: 0, max: 1 },
  specular: { min: 0, max: 1 },
  exponent: { min: 1, max: 2000 },
  most: { min: 0.1, max: 90 },
  px: { min: 0, max: 0.9999 },
  py: { min: 0, max: 0.9999 },
  measure: { min: -1, max: 99, whole: true },
  seed: { min: 0, max: 2 ** 32 - 1, whole: true },
};

/**
 * The state of a link. Unknown names, unknown values and values of another type are ignored; numbers beyond their limits are moved
 * to them.
 * @param {string} fragment
 * @returns {State}
 */
export function readLink(fragment) {
  /** @type {any} */
  const state = { ...DEFAULTS };
  for (const [name, value] of new URLSearchParams(fragment.replace(/^#/, ''))) {
    if (!Object.hasOwn(DEFAULTS, name)) continue;
    const usual = /** @type {any} */ (DEFAULTS)[name];
    if (typeof usual === 'boolean') state[name] = value === '1';
    else if (typeof usual === 'string') {
      if (!Object.hasOwn(CHOICES, name) || CHOICES[name].includes(value)) state[name] = value;
    } else if (value.trim() !== '' && Number.isFinite(Number(value))) {
      const { min, max, whole } = LIMITS[name];
      const within = Math.min(max, Math.max(min, Number(value)));
      state[name] = whole ? Math.round(within) : within;
    }
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
