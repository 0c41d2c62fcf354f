// The sum at a scale as polygons in canonical order (docs/definitions.md, "Canonical form").
function compareRings(a, b) {
  const n = Math.min(a.length, b.length);
  for (let i = 0; i < n; ++i) {
    if (a[i][0] !== b[i][0]) return a[i][0] - b[i][0];
    if (a[i][1] !== b[i][1]) return a[i][1] - b[i][1];
  }
  return a.length - b.length;
}

// From the lexicographically smallest vertex on.
function canonicalRing(vertices, s) {
  const points = vertices.map((track) => [xOf(track, s), yOf(track, s)]);
  let least = 0;
  for (let i = 1; i < points.length; ++i) {
    const [x, y] = points[i], [u, v] = points[least];
    if (x < u || (x === u && y < v)) least = i;
  }
  return [...points.slice(least), ...points.slice(0, least)];
}

// [{outer: ring, holes: [ring, ...]}, ...], ring = [[x, y], ...]; s a number of the window.
function canonicalPolygons(s) {
  if (!(s >= windowFirst && s <= windowLast)) throw new RangeError(`the scale ${s} is outside of the window`);
  const polygons = new Map();  // by component
  for (const { isHole, component, vertices } of timeline.at(s).values()) {
    if (!polygons.has(component)) polygons.set(component, { outer: null, holes: [] });
    const polygon = polygons.get(component), ring = canonicalRing(vertices, s);
    if (isHole) polygon.holes.push(ring); else polygon.outer = ring;
  }
  const sorted = [...polygons.values()];
  for (const polygon of sorted) polygon.holes.sort(compareRings);
  return sorted.sort((a, b) => compareRings(a.outer, b.outer));
}
