// @ts-check
// The sum at one scale, with its holes and the convolution.
import { Box, drawPassages, drawRuler, drawText, encircle, flat, paint, pathIn } from "../../../page/web/canvas.js";
import { colour } from "../../../page/web/colours.js";
import { isChecked } from "../../../page/web/elements.js";
import { PictureWithHoles } from "../../../page/web/picture.js";
import { data } from "./data.js";
import { paper } from "./paper.js";
import { timeline, xOf, yOf } from "./timeline.js";

/** @typedef {import("../../../page/web/canvas.js").Scaled} Scaled */
/** @typedef {import("./data.js").Operand} Operand */

/** @param {Operand} operand */
const verticesOf = (operand) => flat(operand).flat();
const vertices = { P: verticesOf(data.P), Q: verticesOf(data.Q) };

/** The number of the next vertex along its ring. @param {Operand} operand */
function followers(operand) {
  /** @type {number[]} */
  const next = [];
  for (const ring of flat(operand)) {
    const first = next.length, n = ring.length / 2;
    for (let i = 0; i < n; ++i) next.push(first + ((i + 1) % n));
  }
  return next;
}
const followerOf = { P: followers(data.P), Q: followers(data.Q) };

class Drawing extends PictureWithHoles {
  /** @type {number[] | null} */
  place = null;  // of the event where the page stands

  /** @param {number} s */
  fit(s) {
    const box = new Box();
    if (data.erode) {  // where P is, not the box around it
      for (const ring of flat(data.P).slice(1)) box.addRing(ring, s);
      this.fitTo(box);
      return;
    }
    for (const { isHole, vertices: ring } of timeline.at(s).values()) {
      if (!isHole) for (const track of ring) box.add(xOf(track, s), yOf(track, s));
    }
    paper.widen(box, s);
    this.fitTo(box);
  }

  /**
   * @param {number} s
   * @param {import("../../../page/web/picture.js").Chosen | null} chosen
   * @param {number[][]} passages
   */
  draw(s, chosen, passages) {
    const { context, width, height, X, Y } = this.begin(), components = this.collect(s, X, Y);
    this.fillHoles(context, chosen);
    for (const [id, path] of components) {  // over the holes: what lies inside of a hole shows
      paint(context, path, "sum", chosen?.feature === "c" && chosen.id === id ? 3 : 1.1);
    }
    paper.draw(context, s, X, Y);
    for (const kind of /** @type {const} */ (["T", "S"])) if (isChecked(`show-${kind}`)) this.drawEdges(context, kind, s, X, Y);
    this.outlineHole(context, chosen);
    drawPassages(context, passages, X, Y);
    if (this.place) encircle(context, X(this.place[0]), Y(this.place[1]), [9, 7], 2);
    if (components.size) drawRuler(context, this.view.unit, height);
    else drawText(context, "The sum is empty at every scale.", width, height);
  }

  /** The components on the screen; the holes are kept. @param {number} s @param {Scaled} X @param {Scaled} Y */
  collect(s, X, Y) {
    /** @type {Map<number, Path2D>} */
    const components = new Map();
    this.holes.clear();
    for (const ring of timeline.at(s).values()) {
      const path = new Path2D();
      ring.vertices.forEach((track, i) => {
        const x = X(xOf(track, s)), y = Y(yOf(track, s));
        if (i) path.lineTo(x, y); else path.moveTo(x, y);
      });
      path.closePath();
      pathIn(components, ring.component).addPath(path);
      if (ring.isHole) pathIn(this.holes, ring.hole).addPath(path);
    }
    return components;
  }

  /** @type {(context: CanvasRenderingContext2D, kind: "S" | "T", s: number, X: Scaled, Y: Scaled) => void} */
  drawEdges(context, kind, s, X, Y) {
    const list = data[kind], [own, other] = kind === "S" ? /** @type {const} */ (["P", "Q"]) : /** @type {const} */ (["Q", "P"]);
    const [of, at] = kind === "S" ? [s, 1] : [1, s];
    const edges = vertices[own], points = vertices[other], next = followerOf[own];
    context.beginPath();
    for (let i = 0; i < list.length; i += 2) {
      const a = 2 * list[i], b = 2 * next[list[i]], p = 2 * list[i + 1];
      const x = at * points[p], y = at * points[p + 1];
      context.moveTo(X(of * edges[a] + x), Y(of * edges[a + 1] + y));
      context.lineTo(X(of * edges[b] + x), Y(of * edges[b + 1] + y));
    }
    context.strokeStyle = colour(kind);
    context.lineWidth = list.length > 4000 ? 0.5 : 0.9;
    context.stroke();
  }
}

export const drawing = new Drawing("sum", "nonzero");
