// @ts-check
// The sum at a scale as polygons in canonical order (docs/definitions.md, "Canonical form").
import { axis } from "./data.js";
import { timeline, xOf, yOf } from "./timeline.js";

/** @typedef {[number, number][]} Points */

/** @param {Points} a @param {Points} b */
function compareRings(a, b) {
  const n = Math.min(a.length, b.length);
  for (let i = 0; i < n; ++i) {
    if (a[i][0] !== b[i][0]) return a[i][0] - b[i][0];
    if (a[i][1] !== b[i][1]) return a[i][1] - b[i][1];
  }
  return a.length - b.length;
}

/** From the lexicographically smallest vertex on. @param {number[]} vertices @param {number} s */
function canonicalRing(vertices, s) {
  /** @type {Points} */
  const points = vertices.map((track) => [xOf(track, s), yOf(track, s)]);
  let least = 0;
  for (let i = 1; i < points.length; ++i) {
    const [x, y] = points[i], [u, v] = points[least];
    if (x < u || (x === u && y < v)) least = i;
  }
  return [...points.slice(least), ...points.slice(0, least)];
}

/** The polygons at a number of the window. @param {number} s */
export function canonicalPolygons(s) {
  if (!axis.has(s)) throw new RangeError(`the scale ${s} is outside of the window`);
  /** @type {Map<number, { outer: Points, holes: Points[] }>} */
  const polygons = new Map();  // by component
  for (const { isHole, component, vertices } of timeline.at(s).values()) {
    const polygon = polygons.get(component) ?? { outer: [], holes: [] }, ring = canonicalRing(vertices, s);
    if (isHole) polygon.holes.push(ring); else polygon.outer = ring;
    polygons.set(component, polygon);
  }
  const sorted = [...polygons.values()];
  for (const polygon of sorted) polygon.holes.sort(compareRings);
  return sorted.sort((a, b) => compareRings(a.outer, b.outer));
}
