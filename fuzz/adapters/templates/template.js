#!/usr/bin/env node
// An adapter for `minkref verify` in JavaScript without dependencies: sums of convex polygons.
// Put your own call into `minkowskiSum`, and say in `declaration` what it can do
// (docs/adapter-protocol.md has the words). Try it: minkref verify "cmd:node NAME_adapter.js"
"use strict";

const declaration = {
  protocol: "adapter-v1",
  name: "NAME",
  version: "1",
  language: "JavaScript",
  arithmetic: "float64",
  numbers: "double",
  tolerance: { absolute: "0", relative: "1e-9" },
  sum: "region",
  capabilities: ["plane"],
};

// PUT YOUR OWN CALL HERE. P and Q are arrays of polygons { outer, holes }; a ring is an array of
// [x, y], outer ones counter-clockwise, holes clockwise. The sum is an array of rings: the points
// that they wind around. To be asked for more, declare "non-convex", "holes" and "components".
function minkowskiSum(P, Q) {
  return [convexSum(P[0].outer, Q[0].outer)];
}

// P grown by a disc, likewise: here the sum with a polygon of 128 corners. To be asked for it,
// declare "offset", and in the tolerance radius: "0.0004".
function offset(P, radius) {
  const angles = Array.from({ length: 128 }, (_, k) => (Math.PI * k) / 64);
  return [convexSum(P[0].outer, angles.map((a) => [radius * Math.cos(a), radius * Math.sin(a)]))];
}

// The edges of both rings in the order of their directions, from the leftmost vertices.
function convexSum(P, Q) {
  const [p, q, ring] = [fromLeft(P), fromLeft(Q), []];
  for (let i = 0, j = 0; i < P.length || j < Q.length; ) {
    ring.push([p[i][0] + q[j][0], p[i][1] + q[j][1]]);
    let turn = j === Q.length ? 1 : -1;
    if (i < P.length && j < Q.length) {
      const [a, b] = [p[i + 1][0] - p[i][0], p[i + 1][1] - p[i][1]];
      turn = a * (q[j + 1][1] - q[j][1]) - b * (q[j + 1][0] - q[j][0]);
    }
    if (turn >= 0) i++;
    if (turn <= 0) j++;
  }
  return ring;
}

function fromLeft(ring) {
  const left = (p, q) => p[0] - q[0] || p[1] - q[1];
  const k = ring.indexOf([...ring].sort(left)[0]);
  return [...ring.slice(k), ...ring.slice(0, k + 1)];
}

let loaded = null;
function answer(request) {
  if (request.verb === "hello") return { status: "result", ...declaration };
  if (request.verb === "load") loaded = request.Q.polygons;
  if (["load", "stop"].includes(request.verb)) return { status: "result" };
  if (request.verb === "offset") {
    return { status: "result", rings: offset(request.P.polygons, request.radius) };
  }
  if (request.verb !== "at") return { status: "skipped", reason: "no such verb here" };
  return { status: "result", rings: minkowskiSum(request.sP.polygons, loaded) };
}

require("readline").createInterface({ input: process.stdin }).on("line", (line) => {
  let request = null;
  let value;
  try { value = answer((request = JSON.parse(line))); }
  catch (error) { value = { status: "errored", reason: String(error) }; }
  process.stdout.write(JSON.stringify({ seq: request?.seq ?? null, ...value }) + "\n");
  if (request?.verb === "stop") process.exit(0);
});
