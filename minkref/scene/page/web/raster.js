// @ts-check
// Copies on a grid of cells. For each cell: how many sums meet the closed cell, and how many have it in their interior.

const HAIR = 1e-6;  // of a cell: contact with a cell's side counts
/** @typedef {{ touched: number[], inner: number[] }} Spans first cell and length, one after another */
/** @typedef {{ x: number, y: number, unit: number }} Frame cell (0, 0) begins at (x, y), y downwards; `unit`: cells for a length of 1 */

/**
 * The cells that rings meet, and the cells inside of them, by even and odd.
 * @param {Float64Array[]} rings x, y, x, y, ...
 * @param {number[][]} lines points x, y and lines x, y, x, y, ... that are in no interior
 * @param {Frame} frame
 * @param {number} columns
 * @param {number} rows
 * @returns {Spans}
 */
export function spansOf(rings, lines, frame, columns, rows) {
  /** @type {Map<number, Row>} */
  const found = new Map();
  for (const ring of rings) {
    const n = ring.length;
    let x0 = (ring[n - 2] - frame.x) * frame.unit, y0 = (frame.y - ring[n - 1]) * frame.unit;
    for (let i = 0; i < n; i += 2) {
      const x1 = (ring[i] - frame.x) * frame.unit, y1 = (frame.y - ring[i + 1]) * frame.unit;
      addEdge(found, x0, y0, x1, y1, rows, true);
      x0 = x1; y0 = y1;
    }
  }
  for (const line of lines) {
    for (let i = 0; i < Math.max(line.length - 2, 1); i += 2) {
      const [x0, y0, x1, y1] = [0, 1, 2, 3].map((k) => line[(i + k) % line.length]);
      addEdge(found, (x0 - frame.x) * frame.unit, (frame.y - y0) * frame.unit, (x1 - frame.x) * frame.unit, (frame.y - y1) * frame.unit, rows, false);
    }
  }
  /** @type {Spans} */
  const spans = { touched: [], inner: [] };
  for (const [row, { met, crossings }] of found) addRow(spans, row * columns, columns, met, crossings);
  return spans;
}

/** @typedef {{ met: number[], crossings: number[] }} Row cells that edges meet, from and to; where edges cross its middle */

/** @type {(found: Map<number, Row>, x0: number, y0: number, x1: number, y1: number, rows: number, isBoundary: boolean) => void} */
function addEdge(found, x0, y0, x1, y1, rows, isBoundary) {
  if (y0 > y1) { [x0, x1] = [x1, x0]; [y0, y1] = [y1, y0]; }
  const first = Math.max(Math.floor(y0 - HAIR), 0), last = Math.min(Math.floor(y1 + HAIR), rows - 1);
  const slope = y1 > y0 ? (x1 - x0) / (y1 - y0) : 0;
  for (let row = first; row <= last; ++row) {
    let entry = found.get(row);
    if (!entry) found.set(row, entry = { met: [], crossings: [] });
    const enters = y0 >= row ? x0 : x0 + (row - y0) * slope, leaves = y1 <= row + 1 ? x1 : x0 + (row + 1 - y0) * slope;
    entry.met.push(Math.floor(Math.min(enters, leaves) - HAIR), Math.floor(Math.max(enters, leaves) + HAIR));
    const middle = row + 0.5;
    if (isBoundary && y0 <= middle && middle < y1) entry.crossings.push(x0 + (middle - y0) * slope);
  }
}

/** @type {(spans: Spans, start: number, columns: number, met: number[], crossings: number[]) => void} */
function addRow(spans, start, columns, met, crossings) {
  const edges = joined(met, columns), inside = [];
  crossings.sort((a, b) => a - b);
  for (let i = 0; i + 1 < crossings.length; i += 2) {
    const from = Math.max(Math.ceil(crossings[i] - 0.5), 0), to = Math.min(Math.floor(crossings[i + 1] - 0.5), columns - 1);
    if (from > to) continue;
    inside.push(from, to);
    let at = from;
    for (let e = 0; e < edges.length; e += 2) {
      if (edges[e] > at) addSpan(spans.inner, start, at, Math.min(edges[e] - 1, to));
      at = Math.max(at, edges[e + 1] + 1);
    }
    addSpan(spans.inner, start, at, to);
  }
  const all = joined([...edges, ...inside], columns);
  for (let i = 0; i < all.length; i += 2) addSpan(spans.touched, start, all[i], all[i + 1]);
}

/** @type {(list: number[], start: number, from: number, to: number) => void} */
function addSpan(list, start, from, to) { if (from <= to) list.push(start + from, to - from + 1); }

/** Ranges of cells in order, without overlaps, those of the grid. @param {number[]} ranges @param {number} columns */
function joined(ranges, columns) {
  const pairs = [];
  for (let i = 0; i < ranges.length; i += 2) {
    if (ranges[i] < columns && ranges[i + 1] >= 0) pairs.push([Math.max(ranges[i], 0), Math.min(ranges[i + 1], columns - 1)]);
  }
  pairs.sort((a, b) => a[0] - b[0]);
  /** @type {number[]} */
  const all = [];
  for (const [from, to] of pairs) {
    const last = all.length - 1;
    if (last > 0 && from <= all[last] + 1) all[last] = Math.max(all[last], to); else all.push(from, to);
  }
  return all;
}

export class Raster {
  /** @param {number} columns @param {number} rows @param {Frame} frame */
  constructor(columns, rows, frame) {
    this.columns = columns;
    this.rows = rows;
    this.frame = frame;
    this.touched = new Uint16Array(columns * rows);
    this.inner = new Uint16Array(columns * rows);
    /** @type {Map<unknown, Spans>} */
    this.spans = new Map();
  }

  /** @param {import("./scene.js").Copy} copy new, or moved, or scaled */
  put(copy) {
    this.remove(copy);
    const { x, y, unit } = this.frame;
    const spans = spansOf(copy.outline.rings, copy.passages, { x: x - copy.x, y: y - copy.y, unit }, this.columns, this.rows);
    this.spans.set(copy, spans);
    this.count(spans, 1);
  }

  /** @param {unknown} copy */
  remove(copy) {
    const spans = this.spans.get(copy);
    if (!spans) return;
    this.count(spans, -1);
    this.spans.delete(copy);
  }

  /** @param {Spans} spans @param {number} change */
  count({ touched, inner }, change) {
    for (const [list, counts] of /** @type {[number[], Uint16Array][]} */ ([[touched, this.touched], [inner, this.inner]])) {
      for (let i = 0; i < list.length; i += 2) {
        for (let cell = list[i], end = cell + list[i + 1]; cell < end; ++cell) counts[cell] += change;
      }
    }
  }
}
