// @ts-check
// The sum at one radius: P, the boundary with its arcs, the holes, the diagram.
import { Box, drawPassages, drawRuler, drawText, encircle, paint, pathIn } from "../../../page/web/canvas.js";
import { colour } from "../../../page/web/colours.js";
import { isChecked } from "../../../page/web/elements.js";
import { clamped } from "../../../page/web/numbers.js";
import { PictureWithHoles } from "../../../page/web/picture.js";
import { axis, boxOfP, data, pointOf, radiusOf } from "./data.js";
import { boundary } from "./history.js";
import { pathOfP } from "./outline.js";
import { halves, piecesOf, sides, turnOf } from "./rings.js";
import { skeletonParts } from "./skeleton.js";

/** @typedef {import("../../../page/web/canvas.js").Scaled} Scaled */
/** @typedef {CanvasRenderingContext2D} Context */

class Drawing extends PictureWithHoles {
  /** Shows P, moved outwards by the radius. @param {number} radius */
  fit(radius) {
    const box = new Box();
    if (!boxOfP.empty) {
      box.add(boxOfP.xmin - radius, boxOfP.ymin - radius);
      box.add(boxOfP.xmax + radius, boxOfP.ymax + radius);
    }
    this.fitTo(box);
  }

  /**
   * @param {number} radius
   * @param {number} gap
   * @param {number[]} marked events
   * @param {import("../../../page/web/picture.js").Chosen | null} chosen
   * @param {number[][]} passages
   */
  draw(radius, gap, marked, chosen, passages) {
    const { context, width, height, X, Y } = this.begin(), sum = new Path2D();
    this.holes.clear();
    for (const ring of boundary.at(gap)) {
      const path = ringPath(piecesOf(ring, radius), radius * this.view.unit, X, Y);
      sum.addPath(path);
      if (ring.hole) pathIn(this.holes, ring.hole).addPath(path);
    }
    this.fillHoles(context, chosen);
    paint(context, sum, "sum", 1.1);
    paint(context, pathOfP(X, Y), "P");
    if (isChecked("show-diagram")) drawDiagram(context, X, Y);
    this.outlineHole(context, chosen);
    drawPassages(context, passages, X, Y);
    marked.forEach((event) => drawPlace(context, event, X, Y));
    if (chosen?.feature === "e") this.drawEvent(context, chosen.id, X, Y);
    if (!boxOfP.empty) drawRuler(context, this.view.unit, height);
    else drawText(context, "The sum is empty at every radius.", width, height);
  }

  /** Its empty disc, and its features. @type {(context: Context, event: number, X: Scaled, Y: Scaled) => void} */
  drawEvent(context, event, X, Y) {
    const [x, y] = pointOf(event);
    context.strokeStyle = context.fillStyle = colour("death");
    context.lineWidth = 1.2;
    context.setLineDash([5, 4]);
    context.beginPath();
    context.arc(X(x), Y(y), data.radii[radiusOf(event)] * this.view.unit, 0, 2 * Math.PI);
    context.stroke();
    context.setLineDash([]);
    for (const number of data.near[event]) {
      const [px, py, , , line = number] = data.features[number];
      context.beginPath();
      if (data.features[number].length === 2) {
        context.arc(X(px), Y(py), 4.5, 0, 2 * Math.PI);
        context.fill();
        continue;
      }
      const [from, to] = sideBefore(line, x, y);
      context.moveTo(X(from[0]), Y(from[1]));
      context.lineTo(X(to[0]), Y(to[1]));
      context.lineWidth = 4;
      context.stroke();
    }
    drawPlace(context, event, X, Y);
  }
}

/**
 * Upwards on the screen is downwards in its numbers: arcs turn the other way.
 * @type {(pieces: import("./rings.js").Piece[], radius: number, X: Scaled, Y: Scaled) => Path2D}
 */
function ringPath(pieces, radius, X, Y) {
  const path = new Path2D();
  pieces.forEach(({ centre, from, to }, i) => {
    if (!i) path.moveTo(X(from[0]), Y(from[1]));
    if (centre) {
      const { start, turn } = turnOf(centre, from, to);
      if (turn > 0) path.arc(X(centre[0]), Y(centre[1]), radius, -start, -start - turn, true);
    }
    path.lineTo(X(to[0]), Y(to[1]));
  });
  path.closePath();
  return path;
}

/** @type {(context: Context, X: Scaled, Y: Scaled) => void} */
function drawDiagram(context, X, Y) {
  const size = Math.max(boxOfP.across, boxOfP.up), far = Math.max(3 * size, 2 * axis.last);
  context.beginPath();
  for (const { from, to, bend } of skeletonParts(far)) {
    context.moveTo(X(from[0]), Y(from[1]));
    if (bend) context.quadraticCurveTo(X(bend[0]), Y(bend[1]), X(to[0]), Y(to[1]));
    else context.lineTo(X(to[0]), Y(to[1]));
  }
  context.strokeStyle = colour("diagram");
  context.lineWidth = halves.length > 8000 ? 0.6 : 1;
  context.stroke();
}

/** @type {(context: Context, event: number, X: Scaled, Y: Scaled) => void} */
function drawPlace(context, event, X, Y) {
  const [x, y] = pointOf(event);
  encircle(context, X(x), Y(y), [6.5, 5], 1.8);
}

/** The ends of the edge of a line that is nearest to a place. @param {number} line @param {number} x @param {number} y */
function sideBefore(line, x, y) {
  let best = [[x, y], [x, y]], least = Infinity;
  for (const { feature, from, to } of sides) {
    if (feature !== line) continue;
    const [p, q] = [data.features[from], data.features[to]], dx = q[0] - p[0], dy = q[1] - p[1];
    const share = clamped(((x - p[0]) * dx + (y - p[1]) * dy) / (dx * dx + dy * dy), 0, 1);
    const distance = Math.hypot(x - p[0] - share * dx, y - p[1] - share * dy);
    if (distance < least) { best = [p, q]; least = distance; }
  }
  return best;
}

export const drawing = new Drawing("sum", "evenodd");
