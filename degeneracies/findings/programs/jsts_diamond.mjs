// JSTS: buffer of a frame whose hole, a square on its tip, is narrower than the distance.
// npm install jsts && node jsts_diamond.mjs
import Coordinate from "jsts/org/locationtech/jts/geom/Coordinate.js";
import GeometryFactory from "jsts/org/locationtech/jts/geom/GeometryFactory.js";
import BufferOp from "jsts/org/locationtech/jts/operation/buffer/BufferOp.js";
import SimplePointInAreaLocator from "jsts/org/locationtech/jts/algorithm/locate/SimplePointInAreaLocator.js";
import { readFileSync } from "node:fs";

const factory = new GeometryFactory();
const ring = (points) =>
  factory.createLinearRing([...points, points[0]].map(([x, y]) => new Coordinate(x, y)));
const outer = [[-9, -9], [9, -9], [9, 9], [-9, 9]];
const hole = [[0, 3], [3, 0], [0, -3], [-3, 0]];
const distance = 2.5; // the middle of the hole, (0, 0), is 3 / sqrt(2) = 2.121 from its sides

const grown = BufferOp.bufferOp(factory.createPolygon(ring(outer), [ring(hole)]), distance);
const inside = SimplePointInAreaLocator.locate(new Coordinate(0, 0), grown) === 0;
const from = import.meta.resolve("jsts/org/locationtech/jts/geom/Coordinate.js");
const text = readFileSync(new URL("../../../../package.json", from), "utf8");
console.log(`JSTS ${JSON.parse(text).version}: ${grown.getNumInteriorRing()} holes`);
console.log(`x = (0, 0) in the buffer: ${inside ? "in" : "out"}, in truth: in`);
process.exitCode = inside ? 0 : 1;
