// @ts-check
// The raster of a picture, made anew where the view changes, and its free space as an image.
import { holeFill, colour } from "../../../page/web/colours.js";
import { contextOf } from "../../../page/web/canvas.js";
import { componentsOf, Names, seamsOf } from "./components.js";
import { Raster } from "./raster.js";

/** @typedef {import("./components.js").Contact} Contact */
/** @typedef {import("./scene.js").Copy} Copy */
/** @typedef {import("../../../page/web/canvas.js").View} View */

const MOST = { coarse: 80_000, fine: 1_500_000 };  // cells: while something is dragged, and at rest

/** The side of a cell, a whole number of pixels. @param {number} width @param {number} height @param {boolean} isFine */
function sideOf(width, height, isFine) {
  let side = isFine ? 1 : 2;
  while (Math.ceil(width / side) * Math.ceil(height / side) > (isFine ? MOST.fine : MOST.coarse)) ++side;
  return side;
}

const blank = () => ({ key: "", side: 1, raster: new Raster(1, 1, { x: 0, y: 0, unit: 1 }) });

export class Grid {
  constructor() {
    this.names = new Names();
    this.kept = { coarse: blank(), fine: blank() };
    this.shown = this.kept.coarse;
    this.free = document.createElement("canvas");
    this.seams = document.createElement("canvas");
    /** @type {number[]} */
    this.found = [];  // names of the components in the picture
    this.hasSeams = false;
    /** @type {Map<number, number>} */
    this.palette = new Map();
  }

  /**
   * The raster of a view, with all copies in it.
   * @param {Copy[]} copies
   * @param {View} view
   * @param {number} width
   * @param {number} height
   * @param {boolean} isFine
   */
  fit(copies, view, width, height, isFine) {
    const side = sideOf(width, height, isFine), key = [view.x, view.y, view.unit, width, height, side].join();
    const shown = this.shown = isFine ? this.kept.fine : this.kept.coarse;
    if (key !== shown.key) {
      const frame = { x: view.x - width / 2 / view.unit, y: view.y + height / 2 / view.unit, unit: view.unit / side };
      Object.assign(shown, { key, side, raster: new Raster(Math.ceil(width / side), Math.ceil(height / side), frame) });
    }
    const left = new Set(this.raster.spans.keys());
    for (const copy of copies) if (!left.delete(copy)) this.raster.put(copy);
    for (const copy of left) this.raster.remove(copy);
  }

  get raster() { return this.shown.raster; }
  get side() { return this.shown.side; }

  /** Counts a copy anew that moved or grew: among coarse cells at once, among fine ones when these are shown. @param {Copy} copy */
  change(copy) {
    const { coarse, fine } = this.kept;
    if (coarse.raster.spans.has(copy)) coarse.raster.put(copy);
    fine.raster.remove(copy);
  }

  /** The free space. @param {Copy[]} copies @param {Contact} contact */
  colour(copies, contact) {
    const { raster } = this, isWhole = this.hasAll(copies), components = componentsOf(raster, contact, isWhole);
    const names = this.names.of(raster, components, isWhole);
    this.found = names;
    this.drawFree(components.cells, names);
    const seams = contact === "allowed" ? seamsOf(raster) : [];
    this.hasSeams = seams.length > 0;
    if (this.hasSeams) this.drawSeams(seams);
  }

  /** Whether the picture has all sums, with free cells around. @param {Copy[]} copies */
  hasAll(copies) {
    const { columns, rows, frame: { x, y, unit } } = this.raster, cell = 1 / unit;
    return copies.every((copy) => {
      const { box } = copy.outline;
      return box.empty || (copy.x + box.xmin > x + cell && copy.x + box.xmax < x + (columns - 1) * cell
        && copy.y + box.ymax < y - cell && copy.y + box.ymin > y - (rows - 1) * cell);
    });
  }

  /** Colours; those beside free cells too, for sums are drawn over them. @param {Int32Array} cells @param {number[]} names */
  drawFree(cells, names) {
    const { columns, rows } = this.raster, { image, pixels, context } = prepared(this.free, columns, rows);
    const colours = names.map((name) => this.pixelOf(name)), n = cells.length;
    for (let cell = 0; cell < n; ++cell) {
      let component = cells[cell];
      if (component < 0 && cell > 0) component = cells[cell - 1];
      if (component < 0 && cell + 1 < n) component = cells[cell + 1];
      if (component < 0 && cell >= columns) component = cells[cell - columns];
      if (component < 0 && cell + columns < n) component = cells[cell + columns];
      if (component >= 0) pixels[cell] = colours[component];
    }
    context.putImageData(image, 0, 0);
  }

  /** @param {number[]} seams cells */
  drawSeams(seams) {
    const { columns, rows } = this.raster, { image, pixels, context } = prepared(this.seams, columns, rows);
    const fill = pixelOf(colour("tight"));
    for (const cell of seams) pixels[cell] = fill;
    context.putImageData(image, 0, 0);
  }

  /** @param {number} name */
  pixelOf(name) {
    const known = this.palette.get(name);
    if (known !== undefined) return known;
    const made = pixelOf(fillOf(name));
    this.palette.set(name, made);
    return made;
  }

  recolour() { this.palette.clear(); }

  /** The name of the component at a pixel of the picture; -1 where there is none. @param {number} x @param {number} y */
  nameAt(x, y) {
    const { columns, rows } = this.raster, column = Math.floor(x / this.side), row = Math.floor(y / this.side);
    if (column < 0 || row < 0 || column >= columns || row >= rows || !this.names.last) return -1;
    const component = this.names.last.components.cells[row * columns + column];
    return component < 0 ? -1 : this.names.last.names[component];
  }
}

/** @param {number} name of a component; 0 is the outside */
export const fillOf = (name) => (name === 0 ? colour("outside") : holeFill(name));

/** A canvas of an image without colours, its pixels as numbers. @param {HTMLCanvasElement} canvas @param {number} columns @param {number} rows */
function prepared(canvas, columns, rows) {
  if (canvas.width !== columns || canvas.height !== rows) { canvas.width = columns; canvas.height = rows; }
  const context = contextOf(canvas), image = context.createImageData(columns, rows);
  return { context, image, pixels: new Uint32Array(image.data.buffer) };
}

/** A colour of the style as a pixel, in the bytes' order of this machine. @param {string} fill */
function pixelOf(fill) {
  const canvas = document.createElement("canvas");
  canvas.width = canvas.height = 1;
  const context = contextOf(canvas);
  context.fillStyle = fill;
  context.fillRect(0, 0, 1, 1);
  return new Uint32Array(context.getImageData(0, 0, 1, 1).data.buffer)[0];
}
