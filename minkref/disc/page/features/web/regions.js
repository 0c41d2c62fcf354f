// @ts-check
// Bridges, regions and pocket minima at any diameter: hidden parts of the boundary from foot to foot, joined by bridges.
import { data } from "../../web/data.js";
import { cornerAt, halves, sides, walks } from "../../web/rings.js";
import { barOf, owners, topsAt } from "./bars.js";

/** @typedef {import("../../web/data.js").Point} Point */
/** @typedef {{ from: Point, to: Point, centre: Point }} Bridge */
/** @typedef {{ vertex: Point, depth: number }} Pocket */
/** @typedef {{ bar: number | null, bridges: Bridge[], rings: Point[][], pocket: Pocket | null }} Feature of a filled hole without a bar */

const EQUAL = 1e-9;  // depths that differ by less of themselves count as equal

// Reflex ends: vertices, by nodes of the diagram.
const reflexVertices = data.sides.filter((side) => side[4]).map((side) => vertexAt(side[2]));
const firstReflex = data.numbers.length - reflexVertices.length;

/** @param {number} feature @returns {Point} */
function vertexAt(feature) {
  const [x, y] = data.features[feature];
  return [x, y];
}

/** The nearest point of a half's own side of P. @param {number} half @param {Point} corner @returns {Point} */
function footOf(half, [x, y]) {
  const { feature, isArc, from } = sides[halves[half].fromSide], [p, q] = data.features[from];
  if (isArc) return [p, q];
  const [nx, ny] = data.features[feature], height = nx * (x - p) + ny * (y - q);
  return [x - height * nx, y - height * ny];
}

/** The vertices between the feet of two halves. @param {number} from @param {number} to */
function between(from, to) {
  const walk = walks[halves[from].walk], /** @type {Point[]} */ found = [];
  let side = halves[from].toSide;
  /** @param {number} end */
  const goTo = (end) => {
    for (; side !== end; side = side + 1 === walk.endSide ? walk.firstSide : side + 1) {
      if (!sides[side].isArc) found.push(vertexAt(sides[side].to));
    }
  };
  for (let half = from; half !== to;) {
    half = half + 1 === walk.end ? walk.first : half + 1;
    goTo(halves[half].fromSide);
    if (half !== to) goTo(halves[half].toSide);
  }
  return found;
}

/** @param {number} half */
const lowerNode = (half) => (halves[half].isRising ? halves[half].from : halves[half].to);

/** All features below a level, by their uppermost nodes of the tree. @param {number} level @param {number} radius */
export function featuresAt(level, radius) {
  const tops = topsAt(level), /** @type {Map<number, Feature>} */ found = new Map();
  /** @param {number} node of the diagram */
  const featureAt = (node) => {
    const top = tops[owners[node]], known = found.get(top);
    if (known) return known;
    const made = /** @type {Feature} */ ({ bar: barOf[top], bridges: [], rings: [], pocket: null });
    found.set(top, made);
    return made;
  };
  data.numbers.forEach((number, node) => { if (number <= level) featureAt(node); });
  // Feet by half, and the part that starts at a half.
  const feet = /** @type {Map<number, Point>} */ (new Map()), next = /** @type {Map<number, number>} */ (new Map());
  halves.forEach((half, k) => {
    if (!half.isRising || half.low > level || half.high <= level) return;
    const centre = cornerAt(half, radius), from = footOf(k, centre), to = footOf(half.twin, centre);
    feet.set(k, from).set(half.twin, to);
    featureAt(half.from).bridges.push({ from, to, centre });
  });
  /** @param {number} half */
  const foot = (half) => /** @type {Point} */ (feet.get(half));
  walks.forEach(({ first, end, firstSide, endSide }) => {
    const corners = /** @type {number[]} */ ([]);
    for (let k = first; k < end; ++k) if (feet.has(k)) corners.push(k);
    corners.forEach((from, i) => { if (!halves[from].isRising) next.set(from, corners[(i + 1) % corners.length]); });
    if (corners.length || first === end || halves[first].low > level) return;
    const ring = sides.slice(firstSide, endSide).filter((side) => !side.isArc).map((side) => vertexAt(side.to));
    featureAt(lowerNode(first)).rings.push(ring);
  });
  while (next.size) {
    const [start] = next.keys(), /** @type {Point[]} */ ring = [];
    for (let from = start, to = next.get(from); to !== undefined; from = halves[to].twin, to = next.get(from)) {
      next.delete(from);
      ring.push(foot(from), ...between(from, to), foot(to));
    }
    featureAt(lowerNode(start)).rings.push(ring);
  }
  findPockets(found, tops);
  return [...found.values()];
}

/** The deepest vertex of each feature, of equally deep ones the least. @param {Map<number, Feature>} found @param {Int32Array} tops */
function findPockets(found, tops) {
  reflexVertices
    .map((vertex, k) => ({ vertex, leaf: owners[firstReflex + k] }))
    .sort((a, b) => a.leaf - b.leaf)
    .forEach(({ vertex, leaf }) => {
      const feature = found.get(tops[leaf]);
      if (!feature) return;
      const depth = depthOf(vertex, feature.bridges);
      if (!feature.pocket || depth > feature.pocket.depth * (1 + EQUAL)) feature.pocket = { vertex, depth };
    });
}

/** Its least distance from the lines of the bridges. @param {Point} vertex @param {Bridge[]} bridges */
function depthOf([x, y], bridges) {
  let least = Infinity;
  for (const { from, to } of bridges) {
    const dx = to[0] - from[0], dy = to[1] - from[1], length = Math.hypot(dx, dy);
    const across = length ? Math.abs(dx * (y - from[1]) - dy * (x - from[0])) / length : Math.hypot(x - from[0], y - from[1]);
    least = Math.min(least, across);
  }
  return least;
}

/** The area of a region: its rings have it on the right. @param {Point[][]} rings */
export function areaOf(rings) {
  let twice = 0;
  for (const ring of rings) {
    const [ox, oy] = ring[0] ?? [0, 0];
    ring.forEach(([x, y], i) => {
      const [p, q] = ring[(i + 1) % ring.length];
      twice -= (x - ox) * (q - oy) - (p - ox) * (y - oy);
    });
  }
  return twice / 2;
}
