// @ts-check
// Whether a scale is valid is decided exactly.
import { difference, fraction } from "../../../page/web/fractions.js";
import { data } from "./data.js";

/** @typedef {import("../../../page/web/fractions.js").Fraction} Fraction */

const ranges = data.valid.map((range) => ({
  ...range, low: fraction(range.from), high: range.to === null ? null : fraction(range.to),
}));

/** @param {Fraction | null} scale */
export const isValid = (scale) => scale !== null && ranges.some((range) => {
  const low = difference(scale, range.low), high = range.high ? difference(scale, range.high) : -1n;
  return (low > 0n || (range.from_in && low === 0n)) && (high < 0n || (range.to_in && high === 0n));
});
