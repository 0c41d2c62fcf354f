// @ts-check
// The bad polygons: of each segment those that stand on it, corners as places t and scales s.
import { axis, data } from "./data.js";
import { corners } from "./way.js";

/** @typedef {import("./data.js").Point} Point */
/** @typedef {typeof polygons[number]} Polygon */

export const polygons = data.polygons.map(([segment, part, obstacle, ...numbers]) => {
  /** @type {Point[]} */
  const points = [];
  for (let i = 0; i < numbers.length; i += 2) points.push([numbers[i], numbers[i + 1]]);
  const scales = points.map(([, s]) => s);
  return { segment, part, obstacle, points, least: Math.min(...scales), greatest: Math.max(...scales) };
});
/** @type {Map<number, Polygon[]>} */
const onSegment = new Map();
for (const polygon of polygons) {
  const those = onSegment.get(polygon.segment) ?? [];
  onSegment.set(polygon.segment, those);
  those.push(polygon);
}

const isClosed = data.contact === "forbidden";
/** @param {number} segment */
const isPointSegment = (segment) => {
  const [a, b] = [corners[segment], corners[segment + 1] ?? corners[segment]];
  return a[0] === b[0] && a[1] === b[1];
};

/** Sides on the border of the strip belong to a polygon; with contact forbidden all of them do. @type {(a: Point, b: Point) => boolean} */
const isOnBorder = ([t0, s0], [t1, s1]) =>
  (t0 === t1 && (t0 === 0 || t0 === 1)) || (s0 === s1 && (s0 === axis.first || s0 === axis.last));

/** @type {(polygon: Polygon, t: number, s: number) => boolean} */
function holdsPlace({ segment, points, least, greatest }, t, s) {
  if (s < least || s > greatest) return false;
  if (isPointSegment(segment)) return isClosed || (s > least || s === axis.first) && (s < greatest || s === axis.last);
  if (points.length === 1) return points[0][0] === t;
  return points.every((from, i) => {
    const to = points[(i + 1) % points.length];
    if (points.length > 2 && isOnBorder(from, to)) return true;
    const side = (to[0] - from[0]) * (s - from[1]) - (to[1] - from[1]) * (t - from[0]);
    return side > 0 || (isClosed && side === 0);
  });
}

/** @type {(segment: number, t: number, s: number) => Polygon | null} */
export const collisionAt = (segment, t, s) => (onSegment.get(segment) ?? []).find((polygon) => holdsPlace(polygon, t, s)) ?? null;
