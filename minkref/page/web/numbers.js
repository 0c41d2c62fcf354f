// @ts-check
// Numbers as texts, texts as numbers, and places in lists of them.

/** @param {number} count */
export const counted = (count) => count.toLocaleString("en");
/** @param {number} count @param {string} one */
export const several = (count, one, many = `${one}s`) => `${counted(count)} ${count === 1 ? one : many}`;

/** @param {number} number */
export const short = (number, digits = 6) => String(Number(Number(number).toPrecision(digits)));

/**
 * A long fraction is cut in running text; it is whole where it is chosen.
 * @param {string} text
 * @param {number} kept characters at each end
 */
export const cut = (text, kept = 11, most = 2 * kept + 2) =>
  (text.length > most ? `${text.slice(0, kept)}…${text.slice(-kept)}` : text);

/** @param {number} number @param {number} low @param {number} high */
export const clamped = (number, low, high) => Math.min(Math.max(number, low), high);

/** A number or a fraction; NaN if it is neither. @param {string} text */
export function scaleOf(text) {
  const parts = text.trim().replace(",", ".").split("/");
  if (parts.length > 2 || parts.some((part) => !/^\d*\.?\d+(e[+-]?\d+)?$|^\d+\.$/i.test(part.trim()))) return NaN;
  return parts.length === 2 ? Number(parts[0]) / Number(parts[1]) : Number(parts[0]);
}

/** The first number in an ascending list that is greater than s: its place. @param {number[]} list @param {number} s */
export function placeAfter(list, s) {
  let low = 0, high = list.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (list[middle] > s) high = middle; else low = middle + 1;
  }
  return low;
}

/** The step of round numbers over a length: 1, 2 or 5 times a power of ten. @param {number} length */
export function roundStep(length, least = 4, most = 8) {
  const unit = 10 ** Math.floor(Math.log10(length / least));
  return [1, 2, 5, 10].map((n) => n * unit).find((n) => length / n <= most) ?? 10 * unit;
}

/** The multiples of a round step between two numbers: some four to eight. @param {number} first @param {number} last */
export function roundNumbers(first, last) {
  const step = roundStep(last - first), found = [];
  for (let i = Math.ceil(first / step); i * step <= last * (1 + 1e-12); ++i) found.push(Number((i * step).toPrecision(12)));
  return found;
}
