// @ts-check
// Exact numbers: fractions of whole numbers [n, d] with d > 0. Sums and products are in lowest terms.

/** @typedef {[bigint, bigint]} Fraction */

/** @param {bigint} a @param {bigint} b */
function gcd(a, b) {
  if (a < 0n) a = -a;
  while (b) [a, b] = [b, a % b];
  return a;
}

/** @type {(n: bigint, d: bigint) => Fraction} */
function lowest(n, d) {
  const common = gcd(n, d);
  return common > 1n ? [n / common, d / common] : [n, d];
}

/** Of a text as minkref writes it: n or n/d. @type {(text: string) => Fraction} */
export function fraction(text) {
  const [n, d = "1"] = text.split("/");
  return [BigInt(n), BigInt(d)];
}
/** @type {(a: Fraction, b: Fraction) => Fraction} */
export const plus = ([a, b], [c, d]) => lowest(a * d + c * b, b * d);
/** @type {(a: Fraction, b: Fraction) => Fraction} */
export const times = ([a, b], [c, d]) => lowest(a * c, b * d);
/** Its sign compares both. @type {(a: Fraction, b: Fraction) => bigint} */
export const difference = (a, b) => a[0] * b[1] - b[0] * a[1];
/** @param {Fraction} fraction */
export const written = ([n, d]) => (d === 1n ? String(n) : `${n}/${d}`);

/** To eight digits, of numbers of any size. @param {Fraction} fraction */
export function about([n, d]) {
  const sign = n < 0n ? "−" : "", size = n < 0n ? -n : n;
  if (!size) return "0";
  const places = 18 - (String(size).length - String(d).length);
  const digits = places >= 0 ? (size * 10n ** BigInt(places)) / d : size / (d * 10n ** BigInt(-places));
  const value = Number(`${digits}e${-places}`);
  if (value >= 1e-4 && value < 1e12) return sign + Number(value.toPrecision(8));
  const lead = String(digits);
  return `${sign}${Number(`${lead[0]}.${lead.slice(1)}`).toPrecision(8).replace(/\.?0+$/, "")}e${lead.length - 1 - places}`;
}

/** Of a text as people type it, decimal or n/d; null if it is neither. @type {(text: string) => Fraction | null} */
export function typedFraction(text) {
  const parts = text.trim().replace(",", ".").split("/").map(decimal), [first, second = [1n, 1n]] = parts;
  if (parts.length > 2 || !first || !second || second[0] === 0n) return null;
  return [first[0] * second[1], first[1] * second[0]];
}

/** @type {(text: string) => Fraction | null} */
function decimal(text) {
  const found = /^(\d*)\.?(\d*)(?:e([+-]?\d{1,3}))?$/i.exec(text.trim());
  if (!found || !(found[1] + found[2])) return null;
  const power = Number(found[3] ?? 0) - found[2].length, digits = BigInt(found[1] + found[2]);
  return power < 0 ? [digits, 10n ** BigInt(-power)] : [digits * 10n ** BigInt(power), 1n];
}

/** A double is a fraction, too. @type {(number: number) => Fraction} */
export function fractionOfDouble(number) {
  let d = 1n;
  while (!Number.isInteger(number)) { number *= 2; d *= 2n; }
  return [BigInt(number), d];
}
