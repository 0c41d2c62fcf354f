// The parts of the outer Voronoi diagram: straight ones, and parabolas between a vertex and an edge.
function placeOf(node, half) {
  if (isEvent(node)) return data.places.slice(2 * node, 2 * node + 2);
  if (isInfinite(node)) return null;
  return data.features[node === half.from ? sides[half.fromSide].from : sides[half.toSide].to];
}

// Each part once: {from, to, bend}, `bend` where a parabola's tangents at its ends meet. Parts that go on
// to infinity end at the radius `far`, or beyond.
function skeletonParts(far) {
  const parts = [];
  halves.forEach((half, k) => {
    if (half.twin < k) return;
    const [low, high] = half.isRising ? [half.from, half.to] : [half.to, half.from];
    const radii = [low, high].map((node) => (isEvent(node) ? data.radii[radiusOf(node)] : 0));
    if (isInfinite(high)) radii[1] = Math.max(far, 2 * radii[0]);
    const from = placeOf(low, half), to = placeOf(high, half) ?? cornerAt(half, radii[1]);
    const [ax, ay, , bx, by, q0, q1, q2, cx, cy] = data.motions.slice(10 * half.motion, 10 * half.motion + 10);
    if (q2 || !(q1 > 0)) { parts.push({ from, to, bend: null }); return; }
    // At the height h of the vertex over the line, u to a side of it: radius = (u² + h²) / 2h.
    const h = q1 / 2, [u, v] = radii.map((radius) => Math.sqrt(Math.max(q0 + q1 * radius, 0)));
    const height = (u * v + h * h) / (2 * h), across = (u + v) / 2;
    parts.push({ from, to, bend: [ax + height * bx + across * cx, ay + height * by + across * cy] });
  });
  return parts;
}
