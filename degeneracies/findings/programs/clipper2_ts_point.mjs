// clipper2-ts: inflatePaths of a single point with round joins, which Clipper2 grows to a disc.
// npm install clipper2-ts && node clipper2_ts_point.mjs
import { Clipper, EndType, JoinType } from "clipper2-ts";
import { readFileSync } from "node:fs";

const main = import.meta.resolve("clipper2-ts");
const { version } = JSON.parse(readFileSync(new URL("../package.json", main), "utf8"));
const point = [{ x: 5, y: 5 }];
const radius = 100;
console.log(`clipper2-ts ${version}`);
try {
  const grown = Clipper.inflatePaths([point], radius, JoinType.Round, EndType.Polygon);
  const area = Math.abs(Clipper.areaPaths(grown));
  console.log(`area ${area}, it should be about ${Math.PI * radius * radius}`);
  process.exitCode = Math.abs(area / (Math.PI * radius * radius) - 1) < 0.01 ? 0 : 1;
} catch (error) {
  console.log(`it throws ${error}`);
  process.exitCode = 1;
}
