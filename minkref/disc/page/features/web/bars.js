// @ts-check
// The merge tree and its bars: what is alive below a radius. Levels count the radii of events below, exactly.
import { logarithmicAxis } from "../../../../page/web/axis.js";
import { placeAfter } from "../../../../page/web/numbers.js";
import { data } from "../../web/data.js";

/**
 * @typedef {object} Features beside the data of the page with a disc
 * @property {[string, number, number | null][]} tree kind, number of the radius, parent
 * @property {number[]} owners by node of the diagram: the node of the tree just above its radius
 * @property {[number, number, number, number, number][]} bars leaf, birth, death, end, whether essential
 */
const features = /** @type {typeof data & Features} */ (data);
const { tree } = features;
export const owners = features.owners;
export const bars = features.bars;

export const axis = logarithmicAxis(2 * data.window[0][1], 2 * data.window[1][1]);

// The bar of each node of the tree that is no root; a filled hole has none.
/** @type {(number | null)[]} */
export const barOf = tree.map(() => null);
bars.forEach(([leaf, , , end], bar) => {
  for (let node = /** @type {number | null} */ (leaf); node !== null && node !== end; node = tree[node][2]) barOf[node] = bar;
});

/** A bar that ends is so long, in doubles. @type {number[]} */
export const lengths = bars.map(([, birth, death, , isEssential]) =>
  (isEssential || death > data.radii.length ? Infinity : 2 * (data.radii[death - 1] - (birth ? data.radii[birth - 1] : 0))));

// Diameters at which features change: numbers of radii, ascending, and how long they are.
export const changes = [...new Set(tree.map(([, number]) => number))]
  .filter((number) => number > 0 && number <= data.radii.length).sort((a, b) => a - b);
export const alphas = changes.map((number) => 2 * data.radii[number - 1]);
const [firstInside, endInside] = data.inside;
/** @param {number} change */
export const isInside = (change) => change in changes && changes[change] > firstInside && changes[change] <= endInside;
/** @type {Map<number, number>} */
const changeOf = new Map(changes.map((number, change) => [number, change]));

/** The changes of birth and death, -1 at the start, for the barcode. @param {number} bar @returns {import("../../../../page/web/barcode.js").Life} */
export function lifeOf(bar) {
  const [, birth, death] = bars[bar];
  return [changeOf.get(birth) ?? -1, changeOf.get(death) ?? changes.length];
}
/** Whether a bar has a part in the window. @param {number} bar */
export const isInWindow = (bar) => bars[bar][1] <= endInside && bars[bar][2] > firstInside;

/** How many radii of events are below a diameter. @param {number} alpha @param {number} at the change, or -1 */
export function levelOf(alpha, at = -1) {
  if (at >= 0) return changes[at] - 1;
  let level = placeAfter(data.radii, alpha / 2);
  while (level > 0 && data.radii[level - 1] >= alpha / 2) --level;
  return level;
}

/** @param {number} bar @param {number} level */
export const isAlive = (bar, level) => bars[bar][1] <= level && level < bars[bar][2];

/** By node of the tree the uppermost one that it is a part of at a level; -1 for those beyond. @param {number} level */
export function topsAt(level) {
  const tops = new Int32Array(tree.length).fill(-1);
  for (let node = tree.length - 1; node >= 0; --node) {
    const [, number, parent] = tree[node];
    if (number <= level) tops[node] = parent !== null && tree[parent][1] <= level ? tops[parent] : node;
  }
  return tops;
}
