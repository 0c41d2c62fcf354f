// @ts-check
// The part at a place and a scale among the obstacles, what collides, and the contact of a bound.
import { addRing, Box, dot, drawRuler, flat, paint, pathOf } from "../../../page/web/canvas.js";
import { colour } from "../../../page/web/colours.js";
import { isChecked } from "../../../page/web/elements.js";
import { Picture } from "../../../page/web/picture.js";
import { data } from "./data.js";
import { corners } from "./way.js";

/** @typedef {import("../../../page/web/canvas.js").Scaled} Scaled */
/** @typedef {CanvasRenderingContext2D} Context */
/** @typedef {import("./data.js").Bound} Bound */
/** @typedef {import("./way.js").Place} Place */

class Drawing extends Picture {
  /** @param {Place} place @param {number} s */
  fit(place, s) {
    const box = new Box();
    for (const ring of [...flat(data.obstacles), data.path]) box.addRing(ring);
    for (const ring of flat(data.part)) box.addRing(ring, s, place.x, place.y);
    this.fitTo(box);
  }

  /** @type {(place: Place, s: number, collision: import("./polygons.js").Polygon | null, bound: Bound | null) => void} */
  draw(place, s, collision, bound) {
    const { context, height, X, Y } = this.begin();
    /** @type {[Scaled, Scaled]} */
    const atPlace = [(x) => X(place.x + x), (y) => Y(place.y + y)];
    const obstacles = pathOf(flat(data.obstacles), 1, X, Y), part = pathOf(flat(data.part), s, ...atPlace);
    paint(context, obstacles, "Q");
    drawWay(context, X, Y);
    paint(context, part, "P");
    context.save();
    context.clip(part, "evenodd");
    context.fillStyle = colour("overlap");
    context.fill(obstacles, "evenodd");
    context.restore();
    if (collision && isChecked("show-pieces")) {
      outline(context, data.pieces.obstacles[collision.obstacle], 1, X, Y);
      outline(context, data.pieces.part[collision.part], s, ...atPlace);
    }
    dot(context, X(place.x), Y(place.y), 3.5, "way");
    if (bound) drawContact(context, bound, s, [X, Y], atPlace);
    drawRuler(context, this.view.unit, height);
  }
}

/** @type {(context: Context, X: Scaled, Y: Scaled) => void} */
function drawWay(context, X, Y) {
  context.beginPath();
  corners.forEach(([x, y], i) => { if (i) context.lineTo(X(x), Y(y)); else context.moveTo(X(x), Y(y)); });
  context.strokeStyle = colour("way");
  context.lineWidth = 1.4;
  context.stroke();
  for (const [x, y] of corners.length > 400 ? [corners[0], corners[corners.length - 1]] : corners) dot(context, X(x), Y(y), 1.8, "way");
}

/** @type {(context: Context, numbers: number[], factor: number, X: Scaled, Y: Scaled) => void} */
function outline(context, numbers, factor, X, Y) {
  const path = new Path2D();
  addRing(path, numbers, factor, X, Y);
  context.strokeStyle = colour("ink");
  context.lineWidth = 1.6;
  context.setLineDash([5, 3]);
  context.stroke(path);
  context.setLineDash([]);
}

/** Both features, thick, and where they touch. @type {(context: Context, bound: Bound, s: number, axes: [Scaled, Scaled], atPlace: [Scaled, Scaled]) => void} */
function drawContact(context, bound, s, axes, atPlace) {
  drawEdge(context, bound.obstacle, data.obstacles, 1, ...axes);
  drawEdge(context, bound.part, data.part, s, ...atPlace);
  const [X, Y] = axes, [x, y] = bound.about.touching;
  dot(context, X(x), Y(y), 6, "panel");
  dot(context, X(x), Y(y), 4.5, "overlap");
}

/** @type {(context: Context, feature: import("./data.js").Feature, operand: number[][][], factor: number, X: Scaled, Y: Scaled) => void} */
function drawEdge(context, feature, operand, factor, X, Y) {
  const [kind, [ring, index]] = Object.entries(feature)[0], numbers = flat(operand)[ring];
  if (kind !== "edge") return;
  const next = (2 * index + 2) % numbers.length;
  context.beginPath();
  context.moveTo(X(factor * numbers[2 * index]), Y(factor * numbers[2 * index + 1]));
  context.lineTo(X(factor * numbers[next]), Y(factor * numbers[next + 1]));
  context.strokeStyle = colour("overlap");
  context.lineWidth = 3;
  context.stroke();
}

export const drawing = new Drawing("picture");
