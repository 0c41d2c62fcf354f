// @ts-check
// Places of the path by one number from 0 to 1, the length up to them over that of the path.
import { clamped, placeAfter } from "../../../page/web/numbers.js";
import { data } from "./data.js";

/** @typedef {{ segment: number, t: number, x: number, y: number }} Place */

/** @type {import("./data.js").Point[]} */
export const corners = [];
for (let i = 0; i < data.path.length; i += 2) corners.push([data.path[i], data.path[i + 1]]);
export const reached = [0];  // at each corner
const farthest = Math.max(...corners.map(([x, y]) => Math.max(Math.abs(x), Math.abs(y)))) || 1;  // no length overflows
for (let i = 1; i < corners.length; ++i) {
  const [dx, dy] = [0, 1].map((axis) => corners[i][axis] / farthest - corners[i - 1][axis] / farthest);
  reached.push(reached[i - 1] + Math.hypot(dx, dy));
}
const length = reached[reached.length - 1];
export const isOnePlace = !(length > 0);
for (let i = 1; i < reached.length; ++i) reached[i] /= isOnePlace ? 1 : length;
/** @param {number} segment */
export const hasLength = (segment) => !isOnePlace && reached[segment + 1] > reached[segment];

/** @param {number} segment @param {number} t */
export const shareOfPlace = (segment, t) => (isOnePlace ? 0 : reached[segment] + t * ((reached[segment + 1] ?? 1) - reached[segment]));

/** @param {number} share @returns {Place} */
export function placeAt(share) {
  if (isOnePlace) return { segment: 0, t: 0, x: corners[0][0], y: corners[0][1] };
  let segment = clamped(placeAfter(reached, share) - 1, 0, corners.length - 2);
  while (segment > 0 && !hasLength(segment)) --segment;
  const t = clamped((share - reached[segment]) / (reached[segment + 1] - reached[segment]), 0, 1);
  const [a, b] = [corners[segment], corners[segment + 1]];
  return { segment, t, x: a[0] + t * (b[0] - a[0]), y: a[1] + t * (b[1] - a[1]) };
}
