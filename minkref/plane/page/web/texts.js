// @ts-check
// Scales, holes and events in words.
import { featureFill } from "../../../page/web/colours.js";
import { node, swatch } from "../../../page/web/elements.js";
import { cut, short } from "../../../page/web/numbers.js";
import { data, isInside } from "./data.js";

/** @typedef {import("./data.js").Life} Life */

/** @type {Record<string, string>} */
export const kindNames = { b: "birth", d: "death", s: "swap", t: "touch" };

/** @param {number} event */
export function exactAndAbout(event, whole = false) {
  const exact = data.scales[event], about = short(data.about[event]);
  return exact === about ? exact : `${whole ? exact : cut(exact)} ≈ ${about}`;
}

/** @type {Record<string, (Life | null)[]>} */
export const lives = { h: data.holes, c: data.components };
/** @param {Life} life */
export const bornText = ([event], whole = false) => (isInside(event) ? `born at ${exactAndAbout(event, whole)}` : "there when the window begins");
/** @param {Life} life */
export const diedText = ([, event], whole = false) => (isInside(event) ? `dies at ${exactAndAbout(event, whole)}` : "there when the window ends");

/**
 * An erosion's name for a feature of the sum of the outside: holes are its components, and components its holes; that
 * of the box is around it. @param {string} feature @param {number} id
 */
function erodedName(feature, id) {
  if (feature === "h") return id === 0 ? "beyond the box" : `component ${id - 1}`;
  return id === 0 ? "the outside" : `hole ${id}`;
}

/** @param {string} feature @param {number} id */
export function featureName(feature, id) {
  if (data.erode) return erodedName(feature, id);
  return feature === "h" && id === 0 ? "the outside" : `${feature === "h" ? "hole" : "component"} ${id}`;
}

/** @param {string} feature @param {number} id */
export function describe(feature, id) {
  const life = lives[feature][id], name = featureName(feature, id);
  return life ? `${name}: ${bornText(life)}, ${diedText(life)}` : name;
}

/** @type {(cell: Element, feature: string, ids: number[]) => void} */
function nameList(cell, feature, ids) {
  ids.forEach((id, i) => {
    if (i) cell.append(i === ids.length - 1 ? " and " : ", ");
    cell.append(node("span", { class: "name" }, swatch(featureFill(feature, id)), featureName(feature, id)));
  });
}

/** "hole 3 dies", "hole 4 splits into hole 4 and hole 9". @param {Element} cell @param {import("./data.js").Change} change */
export function tellChange(cell, [, feature, change, before, after]) {
  nameList(cell, feature, before.length ? before : after);
  if (change === "split" || change === "merge") {
    cell.append(" → ");
    nameList(cell, feature, after);
  }
}
