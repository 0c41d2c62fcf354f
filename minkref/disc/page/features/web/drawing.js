// @ts-check
// P with the regions of its features, each in the colour of its bar, bridges and pocket minima.
import { drawRuler, drawText, paint, pathIn } from "../../../../page/web/canvas.js";
import { colour, holeFill } from "../../../../page/web/colours.js";
import { PictureWithHoles } from "../../../../page/web/picture.js";
import { boxOfP } from "../../web/data.js";
import { pathOfP } from "../../web/outline.js";

/** @typedef {import("../../../../page/web/canvas.js").Scaled} Scaled */
/** @typedef {import("./regions.js").Feature} Feature */

class Drawing extends PictureWithHoles {
  fit() { this.fitTo(boxOfP); }

  /** @param {Feature[]} features those that are shown @param {number | null} chosen a bar */
  draw(features, chosen) {
    const { context, width: across, height, X, Y } = this.begin();
    this.holes.clear();
    context.fillStyle = colour("rule");
    for (const { bar, rings } of features) {
      const path = pathIn(bar === null ? new Map() : this.holes, bar ?? 0);
      rings.forEach((ring) => addRing(path, ring, X, Y));
      if (bar === null) context.fill(path, this.rule);
    }
    const one = chosen === null ? null : { feature: "h", id: chosen };
    this.fillHoles(context, one);
    paint(context, pathOfP(X, Y), "P");
    this.outlineHole(context, one);
    for (const { bar, bridges, pocket } of features) {
      if (bar === null) continue;
      const isPale = chosen !== null && chosen !== bar && features.some((other) => other.bar === chosen);
      context.globalAlpha = isPale ? 0.35 : 1;
      context.beginPath();
      for (const { from, to } of bridges) { context.moveTo(X(from[0]), Y(from[1])); context.lineTo(X(to[0]), Y(to[1])); }
      for (const [width, stroke] of /** @type {[number, string][]} */ ([[bar === chosen ? 5 : 3.4, colour("ink")], [1.6, holeFill(bar)]])) {
        context.lineWidth = width;
        context.strokeStyle = stroke;
        context.stroke();
      }
      if (pocket) drawPocket(context, X(pocket.vertex[0]), Y(pocket.vertex[1]), holeFill(bar));
    }
    context.globalAlpha = 1;
    if (!boxOfP.empty) drawRuler(context, this.view.unit, height);
    else drawText(context, "P is empty.", across, height);
  }
}

/** @type {(path: Path2D, ring: import("../../web/data.js").Point[], X: Scaled, Y: Scaled) => void} */
function addRing(path, ring, X, Y) {
  ring.forEach(([x, y], i) => (i ? path.lineTo(X(x), Y(y)) : path.moveTo(X(x), Y(y))));
  path.closePath();
}

/** @type {(context: CanvasRenderingContext2D, x: number, y: number, fill: string) => void} */
function drawPocket(context, x, y, fill) {
  context.beginPath();
  context.arc(x, y, 4.5, 0, 2 * Math.PI);
  context.fillStyle = fill;
  context.fill();
  context.strokeStyle = colour("ink");
  context.lineWidth = 1.4;
  context.stroke();
}

export const drawing = new Drawing("sum", "evenodd");
