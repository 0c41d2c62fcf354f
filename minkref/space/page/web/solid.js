// @ts-check
// The operands, and the sum of a frame, as they are drawn and as they are told.
import { fraction, plus, times } from "../../../page/web/fractions.js";
import { ascending, operands } from "./data.js";

/** @typedef {import("./data.js").Point} Point */
/** @typedef {import("./data.js").Triangle} Triangle */
/** @typedef {import("./data.js").Pair} Pair */
/** @typedef {import("./data.js").Frame} Frame */
/** @typedef {import("./data.js").Which} Which */
/**
 * @typedef {object} Solid a body in the unit of its picture, in which the longest side of its box is 1
 * @property {Point[]} points
 * @property {number[][][]} outlines the rings of each facet, the outer one first
 * @property {Triangle[][]} triangles of each facet
 * @property {string[]} kinds of facets
 * @property {Point[]} normals of facets
 * @property {[number, number, number, number][]} edges from a to b, of two facets
 * @property {Point[]} outward the directions in which vertices stand off the surface
 * @property {number[]} sides of its box
 * @property {number} share the longest side in the unit of the sum
 * @property {Pair[][]} parents of each facet of the sum
 */

/** Unit normal of a ring, by Newell; any for a ring without area in doubles. @param {Point[]} points @param {number[]} ring */
function normalOf(points, ring) {
  const sum = [0, 0, 0];
  for (let k = 0; k < ring.length; ++k) {
    const a = points[ring[k]], b = points[ring[(k + 1) % ring.length]];
    for (let i = 0; i < 3; ++i) {
      const j = (i + 1) % 3, l = (i + 2) % 3;
      sum[i] += (a[j] - b[j]) * (a[l] + b[l]);
    }
  }
  const length = Math.hypot(...sum);
  return length > 0 ? sum.map((axis) => axis / length) : [0, 0, 1];
}

/** @param {number[]} ring @returns {Triangle[]} */
const fan = (ring) => ring.slice(2).map((last, k) => [ring[0], ring[k + 1], last]);

/** Those of two facets, and those of one. @param {number} count @param {number[][][]} outlines */
function edgesOf(count, outlines) {
  const open = new Map();
  /** @type {Solid["edges"]} */
  const edges = [];
  outlines.forEach((rings, facet) => rings.forEach((ring) => ring.forEach((a, k) => {
    const b = ring[(k + 1) % ring.length];
    const key = Math.min(a, b) * count + Math.max(a, b);
    if (open.has(key)) {
      edges.push([a, b, open.get(key), facet]);
      open.delete(key);
    } else {
      open.set(key, facet);
    }
  })));
  for (const [key, facet] of open) edges.push([Math.floor(key / count), key % count, facet, facet]);
  return edges;
}

/** @type {(points: Point[], outlines: number[][][], triangles: Triangle[][], kinds: string[], sides: number[]) => Solid} */
function solid(points, outlines, triangles, kinds, sides) {
  const normals = outlines.map(([ring]) => normalOf(points, ring));
  const outward = points.map(() => [0, 0, 0]);
  outlines.forEach((rings, facet) => rings.forEach((ring) => ring.forEach((a) => {
    for (let i = 0; i < 3; ++i) outward[a][i] += normals[facet][i];
  })));
  for (const direction of outward) {
    const length = Math.hypot(...direction) || 1;
    direction.forEach((axis, i) => { direction[i] = axis / length; });
  }
  const edges = edgesOf(points.length, outlines);
  return { points, outlines, triangles, kinds, normals, edges, outward, sides, share: 1, parents: [] };
}

/** S P ("P") or Q ("Q"). @param {Frame} frame @param {Which} which */
export function operandSolid(frame, which) {
  const body = operands[which], sides = frame[which];
  const share = Math.max(...sides);
  const own = sides.map((side) => side / (share || 1));
  const points = body.near.map((point) => point.map((axis, i) => axis * own[i]));
  const triangles = body.triangles ?? body.faces.map(fan);
  return { ...solid(points, body.faces.map((ring) => [ring]), triangles, body.faces.map(() => (which === "P" ? "fv" : "vf")), own), share };
}

/** @param {Frame} frame */
export function sumSolid(frame) {
  const sides = [0, 1, 2].map((i) => frame.P[i] + frame.Q[i]);
  if (!frame.pairs) {
    const parents = frame.parents.map((pairs) => pairs.map(([P, Q]) => ({ P: ascending(P), Q: ascending(Q) })));
    return { ...solid(frame.near, frame.outlines, frame.triangles, parents.map(kindOf), sides), parents };
  }
  const { pairs, rings } = frame;
  /** @type {Point[]} */
  const points = [];
  for (let v = 0; v < pairs.length; v += 2) {
    const p = operands.P.near[pairs[v]], q = operands.Q.near[pairs[v + 1]];
    points.push([0, 1, 2].map((i) => frame.P[i] * p[i] + frame.Q[i] * q[i]));
  }
  const parents = rings.map((ring) => [{
    P: ascending(ring.map((v) => pairs[2 * v])), Q: ascending(ring.map((v) => pairs[2 * v + 1])),
  }]);
  return { ...solid(points, rings.map((ring) => [ring]), rings.map(fan), parents.map(kindOf), sides), parents };
}

const shorter = new Map([["facet+vertex", "fv"], ["vertex+facet", "vf"], ["edge+edge", "ee"]]);
/** @param {Pair[]} parents */
function kindOf(parents) {
  const names = ["", "vertex", "edge", "facet"];
  const found = new Set(parents.map(({ P, Q }) => `${names[Math.min(P.length, 3)]}+${names[Math.min(Q.length, 3)]}`));
  if (found.size > 1) return "several";
  const [kind] = found;
  return shorter.get(kind) ?? kind;
}

/** Exact coordinates of a vertex of the sum. @param {Frame} frame @param {number} vertex */
export function exactPoint(frame, vertex) {
  if (!frame.pairs) return frame.points[vertex].map(fraction);
  const p = operands.P.exact[frame.pairs[2 * vertex]], q = operands.Q.exact[frame.pairs[2 * vertex + 1]];
  return frame.scale.map((factor, i) => plus(times(fraction(factor), p[i]), q[i]));
}
