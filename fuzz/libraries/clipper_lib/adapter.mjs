// Clipper 1 in JavaScript (clipper-lib), in three ways: the argument is boundary, union or inflate.
//
// boundary: MinkowskiSum of two rings, their curves. union: one union of all rings. inflate:
// ClipperOffset with round joins, its arc tolerance a thousandth of the radius. Steps of an arc are
// rounded to the nearest number, so one step may stand for one and a half: 1.5^2 times as much.
//
// All run on a grid of 30 bits; the library's documented range is 52. A vertex is rounded by a
// unit, and another where an intersection moves into its scanbeam; with slivers left out, 4 units.
import clipper from "clipper-lib";
import { IntegerGrid, Skipped, largest, onlyRing, ringsOf, serve } from "./adapter_protocol.mjs";

const BITS = 30;

const toPath = (ring, grid) => ring.map(([x, y]) => ({ X: grid.to(x), Y: grid.to(y) }));
const toRings = (paths, grid) =>
  paths.map((path) => path.map((p) => [grid.from(p.X), grid.from(p.Y)]));

function sumOf(sP, Q) {
  const grid = new IntegerGrid(largest([sP]) + largest([Q]), BITS);
  const [p, q] = [sP, Q].map((set) => toPath(onlyRing(set), grid));
  return { rings: toRings(clipper.Clipper.MinkowskiSum(p, q, true), grid) };
}

function unionOf(sets) {
  const grid = new IntegerGrid(largest(sets), BITS);
  const one = new clipper.Clipper();
  if (sets.flatMap(ringsOf).length === 0) return { rings: [] };
  for (const ring of sets.flatMap(ringsOf)) {
    one.AddPath(toPath(ring, grid), clipper.PolyType.ptSubject, true);
  }
  const found = [];
  const rule = clipper.PolyFillType.pftNonZero;
  if (!one.Execute(clipper.ClipType.ctUnion, found, rule, rule)) throw new Error("Execute: false");
  return { rings: toRings(found, grid) };
}

const { JoinType, EndType } = clipper;
const JOINS = { round: JoinType.jtRound, mitre: JoinType.jtMiter, square: JoinType.jtSquare };
const ENDS = {
  round: EndType.etOpenRound, flat: EndType.etOpenButt, square: EndType.etOpenSquare,
};

function offsetOf(P, radius, { join = "round", cap = "round", limit = 2 }) {
  const rings = P.lines ?? ringsOf(P);
  if (!P.lines && rings.some((ring) => ring.length < 3)) throw new Skipped("no points or segments");
  const size = rings.flat(2).reduce((a, x) => Math.max(a, Math.abs(x)), 0);
  const grid = new IntegerGrid(size + Math.abs(radius), BITS);
  const delta = radius / grid.unit;
  const one = new clipper.ClipperOffset(limit, Math.abs(delta) / 1000);
  const end = P.lines ? ENDS[cap] : EndType.etClosedPolygon;
  for (const ring of rings) one.AddPath(toPath(ring, grid), JOINS[join], end);
  const found = [];
  one.Execute(found, delta);
  return { rings: toRings(found, grid) };
}

const HELLO = {
  version: "6.4.2",
  language: "JavaScript",
  arithmetic: "integer-grid",
  numbers: "double",
  grid: { bits: BITS - 2 },
  sum: "none",
};
const ALL = ["plane", "non-convex", "holes", "components", "touching", "empty"];
const INFLATE = [
  "offset", "inset", "line-offset", "join-mitre", "join-square", "cap-flat", "cap-square",
];
const MODES = {
  boundary: [
    { name: "clipper-lib", sum: "boundary", capabilities: ["plane", "non-convex"] },
    { sumOf },
  ],
  union: [{ name: "clipper-lib-union", capabilities: [...ALL, "union"] }, { unionOf }],
  inflate: [{ name: "clipper-lib-inflate", capabilities: [...ALL, ...INFLATE] }, { offsetOf }],
};

const mode = process.argv[2];
const tolerance = { absolute: "0", relative: "1/134217728" };
if (mode === "inflate") tolerance.radius = "0.0025";
serve({ ...HELLO, tolerance, ...MODES[mode][0] }, MODES[mode][1]);
