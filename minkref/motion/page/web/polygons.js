// The bad polygons: of each segment those that stand on it, corners as places t and scales s.
const polygons = data.polygons.map(([segment, part, obstacle, ...numbers]) => {
  const points = [];
  for (let i = 0; i < numbers.length; i += 2) points.push([numbers[i], numbers[i + 1]]);
  const scales = points.map(([, s]) => s);
  return { segment, part, obstacle, points, least: Math.min(...scales), greatest: Math.max(...scales) };
});
const onSegment = new Map();
for (const polygon of polygons) {
  if (!onSegment.has(polygon.segment)) onSegment.set(polygon.segment, []);
  onSegment.get(polygon.segment).push(polygon);
}

const isClosed = data.contact === "forbidden";
const isPointSegment = (segment) => {
  const [a, b] = [corners[segment], corners[segment + 1] ?? corners[segment]];
  return a[0] === b[0] && a[1] === b[1];
};

// Sides on the border of the strip belong to a polygon; with contact forbidden all of them do.
const isOnBorder = ([t0, s0], [t1, s1]) =>
  (t0 === t1 && (t0 === 0 || t0 === 1)) || (s0 === s1 && (s0 === windowFirst || s0 === windowLast));

function holdsPlace({ segment, points, least, greatest }, t, s) {
  if (s < least || s > greatest) return false;
  if (isPointSegment(segment)) return isClosed || (s > least || s === windowFirst) && (s < greatest || s === windowLast);
  if (points.length === 1) return points[0][0] === t;
  return points.every((from, i) => {
    const to = points[(i + 1) % points.length];
    if (points.length > 2 && isOnBorder(from, to)) return true;
    const side = (to[0] - from[0]) * (s - from[1]) - (to[1] - from[1]) * (t - from[0]);
    return side > 0 || (isClosed && side === 0);
  });
}

const collisionAt = (segment, t, s) => (onSegment.get(segment) ?? []).find((polygon) => holdsPlace(polygon, t, s)) ?? null;
