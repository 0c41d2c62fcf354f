// JSTS: BufferOp. npm install jsts
// node jsts_buffer.mjs "X" TRUTH SET DISTANCE: X is a point "x y", TRUTH what is right of it: in,
// out, or any where the call alone matters. The set is WKT.
import Coordinate from "jsts/org/locationtech/jts/geom/Coordinate.js";
import WKTReader from "jsts/org/locationtech/jts/io/WKTReader.js";
import WKTWriter from "jsts/org/locationtech/jts/io/WKTWriter.js";
import BufferOp from "jsts/org/locationtech/jts/operation/buffer/BufferOp.js";
import SimplePointInAreaLocator from "jsts/org/locationtech/jts/algorithm/locate/SimplePointInAreaLocator.js";
import { readFileSync } from "node:fs";

const [point, truth, set, distance] = process.argv.slice(2);
const grown = BufferOp.bufferOp(new WKTReader().read(set), Number(distance));
const x = new Coordinate(...point.split(" ").map(Number));
const found = SimplePointInAreaLocator.locate(x, grown) === 0 ? "in" : "out";
const from = import.meta.resolve("jsts/org/locationtech/jts/geom/Coordinate.js");
const text = readFileSync(new URL("../../../../package.json", from), "utf8");
console.log(`JSTS ${JSON.parse(text).version}: ${new WKTWriter().write(grown)}`);
console.log(`x = (${point}) in the buffer: ${found}, in truth: ${truth}`);
process.exitCode = truth === "any" || truth === found ? 0 : 1;
