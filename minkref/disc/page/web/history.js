// @ts-check
// Holes by name, and counts, at any radius.
import { data, endInside, firstInside, isInfinite } from "./data.js";
import { halves, ringsOf, walks } from "./rings.js";

/** @typedef {import("./rings.js").Ring & { hole: number }} NamedRing with the number of the hole in front of it, 0 for the outside */

/** @type {(hole: import("./data.js").Data["holes"][number]) => import("../../../page/web/barcode.js").Life | null} */
const lifeOf = ([birth, end]) => (birth - 1 < endInside && end - 1 >= firstInside ? [birth - 1, end - 1] : null);
/** @type {import("../../../page/web/barcode.js").Lives} */
export const lives = { h: [null, ...data.holes.map(lifeOf)], c: [] };

/** The boundary between two radii. */
export const boundary = {
  gap: -1,
  /** @type {NamedRing[]} */
  rings: [],

  /** @param {number} gap */
  at(gap) {
    if (gap === this.gap) return this.rings;
    const holeOf = holesOfNodes(gap);
    this.rings = data.point ? [{ walk: 0, corners: [], hole: 0 }] : ringsOf(gap).map((ring) => {
      const half = ring.corners.length ? ring.corners[0].half : halves[walks[ring.walk].first];
      const isFree = half && walks[ring.walk].first !== walks[ring.walk].end;
      const node = isFree && data.numbers[half.to] > gap ? half.to : half?.from;
      return { ...ring, hole: isFree ? holeOf(node) : 0 };
    });
    this.gap = gap;
    return this.rings;
  },
};

/** The rest of the diagram, beyond a radius, falls into parts, one for each hole. @param {number} gap */
function holesOfNodes(gap) {
  const outside = data.numbers.length, roots = Int32Array.from({ length: outside + 1 }, (_, node) => node);
  /** @param {number} node */
  const root = (node) => {
    while (roots[node] !== node) node = roots[node] = roots[roots[node]];
    return node;
  };
  for (const { from, to, low } of halves) if (low > gap) roots[root(from)] = root(to);
  for (let node = 0; node < outside; ++node) if (isInfinite(node)) roots[root(node)] = root(outside);
  const names = new Map();
  data.holes.forEach(([birth, end, , endsAt], i) => {
    if (birth <= gap && gap < end) names.set(root(endsAt), i + 1);
  });
  return /** @param {number} node */ (node) => names.get(root(node)) ?? 0;
}

/** At the radius of an event, where components that only touch are not one yet, or just anywhere. @param {number} gap @param {boolean} isAtEvent */
export function countsAt(gap, isAtEvent) {
  const holes = data.holes.filter(([birth, end]) => birth <= gap && gap < end).length;
  const joined = data.joins.filter(([radius, atRadius]) => (isAtEvent && radius === gap ? atRadius : radius <= gap));
  return { holes, components: data.polygons - joined.length };
}
