// @ts-check
// A picture that is dragged and zoomed, of a sum with its holes.
import { contextOf, fitted, prepared, toScreen } from "./canvas.js";
import { colour, holeFill } from "./colours.js";
import { element, input, placeIn, tip } from "./elements.js";

/** @typedef {import("./canvas.js").Box} Box */
/** @typedef {import("./canvas.js").View} View */
/** @typedef {{ feature: string, id: number }} Chosen a hole ("h") or what else a page has, by its number */
/**
 * @typedef {object} Things what is pointed at in a picture, each with a number
 * @property {(x: number, y: number) => number | null} find at a pixel of the canvas
 * @property {(id: number) => string} tell
 * @property {(id: number) => void} take
 */

export class Picture {
  /** @param {string} id of its canvas */
  constructor(id) {
    this.canvas = element(id, HTMLCanvasElement);
    /** @type {View} */
    this.view = { x: 0, y: 0, unit: 1 };
  }

  /** @param {Box} box */
  fitTo(box) { this.view = fitted(box, this.canvas.clientWidth, this.canvas.clientHeight, 26); }

  /** An empty canvas, with what takes coordinates to it. */
  begin() {
    const { context, width, height } = prepared(this.canvas);
    const [X, Y] = toScreen(this.view, width, height);
    return { context, width, height, X, Y };
  }

  /**
   * Drags and zooms it, and points at things in it.
   * @param {() => void} show
   * @param {Things | null} things
   */
  listen(show, things) {
    const { canvas } = this, find = /** @param {number[]} at */ ([x, y]) => things?.find(x, y) ?? null;
    /** @param {View} view */
    const look = (view) => {
      input("follow").checked = false;
      this.view = view;
      show();
    };
    /** @type {{ x: number, y: number, view: View } | null} */
    let start = null;
    let isMoved = false;
    canvas.addEventListener("pointerdown", (event) => {
      const [x, y] = placeIn(event, canvas);
      start = { x, y, view: this.view };
      isMoved = false;
      canvas.setPointerCapture(event.pointerId);
    });
    canvas.addEventListener("pointermove", (event) => {
      const at = placeIn(event, canvas);
      if (start && event.buttons & 1) {
        const dx = at[0] - start.x, dy = at[1] - start.y, { x, y, unit } = start.view;
        isMoved = isMoved || Math.hypot(dx, dy) > 3;
        if (isMoved) look({ unit, x: x - dx / unit, y: y + dy / unit });
        return;
      }
      const id = find(at);
      canvas.style.cursor = id === null ? "grab" : "pointer";
      tip(id === null || !things ? "" : things.tell(id), event);
    });
    canvas.addEventListener("pointerup", (event) => {
      const id = isMoved ? null : find(placeIn(event, canvas));
      start = null;
      if (id !== null) things?.take(id);
    });
    canvas.addEventListener("pointerleave", () => tip(""));
    canvas.addEventListener("wheel", (event) => {
      event.preventDefault();
      const [x, y] = placeIn(event, canvas), factor = Math.exp(-event.deltaY * 0.0015), { view } = this;
      const dx = x - canvas.clientWidth / 2, dy = y - canvas.clientHeight / 2;
      look({
        unit: view.unit * factor,
        x: view.x + (dx / view.unit) * (1 - 1 / factor),
        y: view.y - (dy / view.unit) * (1 - 1 / factor),
      });
    }, { passive: false });
  }
}

export class PictureWithHoles extends Picture {
  /** @param {string} id @param {CanvasFillRule} rule by which holes are filled and found */
  constructor(id, rule) {
    super(id);
    this.rule = rule;
    /** @type {Map<number, Path2D>} */
    this.holes = new Map();  // on the screen
  }

  /** Fills them, pale if another one is chosen. @param {CanvasRenderingContext2D} context @param {Chosen | null} chosen */
  fillHoles(context, chosen) {
    const one = this.holeOf(chosen);
    for (const [id, path] of this.holes) {
      context.globalAlpha = one && id !== chosen?.id ? 0.35 : 1;
      context.fillStyle = holeFill(id);
      context.fill(path, this.rule);
    }
    context.globalAlpha = 1;
  }

  /** @param {CanvasRenderingContext2D} context @param {Chosen | null} chosen */
  outlineHole(context, chosen) {
    const path = this.holeOf(chosen);
    if (!path) return;
    context.strokeStyle = colour("ink");
    context.lineWidth = 2.4;
    context.stroke(path);
  }

  /** The path of a chosen hole that is there. @param {Chosen | null} chosen */
  holeOf(chosen) { return chosen?.feature === "h" ? this.holes.get(chosen.id) : undefined; }

  /** The hole at a pixel of the canvas, the last one drawn, or null. @param {number} x @param {number} y */
  holeAt(x, y) {
    const ratio = devicePixelRatio || 1, context = contextOf(this.canvas);
    const found = [...this.holes].filter(([, path]) => context.isPointInPath(path, x * ratio, y * ratio, this.rule));
    return found.length ? found[found.length - 1][0] : null;
  }
}
