// @ts-check
// The scene as it stands: its copies with exact scales and places, and the rings of their sums.
import { Box } from "../../../page/web/canvas.js";
import { Timeline } from "../../../page/web/timeline.js";
import { data } from "./data.js";
import { lowestTerms, numberOf } from "./exact_text.js";

/** @typedef {{ rings: Float64Array[], box: Box }} Outline rings x, y, x, y, ... before they are moved */

const timelines = data.sums.map((sum) => new Timeline(sum));

/** The sum of a shape at a scale and the turned robot. @param {number} sum @param {number} s @returns {Outline} */
export function outlineOf(sum, s) {
  const timeline = timelines[sum], rings = [], box = new Box();
  for (const { vertices } of timeline.at(s).values()) {
    const ring = new Float64Array(2 * vertices.length);
    vertices.forEach((track, i) => {
      ring[2 * i] = timeline.x(track, s);
      ring[2 * i + 1] = timeline.y(track, s);
      box.add(ring[2 * i], ring[2 * i + 1]);
    });
    rings.push(ring);
  }
  return { rings, box };
}

/** A placed, scaled copy of a shape. Its texts are exact; `s`, `x`, `y` are the doubles next to them. */
export class Copy {
  /** @param {number} shape @param {string} scale @param {string[]} place */
  constructor(shape, scale, place) {
    this.shape = shape;
    this.scale = "";
    this.s = NaN;
    /** @type {Outline} */
    this.outline = { rings: [], box: new Box() };
    /** @type {number[][]} */
    this.passages = [];  // the tight ones of its own sum, before they are moved
    this.place = place;
    this.x = this.y = NaN;
    this.moveTo(place);
    this.scaleTo(scale);
  }

  get sum() { return data.sums[/** @type {number} */ (data.shapes[this.shape].sum)]; }
  get name() { return data.shapes[this.shape].name; }

  /** @param {string[]} place two exact texts */
  moveTo(place) {
    this.place = place;
    [this.x, this.y] = place.map(numberOf);
  }

  /** Whether the page has the sums at a scale. @param {number} s */
  has(s) {
    const [[, first], [, last]] = this.sum.window;
    return s >= first && s <= last;
  }

  /** The text, or the end of the window that it is beyond. @param {string} text */
  clamped(text) {
    const [[low, first], [high, last]] = this.sum.window, s = numberOf(text);
    return s < first ? low : s > last ? high : text;
  }

  /** @param {string} text exact, in the window of the sum */
  scaleTo(text) {
    if (text === this.scale) return;
    this.scale = text;
    this.s = numberOf(text);
    this.outline = outlineOf(/** @type {number} */ (data.shapes[this.shape].sum), this.s);
    this.passages = this.sum.passages?.[lowestTerms(text)] ?? [];
  }

  clone() { return new Copy(this.shape, this.scale, this.place); }

  /** @param {Copy} other */
  equals(other) {
    return this.shape === other.shape && this.scale === other.scale && this.place.join() === other.place.join();
  }
}

/** The copies as read, made by scale, so that each sum is gone through once. */
export function copiesAsRead() {
  /** @type {Copy[]} */
  const copies = [];
  const order = data.copies.map(([, scale], number) => ({ number, s: numberOf(scale) })).sort((a, b) => a.s - b.s);
  for (const { number } of order) {
    const [shape, scale, x, y] = data.copies[number];
    copies[number] = new Copy(shape, scale, [x, y]);
  }
  return copies;
}

/** The file of a scene with these copies. @param {Copy[]} copies */
export function fileOf(copies) {
  return JSON.stringify({
    schema: "scene-v1",
    robot: data.robot.set,
    shapes: Object.fromEntries(data.shapes.map(({ name, set }) => [name, set])),
    copies: copies.map(({ name, scale, place }) => ({ shape: name, scale, place })),
  });
}
