// @ts-check
// Bars and features in words.
import { counted, short } from "../../../../page/web/numbers.js";
import { data } from "../../web/data.js";
import { alphas, bars, changes, lengths } from "./bars.js";

/** A diameter by the number of its radius. @param {number} number */
const diameter = (number) => short(2 * data.radii[number - 1], 9);
/** @param {number} bar */
export const bornText = (bar) => (bars[bar][1] ? `born at α = ${diameter(bars[bar][1])}` : "there from the start");
/** @param {number} bar */
export function endText(bar) {
  const [, , death, , isEssential] = bars[bar];
  if (death > data.radii.length) return "never ends";
  return isEssential ? `its hole is filled at α = ${diameter(death)}` : `ends at α = ${diameter(death)}`;
}
/** @param {number} bar */
export const describe = (bar) => `feature ${counted(bar)}: ${bornText(bar)}, ${endText(bar)}`;
/** @param {number} bar */
export const lengthText = (bar) => (Number.isFinite(lengths[bar]) ? short(lengths[bar], 9) : "longer than any number");

/** Coordinates are those of P again. @param {number[]} point */
export const pointText = ([x, y]) => `(${short(x + data.origin[0], 9)}, ${short(y + data.origin[1], 9)})`;

/** Births and ends at a change. @param {number} change */
export function changeText(change) {
  const number = changes[change];
  const births = bars.filter((bar) => bar[1] === number).length, deaths = bars.filter((bar) => bar[2] === number).length;
  const told = [births ? `${counted(births)} born` : "", deaths ? `${counted(deaths)} ending` : ""].filter(Boolean).join(", ");
  return `α = ${short(alphas[change], 9)}: ${told || "no bar begins or ends"}`;
}
