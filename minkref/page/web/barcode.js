// @ts-check
// A bar for each hole from birth to death; for components too if there is ever more than one.
import { axisTicks } from "./axis.js";
import { colour, featureFill } from "./colours.js";
import { element, revealIn, tip } from "./elements.js";
import { clamped } from "./numbers.js";
import { set, svg } from "./svg.js";

/** @typedef {import("./picture.js").Chosen} Chosen */
/** @typedef {[number, number]} Life the events of birth and death, which may be outside of the window */
/** @typedef {{ h: (Life | null)[], c: (Life | null)[], f?: (Life | null)[] }} Lives of holes, components, concave features, by number; null: not in the window */
/**
 * @typedef {object} Features what has a life on a page
 * @property {import("./axis.js").Axis} axis
 * @property {number[]} scales of the events
 * @property {(event: number) => boolean} isInside the window
 * @property {Lives} lives
 * @property {(feature: string, id: number) => string} describe
 * @property {(feature: string, id: number) => void} choose
 * @property {(id: number | null) => void} [point] at a bar, or at none
 * @property {string} [none] what is said where there is no bar
 */

const LEFT = 34, RIGHT = 10;

export class Barcode {
  /** @param {Features} features */
  constructor(features) {
    this.features = features;
    this.rows = rowsOf(features.lives);
    this.cursor = svg("line", { class: "cursor" });
    this.axisCursor = svg("line", { class: "cursor", y1: 13, y2: 18 });
    this.width = 1;
  }

  get hasComponents() { return this.rows.some((row) => row.feature === "c"); }

  /** @param {number} s */
  x(s) { return LEFT + (this.width - LEFT - RIGHT) * this.features.axis.shareOf(s); }

  draw() {
    const { axis } = this.features;
    const box = element("barcode"), width = Math.max(box.offsetWidth - 16, 120);  // room for a scroll bar
    const count = this.rows.length, step = clamped(300 / Math.max(count, 1), 5, 17), height = Math.max(count * step + 4, 20);
    this.width = width;
    const lines = axis.rounds().map((s) => svg("line", { x1: this.x(s), x2: this.x(s), y1: 0, y2: height }));
    const bars = this.rows.map((row, i) => this.bar(row, 2 + i * step, step));
    set(this.cursor, { y1: 0, y2: height });
    const root = svg("svg", { viewBox: `0 0 ${width} ${height}`, width, height }, svg("g", { class: "axis" }, ...lines), ...bars, this.cursor);
    if (!count) root.append(svg("text", { x: LEFT, y: 14 }, this.features.none ?? "No holes in this window."));
    box.replaceChildren(root);
    const ticks = axisTicks(axis, LEFT, width - LEFT - RIGHT, 13, 18, 10);
    element("barcode-axis").replaceChildren(svg("svg", { viewBox: `0 0 ${width} 18`, width, height: 18 }, ticks, this.axisCursor));
  }

  /**
   * @param {Row} row
   * @param {number} y
   * @param {number} step from bar to bar
   */
  bar(row, y, step) {
    const { scales, isInside, describe, choose, point } = this.features, { feature, id, life: [born, died] } = row;
    const from = isInside(born) ? this.x(scales[born]) : LEFT, to = isInside(died) ? this.x(scales[died]) : this.width - RIGHT;
    const thickness = Math.max(step - (step > 8 ? 4 : 1.5), 3);
    row.bar = svg("rect", {
      x: from, y, width: Math.max(to - from, 2), height: thickness, rx: Math.min(2, thickness / 3), fill: featureFill(feature, id),
    });
    const under = svg("rect", { x: 0, y: y - 1, width: this.width, height: step, fill: "transparent" });
    const group = svg("g", { class: "bar" }, under, row.bar);
    const label = (feature === "c" ? "C" : "") + id;
    if (step >= 11) group.append(svg("text", { x: LEFT - 5, y: y + thickness - 1, "text-anchor": "end" }, label));
    group.addEventListener("pointermove", (event) => { tip(describe(feature, id), event); point?.(id); });
    group.addEventListener("pointerleave", () => { tip(""); point?.(null); });
    group.addEventListener("click", () => choose(feature, id));
    return group;
  }

  /** @param {number} s @param {Chosen | null} chosen */
  show(s, chosen) {
    const x = this.x(s);
    for (const cursor of [this.cursor, this.axisCursor]) set(cursor, { x1: x, x2: x });
    for (const { feature, id, bar } of this.rows) {
      const isHere = feature === chosen?.feature && id === chosen.id;
      set(bar, { stroke: isHere ? colour("ink") : "none", "stroke-width": 1.5, opacity: chosen && !isHere ? 0.5 : 1 });
    }
  }

  /** @param {string} feature @param {number} id */
  reveal(feature, id) {
    const row = this.rows.find((one) => one.feature === feature && one.id === id);
    if (row) revealIn(element("barcode"), row.bar);
  }
}

/** @typedef {{ feature: string, id: number, life: Life, bar: SVGRectElement }} Row */

/** First those of the first birth, the longer ones first; components below. @param {Lives} lives @returns {Row[]} */
function rowsOf({ h, c, f = [] }) {
  /** @type {(feature: string, all: (Life | null)[], first: number) => Row[]} */
  const rows = (feature, all, first) => all
    .flatMap((life, id) => (life && id >= first ? [{ feature, id, life, bar: svg("rect") }] : []))
    .sort((a, b) => a.life[0] - b.life[0] || b.life[1] - a.life[1] || a.id - b.id);
  const components = rows("c", c, 0);
  return [...rows("h", h, 1), ...rows("f", f, 0), ...(components.length > 1 ? components : [])];
}
