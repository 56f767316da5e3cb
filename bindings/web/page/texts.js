// Texts in English and Portuguese, and numbers as each language writes them.

/** @type {Record<string, Record<string, string>>} */
const TEXTS = JSON.parse(document.getElementById('texts')?.textContent ?? '{}');

/** The browser's language, if there are texts in it. */
const usual = navigator.language.toLowerCase().startsWith('pt') ? 'pt' : 'en';
let language = usual;

export const currentLanguage = () => language;

/** @param {string} tag an unknown one is the browser's */
export function setLanguage(tag) {
  language = Object.hasOwn(TEXTS, tag) ? tag : usual;
  document.documentElement.lang = language === 'pt' ? 'pt-BR' : 'en';
}

/**
 * The text of a key, its placeholders `{name}` filled.
 * @param {string} key
 * @param {Record<string, string | number>} [values]
 */
export function text(key, values = {}) {
  const found = TEXTS[language]?.[key] ?? `{${key}}`;
  return found.replace(/\{(\w+)\}/g, (all, name) => (name in values ? String(values[name]) : all));
}

/** A text of the program with the numbers of the language: in Portuguese, commas in numbers and semicolons between them. @param {string} words */
export function numbersIn(words) {
  return language === 'pt' ? words.replace(/(\d), /g, '$1; ').replace(/(\d)\.(\d)/g, '$1,$2') : words;
}

/**
 * @param {number} x
 * @param {number} [digits] significant digits
 */
export function number(x, digits = 4) {
  if (!Number.isFinite(x)) return String(x);
  const size = Math.abs(x);
  const options = { maximumSignificantDigits: digits };
  if (size !== 0 && (size < 1e-4 || size >= 1e7)) return x.toExponential(digits - 1).replace('.', text('decimal-mark'));
  // Adding 0 removes the sign of −0.
  return (x + 0).toLocaleString(language === 'pt' ? 'pt-BR' : 'en-GB', options);
}
