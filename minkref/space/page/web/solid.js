// The operands, and the sum of a frame, as they are drawn and as they are told.
const parse = (id) => JSON.parse(document.getElementById(id).textContent);
const operands = parse("operands"), frames = parse("data");
const kinds = ["fv", "vf", "ee", "facet+edge", "edge+facet", "facet+facet", "several"];
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

const fan = (ring) => ring.slice(2).map((last, k) => [ring[0], ring[k + 1], last]);

// Those of two facets, and those of one.
function edgesOf(count, outlines) {
  const open = new Map(), edges = [];
  outlines.forEach((rings, facet) => rings.forEach((ring) => ring.forEach((a, k) => {
    const b = ring[(k + 1) % ring.length];
    const key = Math.min(a, b) * count + Math.max(a, b);
    if (open.has(key)) {
      edges.push([a, b, open.get(key), facet]);
      open.delete(key);
    } else {
      open.set(key, facet);
    }
  })));
  for (const [key, facet] of open) edges.push([Math.floor(key / count), key % count, facet, facet]);
  return edges;
}

// A body in the unit of its picture: { points, outlines, triangles, kinds, normals, edges, outward, sides }.
// `outlines`: the rings of each facet, the outer one first. `outward`: the directions in which vertices stand off the
// surface. Edges are [a, b, facet, facet].
function solid(points, outlines, triangles, kindOf, sides) {
  const normals = outlines.map(([ring]) => normalOf(points, ring));
  const outward = points.map(() => [0, 0, 0]);
  outlines.forEach((rings, facet) => rings.forEach((ring) => ring.forEach((a) => {
    for (let i = 0; i < 3; ++i) outward[a][i] += normals[facet][i];
  })));
  for (const direction of outward) {
    const length = Math.hypot(...direction) || 1;
    direction.forEach((axis, i) => { direction[i] = axis / length; });
  }
  const edges = edgesOf(points.length, outlines);
  return { points, outlines, triangles, kinds: outlines.map((_, facet) => kindOf(facet)), normals, edges, outward, sides };
}

// S P ("P") or Q ("Q"), in the unit in which the longest side of its box is 1. `share`: that side in the unit of the sum.
function operandSolid(frame, which) {
  const body = operands[which], sides = frame[which];
  const share = Math.max(...sides);
  const own = sides.map((side) => side / (share || 1));
  const points = body.near.map((point) => point.map((axis, i) => axis * own[i]));
  const triangles = body.triangles ?? body.faces.map(fan);
  return { ...solid(points, body.faces.map((ring) => [ring]), triangles, () => (which === "P" ? "fv" : "vf"), own), share };
}

// The sum, in the unit in which the longest side of its box is 1; `parents` of each facet: pairs of faces of P and Q, by their
// vertices.
function sumSolid(frame) {
  const sides = [0, 1, 2].map((i) => frame.P[i] + frame.Q[i]);
  if (!frame.pairs) {
    const parents = frame.parents.map((pairs) => pairs.map(([P, Q]) => ({ P: sorted(P), Q: sorted(Q) })));
    return { ...solid(frame.near, frame.outlines, frame.triangles, (facet) => kindOf(parents[facet]), sides), parents };
  }
  const { pairs, rings } = frame, points = [];
  for (let v = 0; v < pairs.length; v += 2) {
    const p = operands.P.near[pairs[v]], q = operands.Q.near[pairs[v + 1]];
    points.push([0, 1, 2].map((i) => frame.P[i] * p[i] + frame.Q[i] * q[i]));
  }
  const parents = rings.map((ring) => [{
    P: sorted(ring.map((v) => pairs[2 * v])), Q: sorted(ring.map((v) => pairs[2 * v + 1])),
  }]);
  return { ...solid(points, rings.map((ring) => [ring]), rings.map(fan), (facet) => kindOf(parents[facet]), sides), parents };
}

function kindOf(parents) {
  const names = ["", "vertex", "edge", "facet"];
  const found = new Set(parents.map(({ P, Q }) => `${names[Math.min(P.length, 3)]}+${names[Math.min(Q.length, 3)]}`));
  if (found.size > 1) return "several";
  const [kind] = found;
  return { "facet+vertex": "fv", "vertex+facet": "vf", "edge+edge": "ee" }[kind] ?? kind;
}

// Exact coordinates of a vertex of the sum.
function exactPoint(frame, vertex) {
  if (!frame.pairs) return frame.points[vertex].map(fraction);
  const p = operands.P.exact[frame.pairs[2 * vertex]], q = operands.Q.exact[frame.pairs[2 * vertex + 1]];
  return frame.scale.map((factor, i) => plus(times(fraction(factor), p[i]), q[i]));
}
