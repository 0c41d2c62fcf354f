// @ts-check
// Frames, facets and vertices in words.
import { about, fraction, times, written } from "../../../page/web/fractions.js";
import { counted, cut, several } from "../../../page/web/numbers.js";
import { kinds, operands } from "./data.js";
import { exactPoint } from "./solid.js";

/** @typedef {import("./data.js").Frame} Frame */
/** @typedef {import("./data.js").Fraction} Fraction */
/** @typedef {import("./data.js").Pair} Pair */
/** @typedef {import("./data.js").Which} Which */
/** @typedef {import("./solid.js").Solid} Solid */

const LONGEST = 22;  // characters of a number in running text
/** @param {string} text */
export const signed = (text) => text.replace("-", "−");
/** @param {string} text */
export const cutText = (text) => cut(text, LONGEST, 2 * LONGEST);
/** @param {Fraction} number */
function short(number) {
  const text = written(number);
  return text.length <= LONGEST ? signed(text) : `≈ ${about(number)}`;
}

/** @type {Record<string, string>} */
export const meaning = {
  "fv": "facet of P + vertex of Q", "vf": "vertex of P + facet of Q", "ee": "edge of P + edge of Q",
  "facet+edge": "facet of P + edge of Q", "edge+facet": "edge of P + facet of Q", "facet+facet": "facet of P + facet of Q",
  "several": "of different kinds, in one plane",
};
/** @param {Fraction[]} point */
const place = (point) => `(${point.map(short).join(", ")})`;

/** @param {string[]} scale */
export function scaleText(scale, whole = false) {
  /** @param {string} text */
  const told = (text) => (whole || text.length <= LONGEST ? text : `≈ ${about(fraction(text))}`);
  return new Set(scale).size === 1 ? told(scale[0]) : `(${scale.map(told).join(", ")})`;
}

/** "vertex 3 of P", "edge 3–7 of P", "facet 5 of P". @param {Which} which @param {number[]} vertices */
function faceText(which, vertices) {
  if (vertices.length === 1) return `vertex ${vertices[0]} of ${which}`;
  if (vertices.length === 2) return `edge ${vertices[0]}–${vertices[1]} of ${which}`;
  return `facet ${operands[which].numbers.get(vertices.join())} of ${which}`;
}
/** @param {Pair} pair */
const pairText = ({ P, Q }) => `${faceText("P", P)} + ${faceText("Q", Q)}`;
/** @type {(parents: Pair[], most: number, between: string) => string} */
export function parentsText(parents, most, between) {
  const told = parents.slice(0, most).map(pairText);
  if (parents.length > most) told.push(`${parents.length - most} more`);
  return told.join(between);
}
/** @param {Solid} picture @param {number} facet */
const cornersOf = (picture, facet) => picture.outlines[facet].reduce((sum, ring) => sum + ring.length, 0);
/** @param {{ components: number, cavities: number, tunnels: number }} frame */
export const shapeText = ({ components, cavities, tunnels }) =>
  `${several(components, "component")}, ${several(cavities, "cavity", "cavities")}, ${several(tunnels, "tunnel")}`;

/** @param {Frame} frame */
function volumeText(frame) {
  const volume = fraction(frame.volume);
  const exact = written(volume);
  return exact.length <= LONGEST ? exact : `≈ ${about(volume)}`;
}

/** @param {Frame} frame */
export function captionText(frame) {
  const parts = kinds.filter((kind) => frame.kinds[kind]).map((kind) => `${counted(frame.kinds[kind])} ${kind}`);
  return `${counted(frame.vertices)} vertices, ${counted(frame.edges)} edges, ${several(frame.facets, "facet")}: ` +
    `${parts.join(", ")}. ${frame.pairs ? "" : `${shapeText(frame)}. `}Volume ${volumeText(frame)}. SHA-256 ${frame.digest.slice(0, 12)}…`;
}

/**
 * The text at the pointer for a facet or vertex of a picture.
 * @type {(name: "sum" | Which, picture: Solid, frame: Frame, what: string, number: number) => string}
 */
export function tipText(name, picture, frame, what, number) {
  const corners = what === "facet" ? several(cornersOf(picture, number), "corner") : "";
  if (name === "sum") {
    if (what === "facet") {
      return `facet ${number}: ${picture.kinds[number]}, ${corners}\n${parentsText(picture.parents[number], 4, "\n")}`;
    }
    if (!frame.pairs) return `vertex ${number}\n${place(exactPoint(frame, number))}`;
    const [p, q] = frame.pairs.slice(2 * number, 2 * number + 2);
    return `vertex ${number}\nvertex ${p} of P + vertex ${q} of Q\n${place(exactPoint(frame, number))}`;
  }
  if (what === "facet") return `facet ${number} of ${name}, ${corners}`;
  return `vertex ${number} of ${name}\n${place(operandPoint(name, frame, number))}${name === "P" ? ", scaled" : ""}`;
}

/** @type {(name: Which, frame: Frame, number: number) => Fraction[]} */
function operandPoint(name, frame, number) {
  const point = operands[name].exact[number];
  return name === "P" ? point.map((axis, i) => times(fraction(frame.scale[i]), axis)) : point;
}
