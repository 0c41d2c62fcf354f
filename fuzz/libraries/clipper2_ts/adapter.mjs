// Clipper2 in TypeScript (clipper2-ts), in three ways: the argument is boundary, union or inflate.
//
// boundary: minkowskiSum of two rings, their curves. union: one union of all rings. inflate:
// inflatePaths with round joins, its arc tolerance a thousandth of the radius.
//
// All run on a grid of 30 bits, with the tolerance of clipper2/adapter.cpp: 4 units.
import { Clipper, EndType, FillRule, JoinType } from "clipper2-ts";
import { IntegerGrid, largest, onlyRing, ringsOf, serve } from "./adapter_protocol.mjs";

const BITS = 30;

const toPath = (ring, grid) => ring.map(([x, y]) => ({ x: grid.to(x), y: grid.to(y) }));
const toRings = (paths, grid) =>
  paths.map((path) => path.map((p) => [grid.from(p.x), grid.from(p.y)]));

function sumOf(sP, Q) {
  const grid = new IntegerGrid(largest([sP]) + largest([Q]), BITS);
  const [p, q] = [sP, Q].map((set) => toPath(onlyRing(set), grid));
  return { rings: toRings(Clipper.minkowskiSum(p, q, true), grid) };
}

function unionOf(sets) {
  const grid = new IntegerGrid(largest(sets), BITS);
  const paths = sets.flatMap(ringsOf).map((ring) => toPath(ring, grid));
  return { rings: toRings(Clipper.union(paths, FillRule.NonZero), grid) };
}

const JOINS = {
  round: JoinType.Round, mitre: JoinType.Miter, bevel: JoinType.Bevel, square: JoinType.Square,
};
const ENDS = { round: EndType.Round, flat: EndType.Butt, square: EndType.Square };

function offsetOf(P, radius, { join = "round", cap = "round", limit = 2 }) {
  const rings = P.lines ?? ringsOf(P);
  const size = rings.flat(2).reduce((a, x) => Math.max(a, Math.abs(x)), 0);
  const grid = new IntegerGrid(size + Math.abs(radius), BITS);
  const delta = radius / grid.unit;
  const paths = rings.map((ring) => toPath(ring, grid));
  const end = P.lines ? ENDS[cap] : EndType.Polygon;
  const found = Clipper.inflatePaths(
    paths, delta, JOINS[join], end, limit, Math.abs(delta) / 1000,
  );
  return { rings: toRings(found, grid) };
}

const HELLO = {
  version: "2.0.1",
  language: "JavaScript",
  arithmetic: "integer-grid",
  numbers: "double",
  grid: { bits: BITS - 2 },
  sum: "none",
};
const ALL = ["plane", "non-convex", "holes", "components", "touching", "empty"];
const INFLATE = [
  "offset", "inset", "line-offset", "join-mitre", "join-bevel", "join-square", "cap-flat",
  "cap-square",
];
const MODES = {
  boundary: [
    { name: "clipper2-ts", sum: "boundary", capabilities: ["plane", "non-convex"] },
    { sumOf },
  ],
  union: [{ name: "clipper2-ts-union", capabilities: [...ALL, "union"] }, { unionOf }],
  inflate: [
    { name: "clipper2-ts-inflate", capabilities: [...ALL, "point", "segment", ...INFLATE] },
    { offsetOf },
  ],
};

const mode = process.argv[2];
const tolerance = { absolute: "0", relative: "1/134217728" };
if (mode === "inflate") tolerance.radius = "0.001";
serve({ ...HELLO, tolerance, ...MODES[mode][0] }, MODES[mode][1]);
