// @ts-check
// Radii, holes, events and features in words.
import { several, short } from "../../../page/web/numbers.js";
import { data, firstEvents } from "./data.js";
import { lives } from "./history.js";

/** @typedef {import("../../../page/web/barcode.js").Life} Life */

/** @type {Record<string, string>} */
export const kindNames = { c: "corner", j: "joint", s: "saddle", r: "ridge", m: "maximum" };
/** @type {Record<string, string>} */
const kindPlurals = { c: "corners", j: "joints", s: "saddles", r: "ridges", m: "maxima" };
/** The colours of those that change holes and components. @type {Record<string, string>} */
export const kindColours = { s: "birth", r: "touch", m: "death" };
/** @type {Record<string, string>} */
export const kindTexts = {
  c: "as far from three features or more: curves start or stop to be on the boundary",
  j: "right in front of an end of an edge: a curve passes from its line to the arc about the end",
  s: "right between two features, nearest to each other there: curves start to touch",
  r: "right between two features, and as far from a third: all between parallel edges may be reached at once",
  m: "inside of the triangle of its features: a hole ends",
};
/** @param {number} event */
export const isTopology = (event) => data.kinds[event] in kindColours;

/** @param {number} radius by its number */
export const radiusText = (radius, digits = 9) => short(data.radii[radius], digits);
/** @param {number} id */
export const featureName = (id) => (id === 0 ? "the outside" : `hole ${id}`);
/** @param {number} born by the number of the radius */
export const bornText = (born) => (born < 0 ? "a hole of P, there from the start" : `born at the radius ${radiusText(born)}`);
/** @param {number} end by the number of the radius */
export const diedText = (end) => `ends at the radius ${radiusText(end)}`;
/** @param {number} id */
export function describe(id) {
  const life = lives.h[id];
  return life ? `${featureName(id)}: ${bornText(life[0])}, ${diedText(life[1])}` : featureName(id);
}

/** Coordinates are those of P again. @param {number[]} point */
export const pointText = ([x, y], digits = 9) => `(${short(x + data.origin[0], digits)}, ${short(y + data.origin[1], digits)})`;
/** @param {number} number */
export function featureText(number) {
  const feature = data.features[number];
  return feature.length === 2 ? `vertex ${pointText(feature)}` : `edge ${feature[2]}.${feature[3]}`;
}

/** "2 corners, 1 saddle": the events at one radius. @param {number} radius by its number */
export function kindsAt(radius) {
  const kinds = data.kinds.slice(firstEvents[radius], firstEvents[radius + 1]);
  return Object.keys(kindNames).map((kind) => ({ kind, count: kinds.split(kind).length - 1 })).filter(({ count }) => count)
    .map(({ kind, count }) => several(count, kindNames[kind], kindPlurals[kind])).join(", ");
}

/** @param {import("./data.js").Change} what */
export function changeText(what) {
  if (what.change === "merge") return `the components of polygons ${what.a} and ${what.b} become one`;
  return what.change === "death" ? `hole ${what.hole} ends` : `hole ${what.hole} is born, of ${what.from ? `hole ${what.from}` : "the outside"}`;
}
