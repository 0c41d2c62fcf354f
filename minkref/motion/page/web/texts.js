// @ts-check
// Contacts and places in words.
import { cut, short } from "../../../page/web/numbers.js";

/** @param {import("./data.js").Feature} feature */
export function featureText(feature) {
  const [kind, [ring, index]] = Object.entries(feature)[0];
  return ring === 0 ? `${kind} ${index}` : `${kind} ${index} in ring ${ring}`;
}

/** @param {string[]} point */
const pointText = (point) => `(${point.map((text) => cut(text)).join(", ")})`;
/** @param {string} text @param {number} about */
export const exactAndAbout = (text, about) => (text === short(about) ? text : `${text} ≈ ${short(about)}`);
/** @param {import("./way.js").Place} place */
export const placeText = ({ segment, t, x, y }) => `segment ${segment}, t = ${short(t, 4)}, (${short(x, 5)}, ${short(y, 5)})`;
export const boundColour = { blocks: "death", frees: "birth" };

/** @param {import("./data.js").Range} range */
export function rangeText(range) {
  if (range.from === range.to) return `${range.from} alone`;
  return `${range.from_in ? "[" : "("}${range.from}, ${range.to ?? "infinity"}${range.to_in ? "]" : ")"}`;
}

/** A bound in words: the lines of the box below the diagram. @param {import("./data.js").Bound} bound */
export function boundLines(bound) {
  const { at, about } = bound;
  return [
    `At the scale ${exactAndAbout(bound.scale, about.scale)} the contact ${bound.event === "blocks" ? "blocks: scales just above are not valid" : "frees: scales just below are not valid"}.`,
    `${featureText(bound.part)} of the part and ${featureText(bound.obstacle)} of the obstacles touch at ${pointText(bound.touching)}.`,
    `Segment ${at.segment} of the path, t = ${exactAndAbout(at.t, about.t)}, ${pointText(at.point)}.`,
  ];
}
