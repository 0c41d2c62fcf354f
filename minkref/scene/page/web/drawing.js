// @ts-check
// The picture: free space in colours, sums and obstacles over it, the robot where the pointer is.
import { Box, dot, drawRuler, fitted, paint, prepared } from "../../../page/web/canvas.js";
import { colour } from "../../../page/web/colours.js";
import { element } from "../../../page/web/elements.js";
import { data } from "./data.js";
import { Grid } from "./grid.js";
import { addRing, drawPart, Layer, Screen } from "./layers.js";
import { placeIn } from "./robot.js";

/** @typedef {import("./components.js").Contact} Contact */
/** @typedef {import("./robot.js").Situation} Situation */
/** @typedef {import("./scene.js").Copy} Copy */
/**
 * @typedef {object} Shown what the picture shows
 * @property {Copy[]} copies
 * @property {Copy | null} apart drawn apart from the others: it changes
 * @property {Copy | null} selected
 * @property {Contact} contact
 * @property {{ x: number, y: number, situation: Situation } | null} robot
 */

const HANDLE = 6;  // half the side of the handle, and
const NEAR = 5;  // how far from a thin thing the pointer finds it, in pixels

/** The box of each shape, and its corner farthest from the origin, where the handle is. */
const boxes = data.shapes.map(({ rings }) => {
  const box = new Box();
  for (const ring of rings.flat(1)) box.addRing(ring);
  const x = Math.abs(box.xmin) > Math.abs(box.xmax) ? box.xmin : box.xmax;
  const y = Math.abs(box.ymin) > Math.abs(box.ymax) ? box.ymin : box.ymax;
  return { box, corner: box.empty ? [0, 0] : [x, y] };
});

/** @param {Copy} copy */
export const cornerOf = (copy) => boxes[copy.shape].corner;

export class Drawing {
  constructor() {
    this.canvas = element("picture", HTMLCanvasElement);
    this.view = { x: 0, y: 0, unit: 1 };
    this.grid = new Grid();
    this.layer = new Layer();
    this.canvas.getContext("2d", { alpha: false });  // all of it is drawn, with nothing behind
    this.isFine = false;
  }

  get screen() {
    const { canvas: { clientWidth, clientHeight }, view } = this;
    return new Screen(view, Math.max(clientWidth, 1), Math.max(clientHeight, 1), devicePixelRatio || 1);
  }

  /** @param {Copy[]} copies */
  fit(copies) {
    const box = new Box(), { width, height } = this.screen;
    for (const { x, y, outline: { box: own } } of copies) {
      if (own.empty) continue;
      box.add(x + own.xmin, y + own.ymin);
      box.add(x + own.xmax, y + own.ymax);
    }
    if (box.empty) for (const ring of data.robot.rings.flat(1)) box.addRing(ring);
    this.view = fitted(box, width, height, Math.min(width, height) / 12);
  }

  /** Finds and colours the free space. @param {Copy[]} copies @param {Contact} contact @param {boolean} isFine */
  colourFree(copies, contact, isFine) {
    const { width, height } = this.screen;
    this.grid.fit(copies, this.view, width, height, isFine);
    this.grid.colour(copies, contact);
    this.isFine = isFine;
  }

  /** @param {Shown} shown */
  draw(shown) {
    const { screen, grid, layer } = this, { context } = prepared(this.canvas), { columns, rows } = grid.raster;
    layer.fit(shown.copies, shown.apart, screen);
    const drawGrid = /** @param {HTMLCanvasElement} image */ (image) => {
      context.imageSmoothingEnabled = false;
      context.drawImage(image, 0, 0, columns * grid.side, rows * grid.side);
    };
    const begin = () => context.setTransform(screen.ratio, 0, 0, screen.ratio, 0, 0);
    drawGrid(grid.free);
    if (shown.apart) for (const part of /** @type {const} */ (["lines", "sums"])) drawPart(context, screen, part, shown.apart);
    context.setTransform(1, 0, 0, 1, 0, 0);
    context.drawImage(layer.canvas, 0, 0);
    if (shown.apart) drawPart(context, screen, "obstacles", shown.apart);
    begin();
    if (grid.hasSeams) drawGrid(grid.seams);
    if (shown.selected) this.drawSelected(context, screen, shown.selected);
    if (shown.robot) drawRobot(context, screen, shown.robot);
    begin();
    drawRuler(context, this.view.unit, screen.height);
  }

  /** The box of the obstacle, its place and its handle. @param {CanvasRenderingContext2D} context @param {Screen} screen @param {Copy} copy */
  drawSelected(context, screen, copy) {
    const { box } = boxes[copy.shape], { s, x, y } = copy, pad = 3;
    const left = screen.X(x + s * box.xmin), top = screen.Y(y + s * box.ymax);
    context.strokeStyle = colour("accent");
    context.lineWidth = 1.5;
    context.setLineDash([5, 4]);
    context.strokeRect(left - pad, top - pad, s * box.across * screen.view.unit + 2 * pad, s * box.up * screen.view.unit + 2 * pad);
    context.setLineDash([]);
    const at = this.handleOf(copy);
    context.fillStyle = colour("accent");
    if (at) context.fillRect(at[0] - HANDLE, at[1] - HANDLE, 2 * HANDLE, 2 * HANDLE);
  }

  /** Where the handle is on the screen; null for a shape that does not grow. @param {Copy} copy */
  handleOf(copy) {
    const [x, y] = cornerOf(copy), { screen } = this;
    return x || y ? [screen.X(copy.x + copy.s * x), screen.Y(copy.y + copy.s * y)] : null;
  }

  /** The name of the free part at a place; -1 where there is none. @param {number} x @param {number} y */
  nameAt(x, y) { return this.grid.nameAt(this.screen.X(x), this.screen.Y(y)); }

  /** A pixel by which a hand takes a copy: the middle of an edge of its obstacle; null if others lie over all. @param {Copy[]} copies @param {Copy} copy */
  holdOf(copies, copy) {
    for (const ring of data.shapes[copy.shape].rings.flat(1)) {
      for (let i = 0, n = ring.length; i < n; i += 2) {
        const u = (ring[i] + ring[(i + 2) % n]) / 2, v = (ring[i + 1] + ring[(i + 3) % n]) / 2;
        const pixel = [this.screen.X(copy.x + copy.s * u), this.screen.Y(copy.y + copy.s * v)];
        if (this.copyAt(copies, pixel) === copy) return pixel;
      }
    }
    return null;
  }

  /** Whether the handle is at a pixel. @param {Copy} copy @param {number[]} pixel */
  isHandleAt(copy, [x, y]) {
    const at = this.handleOf(copy);
    return at !== null && Math.abs(x - at[0]) <= HANDLE + 2 && Math.abs(y - at[1]) <= HANDLE + 2;
  }

  /** @param {number[]} pixel */
  worldAt([x, y]) {
    const { view, screen } = this;
    return { x: view.x + (x - screen.width / 2) / view.unit, y: view.y - (y - screen.height / 2) / view.unit };
  }

  /** The copy at a pixel: by its obstacle, the last one drawn, or else by its sum. @param {Copy[]} copies @param {number[]} pixel */
  copyAt(copies, pixel) {
    const { x, y } = this.worldAt(pixel), near = NEAR / this.view.unit;
    return copies.findLast((copy) => {
      const u = (x - copy.x) / copy.s, v = (y - copy.y) / copy.s, { box } = boxes[copy.shape], reach = near / copy.s;
      if (u < box.xmin - reach || u > box.xmax + reach || v < box.ymin - reach || v > box.ymax + reach) return false;
      const { inside, distance } = placeIn(data.shapes[copy.shape].rings.flat(1), u, v);
      return inside || distance < reach;
    }) ?? copies.findLast((copy) => {
      const { box, rings } = copy.outline, u = x - copy.x, v = y - copy.y;
      return u >= box.xmin && u <= box.xmax && v >= box.ymin && v <= box.ymax && placeIn(rings, u, v).inside;
    }) ?? null;
  }
}

/** @type {(context: CanvasRenderingContext2D, screen: Screen, robot: NonNullable<Shown["robot"]>) => void} */
function drawRobot(context, screen, { x, y, situation: { state } }) {
  const outline = new Path2D();
  for (const ring of data.robot.rings.flat(1)) addRing(outline, ring, 1, 0, 0, screen.view.unit);
  screen.beginAt(context, x, y);
  paint(context, outline, `robot-${state}`, 2);
  dot(context, 0, 0, 2.5, "ink");
}

