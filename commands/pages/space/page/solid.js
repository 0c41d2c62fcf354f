// The operands, and the sum of a frame, as they are drawn and as they are told.
const parse = (id) => JSON.parse(document.getElementById(id).textContent);
const operands = parse("operands"), frames = parse("data");
const kinds = ["fv", "vf", "ee", "facet+edge", "edge+facet", "facet+facet"];
const sorted = (numbers) => [...new Set(numbers)].sort((a, b) => a - b);

for (const body of Object.values(operands)) {
  body.exact = body.points.map((point) => point.map(fraction));
  body.numbers = new Map(body.faces.map((ring, number) => [sorted(ring).join(), number]));
}

// Unit normal of a ring, by Newell; any for a ring without area in doubles.
function normalOf(points, ring) {
  const sum = [0, 0, 0];
  for (let k = 0; k < ring.length; ++k) {
    const a = points[ring[k]], b = points[ring[(k + 1) % ring.length]];
    for (let i = 0; i < 3; ++i) {
      const j = (i + 1) % 3, l = (i + 2) % 3;
      sum[i] += (a[j] - b[j]) * (a[l] + b[l]);
    }
  }
  const length = Math.hypot(...sum);
  return length > 0 ? sum.map((axis) => axis / length) : [0, 0, 1];
}

// A body in the unit of its picture: { points, rings, kinds, normals, edges, outward, sides }. `outward` are the
// directions in which vertices stand off the surface; edges are [a, b, facet, facet].
function solid(points, rings, kindOf, sides) {
  const normals = rings.map((ring) => normalOf(points, ring));
  const outward = points.map(() => [0, 0, 0]);
  const open = new Map(), edges = [];
  rings.forEach((ring, facet) => {
    ring.forEach((a, k) => {
      for (let i = 0; i < 3; ++i) outward[a][i] += normals[facet][i];
      const b = ring[(k + 1) % ring.length];
      const key = Math.min(a, b) * points.length + Math.max(a, b);
      if (open.has(key)) edges.push([a, b, open.get(key), facet]);
      else open.set(key, facet);
    });
  });
  for (const direction of outward) {
    const length = Math.hypot(...direction) || 1;
    direction.forEach((axis, i) => { direction[i] = axis / length; });
  }
  return { points, rings, kinds: rings.map(kindOf), normals, edges, outward, sides };
}

// S P ("P") or Q ("Q"), in the unit in which the longest side of its box is 1. `share`: that side in the unit of the sum.
function operandSolid(frame, which) {
  const body = operands[which], sides = frame[which];
  const share = Math.max(...sides);
  const own = sides.map((side) => side / (share || 1));
  const points = body.near.map((point) => point.map((axis, i) => axis * own[i]));
  return { ...solid(points, body.faces, () => (which === "P" ? "fv" : "vf"), own), share };
}

// The sum, in the unit in which the longest side of its box is 1; `parents` of each facet: vertices of the faces of P and Q.
function sumSolid(frame) {
  const { pairs, rings } = frame, points = [];
  for (let v = 0; v < pairs.length; v += 2) {
    const p = operands.P.near[pairs[v]], q = operands.Q.near[pairs[v + 1]];
    points.push([0, 1, 2].map((i) => frame.P[i] * p[i] + frame.Q[i] * q[i]));
  }
  const parents = rings.map((ring) => ({
    P: sorted(ring.map((v) => pairs[2 * v])), Q: sorted(ring.map((v) => pairs[2 * v + 1])),
  }));
  const sides = [0, 1, 2].map((i) => frame.P[i] + frame.Q[i]);
  return { ...solid(points, rings, (_, facet) => kindOf(parents[facet]), sides), parents };
}

function kindOf({ P, Q }) {
  const names = ["", "vertex", "edge", "facet"];
  const kind = `${names[Math.min(P.length, 3)]}+${names[Math.min(Q.length, 3)]}`;
  return { "facet+vertex": "fv", "vertex+facet": "vf", "edge+edge": "ee" }[kind] ?? kind;
}

// Exact coordinates of a vertex of the sum.
function exactPoint(frame, vertex) {
  const p = operands.P.exact[frame.pairs[2 * vertex]], q = operands.Q.exact[frame.pairs[2 * vertex + 1]];
  return frame.scale.map((factor, i) => plus(times(fraction(factor), p[i]), q[i]));
}
