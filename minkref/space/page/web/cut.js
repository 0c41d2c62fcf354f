// @ts-check
// A plane across an axis that takes away a part of the sum, and what it lays open.
import { colour } from "../../../page/web/colours.js";
import { element, input, isChecked } from "../../../page/web/elements.js";
import { addFan, columns, meshTrace, newMesh, STAND_OFF } from "./traces.js";
import { signed } from "./texts.js";

/** @typedef {import("./data.js").Point} Point */
/** @typedef {import("./data.js").Triangle} Triangle */
/** @typedef {import("./solid.js").Solid} Solid */
/** @typedef {[Point, Point]} Segment */
/** @typedef {{ axis: number, at: number, side: number }} Plane what has side * (coordinate - at) <= 0 is left */
/** @typedef {Plane | null} Cut */

/** @param {Point} point @param {Plane} plane */
const height = (point, { axis, at, side }) => side * (point[axis] - at);
/** @param {Point} point @param {Cut} cut */
export const isLeft = (point, cut) => !cut || height(point, cut) <= 0;

/** @type {(a: Point, b: Point, plane: Plane) => Point} */
function between(a, b, cut) {
  const s = height(a, cut), t = height(b, cut), part = s / (s - t);
  return a.map((axis, i) => (i === cut.axis ? cut.at : axis + part * (b[i] - axis)));
}
/** The same for the two triangles at an edge. @type {(points: Point[], v: number, w: number, plane: Plane) => Point} */
const crossing = (points, v, w, cut) => (v < w ? between(points[v], points[w], cut) : between(points[w], points[v], cut));

/** The rest of a triangle after the cut: its corners. @type {(points: Point[], triangle: Triangle, cut: Cut) => Point[]} */
export function leftOf(points, triangle, cut) {
  if (!cut) return triangle.map((v) => points[v]);
  return triangle.flatMap((v, k) => {
    const w = triangle[(k + 1) % 3], here = isLeft(points[v], cut);
    return [...(here ? [points[v]] : []), ...(here !== isLeft(points[w], cut) ? [crossing(points, v, w, cut)] : [])];
  });
}

/** The rest of a segment after the cut; null for nothing. @type {(segment: Segment, cut: Cut) => Segment | null} */
export function partLeft([a, b], cut) {
  if (!cut) return [a, b];
  const here = isLeft(a, cut), there = isLeft(b, cut);
  if (here === there) return here ? [a, b] : null;
  return here ? [a, between(a, b, cut)] : [between(a, b, cut), b];
}

/** The segments in which the plane meets the surface. @param {Solid} body @param {Plane} cut */
function segmentsOf(body, cut) {
  /** @type {Segment[]} */
  const segments = [];
  for (const triangles of body.triangles) {
    for (const triangle of triangles) {
      const ends = triangle.flatMap((v, k) => {
        const w = triangle[(k + 1) % 3];
        return isLeft(body.points[v], cut) === isLeft(body.points[w], cut) ? [] : [crossing(body.points, v, w, cut)];
      });
      if (ends.length === 2) segments.push([ends[0], ends[1]]);
    }
  }
  return segments;
}

const MOST_TRAPEZOIDS = 200000;
/**
 * Trapezoids that fill what closed curves enclose: between two levels of `v` the segments in the order of `u`, in pairs.
 * @param {Segment[]} segments
 * @param {number} u
 * @param {number} v
 */
function filled(segments, u, v) {
  const rising = segments.map(/** @returns {Segment} */ ([a, b]) => (a[v] < b[v] ? [a, b] : [b, a])).filter(([a, b]) => a[v] < b[v]);
  rising.sort(([a], [b]) => a[v] - b[v]);
  const levels = [...new Set(rising.flatMap(([a, b]) => [a[v], b[v]]))].sort((a, b) => a - b);
  /** @param {Segment} segment @param {number} level */
  const along = ([a, b], level) => (level === b[v] ? b[u] : a[u] + ((level - a[v]) / (b[v] - a[v])) * (b[u] - a[u]));
  /** @type {[number, number, number[], number[]][]} */
  const found = [];
  /** @type {Segment[]} */
  let active = [];
  let next = 0;
  for (let k = 0; k + 1 < levels.length; ++k) {
    const low = levels[k], high = levels[k + 1];
    active = active.filter(([, b]) => b[v] > low);
    while (next < rising.length && rising[next][0][v] <= low) active.push(rising[next++]);
    const places = active.map((segment) => [along(segment, low), along(segment, high)]);
    places.sort((a, b) => a[0] + a[1] - b[0] - b[1]);
    for (let j = 0; j + 1 < places.length; j += 2) found.push([low, high, places[j], places[j + 1]]);
    if (found.length > MOST_TRAPEZOIDS) return [];
  }
  return found;
}

/** The section and its outline, as traces. @type {(body: Solid, cut: Cut, pixels: number) => import("./traces.js").Trace[]} */
export function section(body, cut, pixels) {
  if (!cut) return [];
  const [u, v] = [0, 1, 2].filter((axis) => axis !== cut.axis);
  const segments = segmentsOf(body, cut), mesh = newMesh();
  /** @param {number} along @param {number} level */
  const put = (along, level) => {
    const point = [0, 0, 0];
    [point[cut.axis], point[u], point[v]] = [cut.at, along, level];
    return point;
  };
  for (const [low, high, left, right] of filled(segments, u, v)) {
    addFan(mesh, [put(left[0], low), put(right[0], low), put(right[1], high), put(left[1], high)]);
  }
  const stand = cut.side * Math.max(0.5 / pixels, STAND_OFF);
  /** @param {Point} point */
  const raised = (point) => point.map((axis, n) => (n === cut.axis ? axis + stand : axis));
  return [
    { ...meshTrace("section", mesh), color: colour("section"), hoverinfo: "skip" },
    { type: "scatter3d", mode: "lines", name: "outline", hoverinfo: "skip",
      ...columns(segments.flatMap((ends) => [...ends.map(raised), null])), line: { color: colour("chosen"), width: 3 } },
  ];
}

/**
 * As the controls have it. The plane keeps off round numbers, where faces may lie.
 * @param {import("./data.js").Frame} frame
 * @param {Solid} body
 * @returns {Cut}
 */
export function wantedCut(frame, body) {
  const chosen = element("cut-axis", HTMLSelectElement).value, isOff = chosen === "", told = element("cut-at");
  input("cut").disabled = isOff;
  input("cut-flip").disabled = isOff;
  told.textContent = "";
  if (isOff) return null;
  const axis = Number(chosen), share = Number(input("cut").value) / 1000 - 0.5, centre = frame.centre[axis];
  const at = share * body.sides[axis] + 3.7e-7;
  if (frame.size !== null && centre !== null) {
    told.textContent = `at ${signed(String(Number((centre + frame.size * share * body.sides[axis]).toPrecision(6))))}`;
  }
  return { axis, at, side: isChecked("cut-flip") ? -1 : 1 };
}
