// @ts-check
// A canvas as large as its element, in device pixels, and what the pages draw on it.
import { colour } from "./colours.js";
import { short } from "./numbers.js";

/** @typedef {(coordinate: number) => number} Scaled a coordinate as pixels */
/** @typedef {{ x: number, y: number, unit: number }} View `unit`: pixels for a length of 1; (x, y) is in the middle. */

/** @param {HTMLCanvasElement} canvas */
export function prepared(canvas) {
  const ratio = devicePixelRatio || 1;
  const width = Math.max(canvas.clientWidth, 1), height = Math.max(canvas.clientHeight, 1);
  if (canvas.width !== Math.round(width * ratio) || canvas.height !== Math.round(height * ratio)) {
    canvas.width = Math.round(width * ratio);
    canvas.height = Math.round(height * ratio);
  }
  const context = contextOf(canvas);
  context.setTransform(ratio, 0, 0, ratio, 0, 0);
  context.clearRect(0, 0, width, height);
  context.lineJoin = "round";
  return { context, width, height };
}

/** @param {HTMLCanvasElement} canvas */
export const contextOf = (canvas) => /** @type {CanvasRenderingContext2D} */ (canvas.getContext("2d"));

export class Box {
  constructor() { this.xmin = this.ymin = Infinity; this.xmax = this.ymax = -Infinity; }
  /** @param {number} x @param {number} y */
  add(x, y) {
    if (x < this.xmin) this.xmin = x;
    if (x > this.xmax) this.xmax = x;
    if (y < this.ymin) this.ymin = y;
    if (y > this.ymax) this.ymax = y;
  }
  /** Numbers x, y, x, y, ...; a factor for all of them, then a move. @param {number[]} numbers */
  addRing(numbers, factor = 1, x = 0, y = 0) {
    for (let i = 0; i < numbers.length; i += 2) this.add(x + factor * numbers[i], y + factor * numbers[i + 1]);
  }
  get empty() { return this.xmin > this.xmax; }
  get across() { return this.empty ? 0 : this.xmax - this.xmin; }
  get up() { return this.empty ? 0 : this.ymax - this.ymin; }
  get x() { return this.empty ? 0 : (this.xmin + this.xmax) / 2; }
  get y() { return this.empty ? 0 : (this.ymin + this.ymax) / 2; }
}

/** The view that shows all of a box. @type {(box: Box, width: number, height: number, pad: number) => View} */
export function fitted(box, width, height, pad) {
  const across = (width - 2 * pad) / (box.across || 1e-300), up = (height - 2 * pad) / (box.up || 1e-300);
  const unit = Math.min(across, up);
  return { x: box.x, y: box.y, unit: unit > 1e290 || !(unit > 0) ? 1 : unit };
}

/** With y upwards. @type {(view: View, width: number, height: number) => [Scaled, Scaled]} */
export const toScreen = (view, width, height) => [
  (x) => width / 2 + (x - view.x) * view.unit,
  (y) => height / 2 - (y - view.y) * view.unit,
];

/** All rings of an operand: those of each polygon, the outer one first. @param {number[][][]} operand */
export const flat = (operand) => operand.flat(1);

/**
 * A ring of numbers x, y, x, y, ... in a path; a factor for all of them.
 * @param {Path2D} path
 * @param {number[]} numbers
 * @param {number} factor
 * @param {Scaled} X
 * @param {Scaled} Y
 */
export function addRing(path, numbers, factor, X, Y) {
  for (let i = 0; i < numbers.length; i += 2) {
    const x = X(numbers[i] * factor), y = Y(numbers[i + 1] * factor);
    if (i) path.lineTo(x, y); else path.moveTo(x, y);
  }
  path.closePath();
}

/** @type {(rings: number[][], factor: number, X: Scaled, Y: Scaled) => Path2D} */
export function pathOf(rings, factor, X, Y) {
  const path = new Path2D();
  for (const ring of rings) addRing(path, ring, factor, X, Y);
  return path;
}

/** The path that a map has of a number, or a new one. @param {Map<number, Path2D>} paths @param {number} id */
export function pathIn(paths, id) {
  const path = paths.get(id) ?? new Path2D();
  paths.set(id, path);
  return path;
}

/**
 * Fills and outlines what a colour of the style is for.
 * @param {CanvasRenderingContext2D} context
 * @param {Path2D} path
 * @param {string} name
 */
export function paint(context, path, name, width = 1) {
  context.fillStyle = colour(name);
  context.fill(path, "evenodd");
  context.strokeStyle = colour(`${name}-line`);
  context.lineWidth = width;
  context.stroke(path);
}

/** @type {(context: CanvasRenderingContext2D, x: number, y: number, radius: number, name: string) => void} */
export function dot(context, x, y, radius, name) {
  context.beginPath();
  context.arc(x, y, radius, 0, 2 * Math.PI);
  context.fillStyle = colour(name);
  context.fill();
}

/** A circle around a place, in a paler one. @type {(context: CanvasRenderingContext2D, x: number, y: number, radii: [number, number], width: number) => void} */
export function encircle(context, x, y, [outer, inner], width) {
  context.lineWidth = width;
  for (const [radius, name] of /** @type {const} */ ([[outer, "panel"], [inner, "death"]])) {
    context.beginPath();
    context.arc(x, y, radius, 0, 2 * Math.PI);
    context.strokeStyle = colour(name);
    context.stroke();
  }
}

const FONT = "system-ui, 'DejaVu Sans', sans-serif";

/** A line of a round length in the lower left corner. @type {(context: CanvasRenderingContext2D, unit: number, height: number) => void} */
export function drawRuler(context, unit, height) {
  const most = 110 / unit, power = 10 ** Math.floor(Math.log10(most));
  const length = [5, 2, 1].map((n) => n * power).find((n) => n <= most) ?? most;
  const y = height - 10;
  context.strokeStyle = context.fillStyle = colour("soft");
  context.lineWidth = 1.2;
  context.beginPath();
  context.moveTo(10, y - 4); context.lineTo(10, y); context.lineTo(10 + length * unit, y); context.lineTo(10 + length * unit, y - 4);
  context.stroke();
  context.font = `11px ${FONT}`;
  context.fillText(short(length), 14, y - 5);
}

/** A text in the middle. @type {(context: CanvasRenderingContext2D, text: string, width: number, height: number) => void} */
export function drawText(context, text, width, height) {
  context.fillStyle = colour("soft");
  context.font = `16px ${FONT}`;
  context.textAlign = "center";
  context.fillText(text, width / 2, height / 2);
  context.textAlign = "start";
}

/**
 * Tight passages: x, y, x, y, ... of each; lines, and a ring around a point.
 * @type {(context: CanvasRenderingContext2D, passages: number[][], X: Scaled, Y: Scaled) => void}
 */
export function drawPassages(context, passages, X, Y) {
  context.strokeStyle = colour("tight");
  context.lineWidth = 2.6;
  context.beginPath();
  for (const numbers of passages) {
    for (let i = 0; i < numbers.length; i += 2) {
      const x = X(numbers[i]), y = Y(numbers[i + 1]);
      if (i) { context.lineTo(x, y); continue; }
      context.moveTo(x, y);
      if (numbers.length === 2) { context.moveTo(x + 5, y); context.arc(x, y, 5, 0, 2 * Math.PI); }
    }
  }
  context.stroke();
}
