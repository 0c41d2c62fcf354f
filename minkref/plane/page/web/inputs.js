// @ts-check
// The two operands in one unit, so that their sizes can be compared.
import { Box, fitted, flat, paint, pathOf, prepared, toScreen } from "../../../page/web/canvas.js";
import { element } from "../../../page/web/elements.js";
import { data } from "./data.js";

/** @param {number} s */
export function drawInputs(s) {
  const canvases = ["input-P", "input-Q"].map((id) => element(id, HTMLCanvasElement));
  const parts = [{ operand: data.P, factor: s, name: "P" }, { operand: data.Q, factor: 1, name: "Q" }].map((part) => {
    const box = new Box();
    const rings = flat(part.operand);
    for (const ring of data.erode && part.name === "P" ? rings.slice(1) : rings) box.addRing(ring, part.factor);
    return { ...part, box };
  });
  const least = Math.min(...parts.map(({ box }, i) => fitted(box, canvases[i].clientWidth, canvases[i].clientHeight, 12))
    .filter((_, i) => parts[i].box.across || parts[i].box.up).map((view) => view.unit), Infinity);
  const unit = Number.isFinite(least) ? least : 1;
  parts.forEach(({ operand, factor, name, box }, i) => {
    const { context, width, height } = prepared(canvases[i]);
    const [X, Y] = toScreen({ x: box.x, y: box.y, unit }, width, height);
    for (const polygon of operand) paint(context, pathOf(polygon, factor, X, Y), name);
    if (box.empty || Math.max(box.across, box.up) * unit >= 3) return;
    const mark = new Path2D();  // a point, or too small to be seen
    mark.arc(width / 2, height / 2, 3, 0, 2 * Math.PI);
    paint(context, mark, name);
  });
}
