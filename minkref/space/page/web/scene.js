// @ts-check
// A picture in space, drawn by plotly.js: facets by kind, edges, vertices, and what is chosen.
import { colour } from "../../../page/web/colours.js";
import { clamped, roundStep } from "../../../page/web/numbers.js";
import { isLeft, leftOf, partLeft } from "./cut.js";
import { signed } from "./texts.js";
import { addFan, columns, meshTrace, newMesh, STAND_OFF } from "./traces.js";

/** @typedef {import("./data.js").Point} Point */
/** @typedef {import("./solid.js").Solid} Solid */
/** @typedef {import("./cut.js").Cut} Cut */
/** @typedef {import("./traces.js").Trace} Trace */
/** @typedef {{ x: number, y: number, z: number }} Direction */
/** @typedef {{ eye: Direction, up: Direction, center: Direction }} Camera */

/** @param {string} kind */
export const colourOf = (kind) => colour(kind.replace("+", "-"));
/** @param {string} hex */
const channels = (hex) => [1, 3, 5].map((at) => parseInt(hex.slice(at, at + 2), 16));
const light = [0.75, -0.35, 1].map((axis, _, direction) => axis / Math.hypot(...direction));
/** @type {Camera} */
export const home = { eye: { x: 1.3, y: -1.25, z: 0.85 }, up: { x: 0, y: 0, z: 1 }, center: { x: 0, y: 0, z: 0 } };
/** @type {Record<string, Direction>} */
export const views = {
  home: home.eye, x: { x: 2.05, y: 0, z: 0 }, y: { x: 0, y: -2.05, z: 0 }, z: { x: 0, y: 0, z: 2.05 },
};

/** @param {string} hex @param {Point} normal */
function shaded(hex, normal) {
  const towards = normal.reduce((sum, axis, i) => sum + axis * light[i], 0);
  const strength = 0.79 + 0.21 * towards;
  return `rgb(${channels(hex).map((channel) => Math.round(channel * strength)).join()})`;
}

/** @type {(body: Solid, vertex: number, direction: Point, distance?: number) => Point} */
const off = (body, vertex, direction, distance = STAND_OFF) =>
  body.points[vertex].map((axis, i) => axis + distance * direction[i]);

/**
 * Facets of one kind, as far as the cut leaves them, the vertices of each triangle its own: a point of the mesh tells the facet.
 * @type {(body: Solid, kind: string, visible: boolean, cut: Cut) => Trace}
 */
export function facets(body, kind, visible, cut) {
  const mesh = newMesh();
  /** @type {number[]} */
  const numbers = [];
  /** @type {string[]} */
  const facecolor = [];
  const tint = colourOf(kind);
  body.triangles.forEach((triangles, facet) => {
    if (body.kinds[facet] !== kind) return;
    const shade = shaded(tint, body.normals[facet]);
    for (const triangle of triangles) {
      const kept = leftOf(body.points, triangle, cut);
      addFan(mesh, kept);
      numbers.push(...kept.map(() => facet));
      facecolor.push(...kept.slice(2).map(() => shade));
    }
  });
  return { ...meshTrace(kind, mesh), facecolor, visible, hoverinfo: "none", meta: { what: "facet", numbers } };
}

/** How long, in the unit of plotly.js, a side of 2 is drawn. @param {number[]} halves @param {number} share */
export const drawnLength = (halves, share) => (1.62 * share) / Math.hypot(...halves);
export const SEEN_HEIGHT = 1.66;  // from top to bottom

/** Pixels between edges, roughly. `pixels`: of the longest side of the body. @param {Solid} body @param {number} pixels */
function roominess(body, pixels) {
  const [, middle, long] = [...body.sides].sort((a, b) => a - b);
  return (pixels * Math.sqrt(middle * long)) / Math.sqrt(body.edges.length);
}

/**
 * They stand off a third of their width, so that a slanting facet does not cut them in two.
 * @type {(body: Solid, pixels: number, visible: boolean, cut: Cut) => Trace}
 */
export function edgeLines(body, pixels, visible, cut) {
  /** @type {(Point | null)[]} */
  const points = [];
  const width = clamped(roominess(body, pixels) / 9, 0.35, 3);
  const distance = Math.max((0.2 * width) / pixels, STAND_OFF / 1.2);
  for (const [a, b, one, other] of body.edges) {
    const direction = body.normals[one].map((axis, i) => axis + body.normals[other][i]);
    const length = Math.hypot(...direction) || 1;
    const unit = direction.map((axis) => axis / length);
    const ends = partLeft([off(body, a, unit, distance), off(body, b, unit, distance)], cut);
    if (ends) points.push(...ends, null);
  }
  return {
    type: "scatter3d", mode: "lines", name: "edges", ...columns(points), visible, hoverinfo: "skip",
    line: { color: colour("edge"), width },
  };
}

/** @type {(body: Solid, pixels: number, visible: boolean, cut: Cut) => Trace} */
export function vertexMarks(body, pixels, visible, cut) {
  const numbers = body.points.map((_, v) => v).filter((v) => isLeft(body.points[v], cut));
  const size = clamped(roominess(body, pixels) / 4.5, 0.5, 5);
  return {
    type: "scatter3d", mode: "markers", name: "vertices", ...columns(numbers.map((v) => off(body, v, body.outward[v]))),
    visible, hoverinfo: "none", marker: { size, color: colour("vertex"), opacity: 1, line: { width: 0 } },
    meta: { what: "vertex", numbers },
  };
}

/** `marks`: lists of the vertices of a vertex, an edge or a ring. @type {(body: Solid, pixels: number, marks: number[][]) => Trace} */
export function chosenMark(body, pixels, marks) {
  const distance = Math.max(3 * STAND_OFF, 0.9 / pixels);
  const closed = marks.flatMap((ring) => [...ring, ...(ring.length > 2 ? [ring[0]] : []), null]).slice(0, -1);
  return {
    type: "scatter3d", mode: "lines+markers", name: "chosen", hoverinfo: "skip", visible: closed.length > 0,
    ...columns(closed.map((v) => (v === null ? null : off(body, v, body.outward[v], distance)))),
    line: { color: colour("chosen"), width: pixels < 40 ? 3 : 6 }, marker: { size: pixels < 40 ? 3 : closed.length === 1 ? 8 : 4, color: colour("chosen") },
  };
}

/** @param {number} value */
function tickText(value) {
  const size = Math.abs(value);
  if (size && (size >= 1e7 || size < 1e-4)) return value.toExponential(6).replace(/\.?0*e\+?/, "e");
  return Number(value.toPrecision(10)).toLocaleString("en", { maximumFractionDigits: 10 });
}

/**
 * Round numbers of an axis on which the picture shows `centre + size * u` for u within `half`.
 * @type {(centre: number | null, size: number | null, half: number) => { tickvals: number[], ticktext: string[] }}
 */
function ticks(centre, size, half) {
  if (centre === null || size === null || !(size > 1e-9 * Math.abs(centre))) return { tickvals: [], ticktext: [] };
  const step = roundStep(2 * half * size, 3, 5), values = [];
  for (let n = Math.ceil((centre - half * size) / step); n * step <= centre + half * size; ++n) values.push(n * step);
  return {
    tickvals: values.map((value) => (value - centre) / size),
    ticktext: values.map((value) => signed(tickText(value))),
  };
}

/**
 * @param {number[]} halves half the sides of the box that is shown
 * @param {import("./data.js").Frame | null} frame gives the axes their numbers, null for no axes
 * @param {Camera} camera
 * @param {number} share of the height that a picture may fill
 */
export function layout(halves, frame, camera, share) {
  const font = { family: getComputedStyle(document.body).fontFamily, size: 11, color: colour("soft") };
  /** @param {number} i */
  const axis = (i) => ({
    visible: frame !== null, range: [-halves[i], halves[i]], title: { text: "xyz"[i] }, showbackground: false, showspikes: false,
    zeroline: false, gridcolor: colour("rule"), linecolor: colour("rule"), tickfont: font,
    ...(frame ? ticks(frame.centre[i], frame.size, halves[i]) : {}), tickmode: "array",
  });
  const [x, y, z] = halves.map((half) => half * drawnLength(halves, share));
  return {
    paper_bgcolor: "rgba(0,0,0,0)", margin: { l: 0, r: 0, t: 0, b: 0 }, showlegend: false, hovermode: "closest", font,
    autosize: true,
    scene: {
      camera, aspectmode: "manual", aspectratio: { x, y, z }, dragmode: "orbit", bgcolor: "rgba(0,0,0,0)",
      xaxis: axis(0), yaxis: axis(1), zaxis: axis(2),
    },
  };
}

export const config = {
  displaylogo: false, responsive: true, displayModeBar: false, doubleClick: false, plotGlPixelRatio: Math.max(2, devicePixelRatio),
};
