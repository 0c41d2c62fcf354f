// @ts-check
// The robot at a place: free, touching or not, by distances in doubles from the sums.

/** @typedef {import("./scene.js").Copy} Copy */
/** @typedef {{ state: "free" | "touching" | "blocked", copies: Copy[] }} Situation `copies`: those that it touches or meets */

/**
 * @param {Copy[]} copies
 * @param {number} x
 * @param {number} y
 * @param {number} near up to this distance from a boundary the robot touches
 * @returns {Situation}
 */
export function situationAt(copies, x, y, near) {
  const touching = [], blocking = [];
  for (const copy of copies) {
    const { rings, box } = copy.outline, u = x - copy.x, v = y - copy.y;
    if (u < box.xmin - near || u > box.xmax + near || v < box.ymin - near || v > box.ymax + near) continue;
    const { inside, distance } = placeIn(rings, u, v);
    if (distance <= near || copy.passages.some((line) => distanceFrom(line, u, v) <= near)) touching.push(copy);
    else if (inside) blocking.push(copy);
  }
  if (blocking.length) return { state: "blocked", copies: blocking };
  return touching.length ? { state: "touching", copies: touching } : { state: "free", copies: [] };
}

/** Whether a point is inside of rings, by even and odd, and how far from them. @param {Iterable<ArrayLike<number>>} rings @param {number} x @param {number} y */
export function placeIn(rings, x, y) {
  let inside = false, square = Infinity;
  for (const ring of rings) {
    const n = ring.length;
    let ax = ring[n - 2] - x, ay = ring[n - 1] - y;
    for (let i = 0; i < n; i += 2) {
      const bx = ring[i] - x, by = ring[i + 1] - y, dx = bx - ax, dy = by - ay;
      if ((ay > 0) !== (by > 0) && (ax - (ay * dx) / dy > 0)) inside = !inside;
      square = Math.min(square, squareFrom(ax, ay, bx, by));
      ax = bx; ay = by;
    }
  }
  return { inside, distance: Math.sqrt(square) };
}

/** The square of the distance of an edge from the origin. @param {number} ax @param {number} ay @param {number} bx @param {number} by */
function squareFrom(ax, ay, bx, by) {
  const dx = bx - ax, dy = by - ay, length = dx * dx + dy * dy;
  const t = length ? Math.min(Math.max(-(ax * dx + ay * dy) / length, 0), 1) : 0, px = ax + t * dx, py = ay + t * dy;
  return px * px + py * py;
}

/** How far a point is from a line x, y, x, y, ..., or a single point. @param {number[]} line @param {number} x @param {number} y */
function distanceFrom(line, x, y) {
  let square = Infinity;
  for (let i = 0; i < Math.max(line.length - 2, 1); i += 2) {
    const [ax, ay, bx, by] = [0, 1, 2, 3].map((k) => line[(i + k) % line.length]);
    square = Math.min(square, squareFrom(ax - x, ay - y, bx - x, by - y));
  }
  return Math.sqrt(square);
}
