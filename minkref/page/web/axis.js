// @ts-check
// The axis of scales: each is a share of its length, from 0 to 1.
import { clamped, roundNumbers } from "./numbers.js";
import { svg } from "./svg.js";

/**
 * @typedef {object} Axis
 * @property {number} first
 * @property {number} last
 * @property {(s: number) => number} clamp
 * @property {(s: number) => boolean} has
 * @property {(s: number) => number} shareOf
 * @property {(share: number) => number} scaleAt never outside of the window
 * @property {() => number[]} rounds round numbers of the window
 */

/** @param {number} first @param {number} last */
function ends(first, last) {
  return {
    first, last,
    clamp: /** @param {number} s */ (s) => clamped(s, first, last),
    has: /** @param {number} s */ (s) => s >= first && s <= last,
  };
}

/** @param {number} first @param {number} last @returns {Axis} */
export function linearAxis(first, last) {
  const { clamp, has } = ends(first, last);
  return {
    first, last, clamp, has,
    shareOf: (s) => (s - first) / (last - first),
    scaleAt: (share) => clamp(first + share * (last - first)),
    rounds: () => roundNumbers(first, last),
  };
}

/** @param {number} first @param {number} last @returns {Axis} */
export function logarithmicAxis(first, last) {
  const { clamp, has } = ends(first, last), logFirst = Math.log(first), length = Math.log(last) - Math.log(first);
  return {
    first, last, clamp, has,
    shareOf: (s) => (Math.log(s) - logFirst) / length,
    scaleAt: (share) => clamp(Math.exp(logFirst + clamped(share, 0, 1) * length)),
    rounds: () => roundScales(first, last, length / Math.LN10),
  };
}

/**
 * 1, 2, 5 in each power of ten if there are several, else more.
 * @param {number} first
 * @param {number} last
 * @param {number} decades
 */
function roundScales(first, last, decades) {
  const found = [];
  if (decades >= 0.8) {
    const steps = decades > 8 ? [1] : decades > 4 ? [1, 3] : [1, 2, 5];
    const stride = Math.ceil(decades / 12);
    for (let e = Math.floor(Math.log10(first)); e <= Math.log10(last) + 1; e += stride) {
      for (const step of steps) found.push(Number(`${step}e${e}`));
    }
  } else {
    found.push(...roundNumbers(first, last));
  }
  return found.filter((s) => s >= first * (1 - 1e-12) && s <= last * (1 + 1e-12));
}

/**
 * Ticks from `left` to `left + width`, with labels at height `y` where there is room for them.
 * @param {Axis} axis
 * @param {number} left
 * @param {number} width
 * @param {number} top
 * @param {number} bottom
 * @param {number} y
 */
export function axisTicks(axis, left, width, top, bottom, y) {
  const group = svg("g", { class: "axis" });
  let taken = -Infinity;
  for (const s of axis.rounds()) {
    const x = left + width * axis.shareOf(s), half = 3.5 * String(s).length;
    group.append(svg("line", { x1: x, x2: x, y1: top, y2: bottom }));
    if (x - half < taken) continue;
    group.append(svg("text", { x, y, "text-anchor": "middle" }, String(s)));
    taken = x + half + 3;
  }
  return group;
}
