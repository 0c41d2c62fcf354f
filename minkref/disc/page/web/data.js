// @ts-check
// The data of the page (docs/command-line.md, "minkref view with a disc"): P, the outer Voronoi diagram, its events and holes.
import { logarithmicAxis } from "../../../page/web/axis.js";
import { Box } from "../../../page/web/canvas.js";
import { dataOf } from "../../../page/web/elements.js";

/** @typedef {[number, number]} Point */
/**
 * @typedef {object} Data
 * @property {[string, number][]} window
 * @property {Point} inside
 * @property {number[]} radii
 * @property {Record<number, number[][]> | null} passages
 * @property {number[][]} features
 * @property {Point | null} point
 * @property {Point} origin
 * @property {[number, number, number, number, number, number][]} sides
 * @property {[number, number, number, number][]} walks
 * @property {unknown[]} gaps
 * @property {number[]} numbers
 * @property {string} kinds
 * @property {number[]} places
 * @property {number[][]} near
 * @property {[number, number, number, number, number][]} halves
 * @property {number[]} motions
 * @property {[number, number, number | null, number, number][]} holes
 * @property {[number, number, number | null, number, number][]} joins
 * @property {number} polygons
 */
/** @typedef {{ change: "birth", hole: number, from: number } | { change: "death", hole: number } | { change: "merge", a: number, b: number }} Change */

/** @type {Data} */
export const data = dataOf("data");
export const axis = logarithmicAxis(data.window[0][1], data.window[1][1]);

// Radii of events are numbered from 0 on; those of the window.
export const firstInside = data.inside[0];
export const endInside = data.inside[1];
/** @param {number} event */
export const isInside = (event) => event >= firstInside && event < endInside;

// Nodes of the diagram: events, then gaps of the hull, at infinity, then reflex vertices. The number of
// the radius of an event counts from 1 on, 0 is that of reflex vertices, and infinity comes last.
export const eventCount = data.kinds.length;
const gapCount = data.gaps.length;
/** @param {number} node */
export const isEvent = (node) => node < eventCount;
/** @param {number} node */
export const isInfinite = (node) => node >= eventCount && node < eventCount + gapCount;

// The events at each radius: the first of them, and where the next radius begins.
export const firstEvents = data.radii.map(() => 0);
for (let event = eventCount - 1; event >= 0; --event) firstEvents[data.numbers[event] - 1] = event;
firstEvents.push(eventCount);
/** The number of the radius. @param {number} event */
export const radiusOf = (event) => data.numbers[event] - 1;
/** @param {number} radius by its number */
export function eventsAt(radius) {
  const first = firstEvents[radius];
  return Array.from({ length: firstEvents[radius + 1] - first }, (_, i) => first + i);
}
/** @param {number} event @returns {Point} */
export const pointOf = (event) => [data.places[2 * event], data.places[2 * event + 1]];

// The changes of holes and components at each event.
/** @type {Map<number, Change[]>} */
export const changes = new Map();
/** @param {number | null} event @param {Change} change */
function note(event, change) {
  if (event === null) return;
  changes.set(event, [...(changes.get(event) ?? []), change]);
}
data.holes.forEach(([, , bornAt, endsAt, from], i) => {
  note(bornAt, { change: "birth", hole: i + 1, from });
  note(endsAt, { change: "death", hole: i + 1 });
});
data.joins.forEach(([, , event, a, b]) => note(event, { change: "merge", a, b }));

// The least box around P.
export const boxOfP = new Box();
for (const [, from] of data.sides) boxOfP.addRing(data.features[from]);
if (data.point) boxOfP.addRing(data.point);
