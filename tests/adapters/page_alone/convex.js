// Sums of convex polygons, points and segments in exact fractions of big integers. Written from
// docs/adapter-protocol.md alone. Ends at the end of its input and answers nothing to `stop`.
"use strict";

const declaration = {
  protocol: "adapter-v1", name: "convex.js", version: "1", language: "JavaScript",
  arithmetic: "exact", numbers: "text", sum: "region",
  capabilities: ["plane", "rational", "point", "segment", "empty"],
};

function fraction(value) {
  const [n, d] = String(value).split("/");
  return [BigInt(n), BigInt(d ?? 1)];
}
const plus = ([a, b], [c, d]) => [a * d + c * b, b * d];
const minus = ([a, b], [c, d]) => [a * d - c * b, b * d];
const times = ([a, b], [c, d]) => [a * c, b * d];
const sign = ([a]) => (a > 0n) - (a < 0n);
const compare = (p, q) => sign(minus(p[0], q[0])) || sign(minus(p[1], q[1]));
const turn = (a, b, c) => sign(minus(
  times(minus(b[0], a[0]), minus(c[1], a[1])), times(minus(b[1], a[1]), minus(c[0], a[0]))));

// The hull of the sums of vertices: two chains, left to right and back.
function hull(points) {
  points.sort(compare);
  const chain = (ordered) => {
    const found = [];
    for (const point of ordered) {
      while (found.length > 1 && turn(found.at(-2), found.at(-1), point) <= 0) found.pop();
      found.push(point);
    }
    return found.slice(0, -1);
  };
  return [...chain(points), ...chain([...points].reverse())];
}

const vertices = (set) =>
  set.polygons.flatMap(({ outer }) => outer.map(([x, y]) => [fraction(x), fraction(y)]));

let Q = [];
function answer(request) {
  if (request.verb === "hello") return declaration;
  if (request.verb === "load") { Q = vertices(request.Q); return {}; }
  const sums = vertices(request.sP).flatMap((p) => Q.map((q) => [plus(p[0], q[0]), plus(p[1], q[1])]));
  const ring = hull(sums);
  const text = ([n, d]) => `${n}/${d}`;
  if (ring.length < 3) return { rings: [] };
  return { rings: [ring.map(([x, y]) => [text(x), text(y)])] };
}

require("readline").createInterface({ input: process.stdin }).on("line", (line) => {
  const request = JSON.parse(line);
  if (request.verb === "stop") return;
  process.stdout.write(JSON.stringify({ ...answer(request), status: "result", seq: request.seq }) + "\n");
});
