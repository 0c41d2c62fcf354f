// @ts-check
// A canvas that keeps what does not change while a copy is dragged.
import { contextOf } from "../../../page/web/canvas.js";
import { colour } from "../../../page/web/colours.js";
import { data } from "./data.js";

/** @typedef {import("./scene.js").Copy} Copy */
/** @typedef {import("../../../page/web/canvas.js").View} View */
/** @typedef {CanvasRenderingContext2D} Context */
/** @typedef {{ sum: Path2D, obstacle: Path2D, x: number, y: number, key: string }} Paths in pixels, from the place that is at (x, y) before the copy is moved */

/** @type {WeakMap<Copy, Paths>} */
const kept = new WeakMap();

/** A copy's paths at a zoom; made anew where scale or zoom changed. @param {Copy} copy @param {number} unit @returns {Paths} */
function pathsOf(copy, unit) {
  const key = `${copy.scale} ${unit}`, known = kept.get(copy);
  if (known?.key === key) return known;
  const { box, rings } = copy.outline, x = box.x, y = box.y;
  const made = { sum: new Path2D(), obstacle: new Path2D(), x, y, key };
  for (const ring of rings) addRing(made.sum, ring, 1, x, y, unit);
  for (const polygon of data.shapes[copy.shape].rings) {
    for (const ring of polygon) addRing(made.obstacle, ring, copy.s, x, y, unit);
  }
  kept.set(copy, made);
  return made;
}

/** @type {(path: Path2D, ring: ArrayLike<number>, factor: number, x: number, y: number, unit: number) => void} */
export function addRing(path, ring, factor, x, y, unit) {  // a point as a dot
  for (let i = 0; i < ring.length; i += 2) {
    const u = (factor * ring[i] - x) * unit, v = (y - factor * ring[i + 1]) * unit;
    if (i) path.lineTo(u, v); else path.moveTo(u, v);
  }
  if (ring.length === 2) path.arc((factor * ring[0] - x) * unit, (y - factor * ring[1]) * unit, 3, 0, 2 * Math.PI);
  path.closePath();
}

/** Where and how large things are on the screen. */
export class Screen {
  /** @param {View} view @param {number} width @param {number} height @param {number} ratio device pixels in a pixel */
  constructor(view, width, height, ratio) {
    this.view = view;
    this.width = width;
    this.height = height;
    this.ratio = ratio;
    this.key = [view.x, view.y, view.unit, width, height, ratio].join();
  }

  /** @param {number} x */
  X(x) { return this.width / 2 + (x - this.view.x) * this.view.unit; }
  /** @param {number} y */
  Y(y) { return this.height / 2 - (y - this.view.y) * this.view.unit; }

  /** Pixels that begin at a place. @param {Context} context @param {number} x @param {number} y */
  beginAt(context, x, y) { context.setTransform(this.ratio, 0, 0, this.ratio, this.ratio * this.X(x), this.ratio * this.Y(y)); }
}

/** What is drawn of copies: one thing for all of them, then the next, so that lines inside of other sums are covered. */
const PARTS = /** @type {const} */ (["lines", "sums", "obstacles"]);

/** @type {(context: Context, screen: Screen, part: typeof PARTS[number], copy: Copy) => void} */
export function drawPart(context, screen, part, copy) {
  const { sum, obstacle, x, y } = pathsOf(copy, screen.view.unit);
  screen.beginAt(context, copy.x + x, copy.y + y);
  if (part === "lines") {
    context.strokeStyle = colour("sum-line");
    context.lineWidth = 2.4;
    context.lineJoin = "round";
    context.stroke(sum);
  } else if (part === "sums") {
    context.fillStyle = colour("sum");
    context.fill(sum, "evenodd");
  } else {
    context.fillStyle = colour("P");
    context.fill(obstacle, "evenodd");
    context.strokeStyle = colour("P-line");
    context.lineWidth = 1;
    context.stroke(obstacle);
  }
}

export class Layer {
  constructor() {
    this.key = "";
    /** @type {Copy | null} */
    this.without = null;
    this.canvas = document.createElement("canvas");
  }

  /** Forgets what is drawn: copies or colours changed. */
  clear() { this.key = ""; }

  /**
   * Draws all copies but one, unless that is done.
   * @param {Copy[]} copies
   * @param {Copy | null} without
   * @param {Screen} screen
   */
  fit(copies, without, screen) {
    if (this.key === screen.key && this.without === without) return;
    this.key = screen.key;
    this.without = without;
    this.canvas.width = Math.round(screen.width * screen.ratio);
    this.canvas.height = Math.round(screen.height * screen.ratio);
    const context = contextOf(this.canvas);
    for (const part of PARTS) for (const copy of copies) if (copy !== without) drawPart(context, screen, part, copy);
  }
}
