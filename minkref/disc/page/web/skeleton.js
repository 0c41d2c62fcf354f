// @ts-check
// The parts of the outer Voronoi diagram: straight ones, and parabolas between a vertex and an edge.
import { data, isEvent, isInfinite, radiusOf } from "./data.js";
import { cornerAt, halves, motionOf, placeOf } from "./rings.js";

/** @typedef {import("./data.js").Point} Point */
/** @typedef {{ from: Point, to: Point, bend: Point | null }} Part `bend`: where a parabola's tangents at its ends meet */

/** Each part once. Parts that go on to infinity end at the radius `far`, or beyond. @param {number} far */
export function skeletonParts(far) {
  /** @type {Part[]} */
  const parts = [];
  halves.forEach((half, k) => {
    if (half.twin < k) return;
    const [low, high] = half.isRising ? [half.from, half.to] : [half.to, half.from];
    const radii = [low, high].map((node) => (isEvent(node) ? data.radii[radiusOf(node)] : 0));
    if (isInfinite(high)) radii[1] = Math.max(far, 2 * radii[0]);
    const from = placeOf(low, half) ?? cornerAt(half, radii[0]), to = placeOf(high, half) ?? cornerAt(half, radii[1]);
    const [ax, ay, r, rest, bx, by, k0, k1, cx, cy] = motionOf(half);
    if (k1 || !(k0 > 0)) { parts.push({ from, to, bend: null }); return; }
    // u to a side of the vertex a corner has gone u² / k0 from the middle between it and the line.
    const [u, v] = radii.map((radius) => Math.sqrt(Math.max((radius - r - rest) * k0, 0)));
    const up = (u * v) / k0, across = (u + v) / 2;
    parts.push({ from, to, bend: [ax + up * bx + across * cx, ay + up * by + across * cy] });
  });
  return parts;
}
