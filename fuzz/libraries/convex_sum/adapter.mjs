// convex-minkowski-sum: the vertices of the sum of two convex polytopes, found as those faces of the
// hull of both, one above the other, that have points of each.
//
// It answers a set of points, whose hull is the sum; the hull is made here, in doubles. A point is
// the sum of two doubles, and the hull drops none that is farther outside than a few roundings.
import msum from "convex-minkowski-sum";
import { onlyRing, serve } from "./adapter_protocol.mjs";

const turn = (a, b, c) => (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);

function half(points) {
  const chain = [];
  for (const x of points) {
    while (chain.length > 1 && turn(chain.at(-2), chain.at(-1), x) <= 0) chain.pop();
    chain.push(x);
  }
  return chain.slice(0, -1);
}

function sumOf(sP, Q) {
  const points = msum(onlyRing(sP), onlyRing(Q));
  points.sort((a, b) => a[0] - b[0] || a[1] - b[1]);
  const ring = [...half(points), ...half(points.reverse())];
  return { polygons: [{ outer: ring, holes: [] }] };
}

const HELLO = {
  name: "convex-minkowski-sum",
  version: "1.0.0",
  language: "JavaScript",
  arithmetic: "double",
  numbers: "double",
  sum: "region",
  tolerance: { absolute: "0", relative: "1/1000000000" },
  capabilities: ["plane"],
};
serve(HELLO, { sumOf });
