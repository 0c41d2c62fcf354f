// @ts-check
// P as a path.
import { data } from "./data.js";
import { sides, walks } from "./rings.js";

/** @typedef {import("../../../page/web/canvas.js").Scaled} Scaled */

/** @param {Scaled} X @param {Scaled} Y */
export function pathOfP(X, Y) {
  const path = new Path2D();
  for (const { firstSide, endSide } of walks) {
    for (let side = firstSide; side < endSide; ++side) {
      const [x, y] = data.features[sides[side].from];
      if (side === firstSide) path.moveTo(X(x), Y(y)); else path.lineTo(X(x), Y(y));
    }
    path.closePath();
  }
  if (data.point) path.arc(X(data.point[0]), Y(data.point[1]), 1.5, 0, 2 * Math.PI);
  return path;
}
