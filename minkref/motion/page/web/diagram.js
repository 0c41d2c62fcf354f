// @ts-check
// The diagram: places of the path across, scales upwards, bad polygons filled. A scale is valid if its line meets none.
import { prepared } from "../../../page/web/canvas.js";
import { colour } from "../../../page/web/colours.js";
import { element, placeIn, tip } from "../../../page/web/elements.js";
import { clamped, cut, short } from "../../../page/web/numbers.js";
import { set, svg } from "../../../page/web/svg.js";
import { axis, data } from "./data.js";
import { polygons } from "./polygons.js";
import { featureText, placeText, rangeText } from "./texts.js";
import { hasLength, isOnePlace, placeAt, reached, shareOfPlace } from "./way.js";

/** @typedef {import("./polygons.js").Polygon} Polygon */

const MOST_OUTLINES = 4000;  // polygons that are outlined, too
const MOST_CORNERS = 300;    // of the path that have a line

const MARGIN = { left: 58, right: 12, top: 10, bottom: 24 };

export const diagram = {
  canvas: element("diagram", HTMLCanvasElement),
  svg: element("diagram-axes", SVGSVGElement),
  width: 1,
  height: 1,
  across: svg("line", { class: "cursor" }),
  up: svg("line", { class: "cursor" }),
  hand: svg("circle", { class: "hand", r: 4.5 }),
  here: svg("path", { fill: "none", "stroke-width": 1.6 }),
  /** @type {SVGCircleElement[]} */
  marks: [],

  /** @param {number} share */
  x(share) { return MARGIN.left + share * (this.width - MARGIN.left - MARGIN.right); },
  /** @param {number} s */
  y(s) { return this.height - MARGIN.bottom - axis.shareOf(s) * (this.height - MARGIN.top - MARGIN.bottom); },
  /** @param {number} x */
  shareAt(x) { return clamped((x - MARGIN.left) / (this.width - MARGIN.left - MARGIN.right), 0, 1); },
  /** @param {number} y */
  scaleAt(y) { return axis.scaleAt(clamped((this.height - MARGIN.bottom - y) / (this.height - MARGIN.top - MARGIN.bottom), 0, 1)); },

  /** A path of one place has no places across: its polygons are bands. @param {Polygon} polygon */
  pathOf({ segment, points, least, greatest }) {
    const path = new Path2D();
    if (isOnePlace) {
      path.rect(this.x(0), this.y(greatest), this.x(1) - this.x(0), this.y(least) - this.y(greatest));
      return path;
    }
    if (!hasLength(segment)) return path;
    points.forEach(([t, s], i) => {
      const x = this.x(shareOfPlace(segment, t)), y = this.y(s);
      if (i) path.lineTo(x, y); else path.moveTo(x, y);
    });
    path.closePath();
    return path;
  },

  /** All that stays where it is. @param {(bound: number) => void} choose */
  draw(choose) {
    const { context, width, height } = prepared(this.canvas);
    [this.width, this.height] = [width, height];
    context.fillStyle = colour("bad");
    context.strokeStyle = colour("bad-line");
    context.lineWidth = polygons.length > 200 ? 0.25 : 0.6;
    const outlined = polygons.length <= MOST_OUTLINES, all = new Path2D();
    for (const polygon of polygons) {
      const path = this.pathOf(polygon);
      context.fill(path);
      if (outlined || polygon.points.length < 3) all.addPath(path);
    }
    context.stroke(all);
    set(this.svg, { viewBox: `0 0 ${width} ${height}` });
    set(this.here, { stroke: colour("ink") });
    this.marks = data.bounds.map((bound, i) => this.mark(bound, () => choose(i)));
    this.svg.replaceChildren(this.axes(), ...this.ranges(), this.here, this.across, this.up, ...this.marks, this.hand);
  },

  axes() {
    const group = svg("g", { class: "axis" }), [left, right] = [this.x(0), this.x(1)];
    for (const s of axis.rounds()) {
      const y = this.y(s), text = svg("text", { x: left - 12, y: y + 4, "text-anchor": "end" }, short(s));
      group.append(svg("line", { x1: left - 9, x2: left - 5, y1: y, y2: y }), text);
    }
    const bottom = this.y(axis.first);
    group.append(svg("path", { d: `M${left} ${MARGIN.top}V${bottom}H${right}V${MARGIN.top}Z` }));
    /** @param {number} x @param {string} text */
    const label = (x, text) => group.append(svg("text", { x, y: bottom + 16, "text-anchor": "middle" }, text));
    if (isOnePlace) {
      label((left + right) / 2, "one place");
      return group;
    }
    let taken = -Infinity;
    reached.forEach((share, k) => {
      const x = this.x(share);
      if (reached.length <= MOST_CORNERS) group.append(svg("line", { class: "vertex", x1: x, x2: x, y1: MARGIN.top, y2: bottom }));
      if (x < taken) return;
      label(x, String(k));
      taken = x + 7 * String(k).length + 10;
    });
    return group;
  },

  /** Valid scales: a bar beside the axis and a pale band; of a single scale a line. */
  ranges() {
    const [left, right] = [this.x(0), this.x(1)], made = [];
    for (const range of data.valid) {
      const low = range.about[0], high = range.about[1] ?? axis.last;
      if (high < axis.first || low > axis.last) continue;
      const top = this.y(axis.clamp(high)), bottom = this.y(axis.clamp(low));
      const shape = low === high
        ? [svg("line", { class: "alone", x1: left - 8, x2: right, y1: top, y2: top })]
        : [svg("rect", { class: "range", x: left - 6, width: 4, y: top, height: Math.max(bottom - top, 1) }),
          svg("rect", { class: "band", x: left, width: right - left, y: top, height: bottom - top })];
      made.push(svg("g", { class: "valid-range" }, ...shape, svg("title", {}, rangeText(range))));
    }
    return made;
  },

  /** @param {import("./data.js").Bound} bound @param {() => void} choose */
  mark({ scale, event: does, part, obstacle, at, about: { scale: s, t } }, choose) {
    const x = this.x(isOnePlace ? 0.5 : shareOfPlace(at.segment, t));
    const circle = svg("circle", { class: "bound", r: 4.5, cx: x, cy: this.y(axis.clamp(s)) });
    if (!axis.has(s)) set(circle, { visibility: "hidden" });
    circle.addEventListener("pointerdown", (event) => { event.stopPropagation(); choose(); });
    circle.addEventListener("pointermove", (event) => { event.stopPropagation(); tip(`${cut(scale)} ${does}: ${featureText(part)}, ${featureText(obstacle)}`, event); });
    circle.addEventListener("pointerleave", () => tip(""));
    return circle;
  },

  /** Where the page stands. @type {(share: number, s: number, collision: Polygon | null, bound: number) => void} */
  show(share, s, collision, bound) {
    const x = this.x(isOnePlace ? 0.5 : share), y = this.y(s);
    set(this.across, { x1: this.x(0), x2: this.x(1), y1: y, y2: y });
    set(this.up, { x1: x, x2: x, y1: MARGIN.top, y2: this.y(axis.first) });
    set(this.hand, { cx: x, cy: y });
    set(this.here, { d: collision ? this.outline(collision) : "" });
    this.marks.forEach((mark, i) => mark.classList.toggle("here", i === bound));
  },

  /** @param {Polygon} polygon */
  outline({ segment, points, least, greatest }) {
    if (isOnePlace) return `M${this.x(0)} ${this.y(least)}H${this.x(1)}V${this.y(greatest)}H${this.x(0)}Z`;
    return `M${points.map(([t, s]) => `${this.x(shareOfPlace(segment, t))} ${this.y(s)}`).join("L")}Z`;
  },

  /** @param {(share: number, s: number) => void} move */
  listen(move) {
    /** @param {PointerEvent} event */
    const at = (event) => {
      const [x, y] = placeIn(event, this.svg);
      return /** @type {const} */ ([this.shareAt(x), this.scaleAt(y)]);
    };
    this.svg.addEventListener("pointerdown", (event) => {
      this.svg.setPointerCapture(event.pointerId);
      move(...at(event));
    });
    this.svg.addEventListener("pointermove", (event) => {
      const [share, s] = at(event);
      if (event.buttons & 1) { tip(""); move(share, s); return; }
      tip(`s = ${short(s, 4)}, ${placeText(placeAt(share))}`, event);
    });
    this.svg.addEventListener("pointerleave", () => tip(""));
  },
};
