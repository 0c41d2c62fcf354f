// @ts-check
// Exact numbers as people write them, and numbers in doubles as short exact decimals.

import { times, typedFraction, written } from "../../../page/web/fractions.js";

const DECIMAL = /^([+-]?)(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d{1,3})?$/i;
const FRACTION = /^[+-]?\d+\/0*[1-9]\d*$/;

/** The double next to a text, a decimal or n/d; NaN for anything else. @param {string} text */
export function numberOf(text) {
  const word = text.trim();
  if (DECIMAL.test(word)) return Number(word);
  if (!FRACTION.test(word)) return NaN;
  const [n, d] = word.split("/");
  return Number(n) / Number(d);
}

/** The number of a text in lowest terms, n or n/d. @param {string} text */
export function lowestTerms(text) {
  const word = text.trim(), found = typedFraction(word.replace(/^[+-]/, ""));
  if (!found) return "";
  const number = written(times(found, [1n, 1n]));
  return word.startsWith("-") && number !== "0" ? `-${number}` : number;
}

/** The power of ten at or below a length: its exponent. @param {number} length */
export const exponentBelow = (length) => Math.floor(Math.log10(length));

/**
 * The multiple of a power of ten next to a number, as a decimal without needless zeros.
 * @param {number} number
 * @param {number} exponent
 */
export function roundedText(number, exponent) {
  if (exponent < -100 || Math.abs(number) >= 1e21) return String(Number(number.toPrecision(15)));
  if (exponent < 0) {
    const text = number.toFixed(-exponent).replace(/\.?0+$/, "");
    return text === "-0" ? "0" : text;
  }
  const text = String(BigInt(Math.round(number / 10 ** exponent)) * 10n ** BigInt(exponent));
  return text;
}
