// @ts-check
// The boundary at any radius: its corners move along the parts of the diagram. As DiscIndex has it.
import { clamped } from "../../../page/web/numbers.js";
import { data, isEvent, isInfinite, pointOf } from "./data.js";

/** @typedef {import("./data.js").Point} Point */
/** @typedef {typeof halves[number]} Half a part of the diagram, from one side */
/** @typedef {typeof walks[number]} Walk */
/** @typedef {{ half: Half, walk: number, side: number, count: number }} Corner with the sides of the walk from that one on */
/** @typedef {{ walk: number, corners: Corner[] }} Ring with no corners it is all of its walk */
/** @typedef {{ centre: Point | null, from: Point, to: Point }} Piece of a ring: an arc, or straight */

export const halves = data.halves.map(([from, to, twin, fromSide, toSide]) => ({
  from, to, twin, fromSide, toSide,
  low: Math.min(data.numbers[from], data.numbers[to]),
  high: Math.max(data.numbers[from], data.numbers[to]),
  isRising: data.numbers[from] < data.numbers[to],
  motion: 0, walk: 0, start: 0, end: 0,  // below
}));
let motionCount = 0;
halves.forEach((half, k) => { half.motion = half.twin < k ? halves[half.twin].motion : motionCount++; });

// How far each half goes along the sides of its walk.
export const walks = data.walks.map(([firstSide, endSide, first, end], walk) => {
  const total = endSide - firstSide;
  /** @param {number} from @param {number} to */
  const onwards = (from, to) => (to >= from ? to - from : to + total - from);
  let passed = 0;
  for (let k = first; k < end; ++k) {
    const half = halves[k], before = halves[k === first ? end - 1 : k - 1];
    half.walk = walk;
    half.start = passed + onwards(before.toSide, half.fromSide);
    half.end = passed = half.start + onwards(half.fromSide, half.toSide);
  }
  return { firstSide, endSide, first, end, total };
});

// Sides, with the joint at the end of each: the vertex, and the line in front of whose end it is.
export const sides = data.sides.map(([feature, from, to, isArc]) => ({
  feature, from, to, isArc: !!isArc, joint: /** @type {Point | null} */ (null),
}));
for (const { firstSide, endSide } of walks) {
  for (let k = firstSide; k < endSide; ++k) {
    const side = sides[k], next = sides[k + 1 === endSide ? firstSide : k + 1];
    if (!data.sides[k][4] && side.isArc !== next.isArc) side.joint = [side.to, side.isArc ? next.feature : side.feature];
  }
}

/** @type {(joint: Point, radius: number) => Point} */
function jointAt([vertex, line], radius) {
  const [x, y] = data.features[vertex], [nx, ny] = data.features[line];
  return [x + radius * nx, y + radius * ny];
}

/**
 * a + w b + √(w (k0 + k1 w)) c with w = radius - r, where r is the sum of two numbers. A radius of an event
 * is rounded: what moves straight stays between its ends, however fast it is.
 * @type {(half: Half, radius: number) => Point}
 */
export function cornerAt(half, radius) {
  const [ax, ay, r, rest, bx, by, k0, k1, cx, cy] = motionOf(half);
  const way = radius - r - rest, root = Math.sqrt(Math.max(way * (k0 + k1 * way), 0));
  const x = ax + way * bx + root * cx, y = ay + way * by + root * cy;
  const [p, q] = k0 || k1 ? [null] : [placeOf(half.from, half), placeOf(half.to, half)];
  return p && q ? [between(x, p[0], q[0]), between(y, p[1], q[1])] : [x, y];
}

/** @type {(number: number, a: number, b: number) => number} */
const between = (number, a, b) => clamped(number, Math.min(a, b), Math.max(a, b));

/** Where a node at an end of a half is; null at infinity. @type {(node: number, half: Half) => Point | null} */
export function placeOf(node, half) {
  if (isEvent(node)) return pointOf(node);
  if (isInfinite(node)) return null;
  const [x, y] = data.features[node === half.from ? sides[half.fromSide].from : sides[half.toSide].to];
  return [x, y];
}

/** @param {Half} half */
export const motionOf = (half) => data.motions.slice(10 * half.motion, 10 * half.motion + 10);

/** The rings between the radius number `gap` and the next. @param {number} gap */
export function ringsOf(gap) {
  /** @type {Ring[]} */
  const rings = [];
  /** @type {[number[], number[]]} */
  const [there, bounds] = [[], []];
  const place = new Int32Array(halves.length);
  walks.forEach(({ first, end }) => {
    bounds.push(there.length);
    for (let k = first; k < end; ++k) {
      place[k] = there.length;
      if (halves[k].low <= gap && gap < halves[k].high) there.push(k);
    }
  });
  bounds.push(there.length);
  const isDone = new Uint8Array(there.length);
  there.forEach((first, start) => {
    if (isDone[start] || !halves[first].isRising) return;
    /** @type {Corner[]} */
    const corners = [];
    for (let entry = start; !isDone[entry];) {
      isDone[entry] = 1;
      const half = halves[there[entry]], walk = half.walk;
      const exit = entry + 1 === bounds[walk + 1] ? bounds[walk] : entry + 1, last = halves[there[exit]];
      const around = exit <= entry ? walks[walk].total : 0;
      corners.push({ half, walk, side: half.toSide, count: last.start + 1 - half.end + around });
      entry = place[last.twin];
    }
    rings.push({ walk: corners[0].walk, corners });
  });
  walks.forEach(({ first, end }, walk) => {
    if (bounds[walk] !== bounds[walk + 1] || (first !== end && halves[first].low <= gap)) return;
    rings.push({ walk, corners: [] });
  });
  return rings;
}

/** Pieces of a ring at a radius, the sum on the left. @param {Ring} ring @param {number} radius */
export function piecesOf(ring, radius) {
  /** @type {Piece[]} */
  const pieces = [];
  if (data.point) {
    const [x, y] = data.point;
    /** @type {[Point, Point]} */
    const [right, left] = [[x + radius, y], [x - radius, y]];
    return [{ centre: data.point, from: right, to: left }, { centre: data.point, from: left, to: right }];
  }
  /** @type {(from: Point, side: number, count: number, walk: Walk, to: Point | null) => void} */
  const follow = (from, side, count, walk, to) => {
    for (let n = 1; n < count; ++n) {
      const passed = sides[side].joint;
      if (passed) {
        const joint = jointAt(passed, radius);
        pieces.push({ centre: centreOf(side), from, to: joint });
        from = joint;
      }
      side = side + 1 === walk.endSide ? walk.firstSide : side + 1;
    }
    if (to) pieces.push({ centre: centreOf(side), from, to });
  };
  if (!ring.corners.length) {
    const walk = walks[ring.walk];
    let side = walk.firstSide, joint = sides[side].joint;
    while (!joint) joint = sides[++side].joint;
    const start = jointAt(joint, radius);
    follow(start, side + 1 === walk.endSide ? walk.firstSide : side + 1, walk.total + 1, walk, null);
    return pieces;
  }
  const places = ring.corners.map(({ half }) => cornerAt(half, radius));
  ring.corners.forEach(({ side, count, walk }, i) => {
    follow(places[i], side, count, walks[walk], places[(i + 1) % places.length]);
  });
  return pieces;
}

/** @param {number} side @returns {Point | null} */
function centreOf(side) {
  const { isArc, from } = sides[side], [x, y] = data.features[from];
  return isArc ? [x, y] : null;
}

/**
 * From one angle to the other, counter-clockwise. No arc is longer than half a turn, so what seems to be
 * is none, rounded.
 * @type {(centre: Point, from: Point, to: Point) => { start: number, turn: number }}
 */
export function turnOf([x, y], from, to) {
  const start = Math.atan2(from[1] - y, from[0] - x);
  let turn = Math.atan2(to[1] - y, to[0] - x) - start;
  if (turn < 0) turn += 2 * Math.PI;
  return { start, turn: turn > 1.5 * Math.PI ? 0 : turn };
}
