// JSTS, a translation of JTS to JavaScript: the argument is union or buffer. It has no sums.
//
// union: OverlayOp.union of one set after the other, snapped if needed (SnapIfNeededOverlayOp):
// vertices and edges closer than 1e-9 of the smaller extent are joined. buffer: round joins and
// caps, 16 segments for a quarter of a circle; tolerances as in geos/adapter.py, since the
// algorithm is that of JTS. Its README expects a TopologyException in a few cases: these are
// "errored" here, no wrong answers.
import Coordinate from "jsts/org/locationtech/jts/geom/Coordinate.js";
import GeometryFactory from "jsts/org/locationtech/jts/geom/GeometryFactory.js";
import BufferOp from "jsts/org/locationtech/jts/operation/buffer/BufferOp.js";
import BufferParameters from "jsts/org/locationtech/jts/operation/buffer/BufferParameters.js";
import SnapIfNeededOverlayOp from "jsts/org/locationtech/jts/operation/overlay/snap/SnapIfNeededOverlayOp.js";
import { Skipped, serve } from "./adapter_protocol.mjs";

const QUARTER = 16;
const factory = new GeometryFactory();

const toLine = (ring) => ring.map(([x, y]) => new Coordinate(x, y));
const toRing = (ring) => factory.createLinearRing(toLine([...ring, ring[0]]));

function toGeometry({ polygons }) {
  if (polygons.some((polygon) => polygon.outer.length < 3)) throw new Skipped("no points, segments");
  const parts = polygons.map((p) => factory.createPolygon(toRing(p.outer), p.holes.map(toRing)));
  return parts.length === 1 ? parts[0] : factory.createMultiPolygon(parts);
}

function toShape(set) {
  const ring = set.polygons[0]?.outer;
  if (ring?.length === 1) return factory.createPoint(toLine(ring)[0]);
  if (ring?.length === 2) return factory.createLineString(toLine(ring));
  return toGeometry(set);
}

function fromRing(ring) {
  const points = ring.getCoordinates().slice(0, -1);
  return points.map((p) => [p.x, p.y]);
}

function polygonsOf(geometry) {
  const found = [];
  for (let i = 0; i < geometry.getNumGeometries(); i++) {
    const part = geometry.getGeometryN(i);
    if (part.isEmpty() || part.getGeometryType() !== "Polygon") continue;
    const holes = Array.from({ length: part.getNumInteriorRing() }, (_, k) =>
      fromRing(part.getInteriorRingN(k)),
    );
    found.push({ outer: fromRing(part.getExteriorRing()), holes });
  }
  return found;
}

function unionOf(sets) {
  const [first, ...rest] = sets.map(toGeometry);
  return { polygons: polygonsOf(rest.reduce((a, b) => SnapIfNeededOverlayOp.union(a, b), first)) };
}

function toLines(lines) {
  const parts = lines.map((line) =>
    line.length === 1
      ? factory.createPoint(toLine(line)[0])
      : factory.createLineString(toLine(line)),
  );
  return parts.length === 1 ? parts[0] : factory.createGeometryCollection(parts);
}

const CAPS = {
  round: BufferParameters.CAP_ROUND,
  flat: BufferParameters.CAP_FLAT,
  square: BufferParameters.CAP_SQUARE,
};
const JOINS = {
  round: BufferParameters.JOIN_ROUND,
  mitre: BufferParameters.JOIN_MITRE,
  bevel: BufferParameters.JOIN_BEVEL,
};

function offsetOf(P, radius, { join = "round", cap = "round", limit = 5 }) {
  const how = new BufferParameters(QUARTER, CAPS[cap], JOINS[join], limit);
  const given = P.lines ? toLines(P.lines) : toShape(P);
  return { polygons: polygonsOf(BufferOp.bufferOp(given, radius, how)) };
}

const HELLO = {
  version: "2.12.1",
  language: "JavaScript",
  arithmetic: "float64",
  numbers: "double",
  sum: "none",
};
const ALL = ["plane", "non-convex", "holes", "components", "touching", "empty"];
const BUFFER = [
  "offset", "inset", "line-offset", "join-mitre", "join-bevel", "cap-flat", "cap-square",
];
const MODES = {
  union: [
    { name: "jsts", tolerance: { relative: "1e-7" }, capabilities: [...ALL, "union"] },
    { unionOf },
  ],
  buffer: [
    {
      name: "jsts-buffer",
      tolerance: { relative: "1e-7", radius: "0.0125" },
      capabilities: [...ALL, "point", "segment", ...BUFFER],
    },
    { offsetOf },
  ],
};

const mode = process.argv[2];
serve({ ...HELLO, ...MODES[mode][0] }, MODES[mode][1]);
