// @ts-check
// The strip over the slider: a mark for each event, in groups, the taller ones where the topology changes.
import { axisTicks } from "./axis.js";
import { colour } from "./colours.js";
import { element, placeIn, tip } from "./elements.js";
import { placeAfter, short } from "./numbers.js";
import { set, svg } from "./svg.js";

/** @typedef {{ id: string, name: string, isTall: boolean, scales: number[] }} Group marks of one colour, which `name` is */
/**
 * @typedef {object} Marks what a page has on its strip
 * @property {string} letter of the scale
 * @property {import("./axis.js").Axis} axis
 * @property {number[]} scales of the events, ascending
 * @property {(event: number) => boolean} isInside the window
 * @property {() => Group[]} groups
 * @property {(x: (s: number) => number) => Element[]} [bars]
 * @property {(event: number) => string} tell
 * @property {(event: number) => void} go
 * @property {(s: number) => void} moveTo
 */

const MARGIN = 8;  // half of the slider's thumb

export class Strip {
  /** @param {Marks} marks */
  constructor(marks) {
    this.marks = marks;
    this.svg = element("strip", SVGSVGElement);
    this.cursor = svg("line", { class: "cursor", y1: 2, y2: 52 });
    this.width = 1;
    this.listen();
  }

  /** @param {number} s */
  x(s) { return MARGIN + (this.width - 2 * MARGIN) * this.marks.axis.shareOf(s); }
  /** @param {number} x */
  scaleAt(x) { return this.marks.axis.scaleAt((x - MARGIN) / (this.width - 2 * MARGIN)); }

  draw() {
    this.width = Math.max(this.svg.clientWidth, 60);
    const inner = this.width - 2 * MARGIN, { axis, groups, bars } = this.marks;
    const paths = groups().map(({ id, name, isTall, scales }) => svg("path", {
      id, fill: "none", stroke: colour(name), "stroke-width": isTall ? 1.4 : 1,
      "stroke-opacity": isTall ? (scales.length > inner / 3 ? 0.55 : 0.95) : (scales.length > 2 * inner ? 0.35 : 0.8),
      d: scales.map((s) => `M${this.x(axis.clamp(s)).toFixed(2)} ${isTall ? 12 : 30}V46`).join(""),
    }));
    const more = bars?.((s) => this.x(s)) ?? [];
    this.svg.replaceChildren(axisTicks(axis, MARGIN, inner, 46, 51, 63), ...paths, ...more, this.cursor);
    set(this.svg, { viewBox: `0 0 ${this.width} 66` });
  }

  /** @param {number} s */
  show(s) { set(this.cursor, { x1: this.x(s), x2: this.x(s) }); }

  /**
   * The event, by the number of its scale, whose mark is within some pixels of x, the nearest; or -1.
   * @param {number} x
   * @param {number} pixels
   */
  eventNear(x, pixels) {
    const { scales, isInside } = this.marks, after = placeAfter(scales, this.scaleAt(x));
    let best = -1, least = pixels;
    for (const event of [after - 1, after]) {
      if (!isInside(event)) continue;
      const distance = Math.abs(this.x(scales[event]) - x);
      if (distance <= least) { best = event; least = distance; }
    }
    return best;
  }

  listen() {
    const { letter, tell, go, moveTo } = this.marks;
    let isDragged = false;
    this.svg.addEventListener("pointerdown", (event) => {
      isDragged = false;
      this.svg.setPointerCapture(event.pointerId);
      const [x] = placeIn(event, this.svg), near = this.eventNear(x, 4);
      if (near >= 0) go(near); else moveTo(this.scaleAt(x));
    });
    this.svg.addEventListener("pointermove", (event) => {
      const [x] = placeIn(event, this.svg);
      if (event.buttons & 1) {
        if (Math.abs(event.movementX) > 0) isDragged = true;
        if (isDragged) moveTo(this.scaleAt(x));
        return;
      }
      const near = this.eventNear(x, 4);
      tip(near < 0 ? `${letter} = ${short(this.scaleAt(x), 4)}` : tell(near), event);
    });
    this.svg.addEventListener("pointerleave", () => tip(""));
  }
}
