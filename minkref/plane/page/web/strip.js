// The strip over the slider: a mark for each event, in groups, the taller ones where the topology changes. `marks` of
// the page says which there are, at which scales, in words, and what comes of a click.
const stripMargin = 8;  // half of the slider's thumb

const strip = {
  svg: element("strip"),
  cursor: svg("line", { class: "cursor", y1: 2, y2: 52 }),
  width: 1,

  x(s) { return stripMargin + (this.width - 2 * stripMargin) * shareOf(s); },
  scaleAt(x) { return scaleAt((x - stripMargin) / (this.width - 2 * stripMargin)); },

  draw() {
    this.width = Math.max(this.svg.clientWidth, 60);
    const inner = this.width - 2 * stripMargin;
    const paths = marks.groups().map(({ id, name, isTall, scales }) => svg("path", {
      id, fill: "none", stroke: colour(name), "stroke-width": isTall ? 1.4 : 1,
      "stroke-opacity": isTall ? (scales.length > inner / 3 ? 0.55 : 0.95) : (scales.length > 2 * inner ? 0.35 : 0.8),
      d: scales.map((s) => `M${this.x(clampScale(s)).toFixed(2)} ${isTall ? 12 : 30}V46`).join(""),
    }));
    this.svg.replaceChildren(axisTicks(stripMargin, inner, 46, 51, 63), ...paths, ...marks.bars((s) => this.x(s)), this.cursor);
    this.svg.setAttribute("viewBox", `0 0 ${this.width} 66`);
  },

  show(s) {
    const x = this.x(s);
    this.cursor.setAttribute("x1", x);
    this.cursor.setAttribute("x2", x);
  },

  // The event, by the number of its scale, whose mark is within some pixels of x, the nearest; or -1.
  eventNear(x, pixels) {
    const after = placeAfter(marks.scales, this.scaleAt(x));
    let best = -1, least = pixels;
    for (const event of [after - 1, after]) {
      if (!isInside(event)) continue;
      const distance = Math.abs(this.x(marks.scales[event]) - x);
      if (distance <= least) { best = event; least = distance; }
    }
    return best;
  },

  listen() {
    const x = (event) => event.clientX - this.svg.getBoundingClientRect().left;
    let dragged = false;
    this.svg.addEventListener("pointerdown", (event) => {
      dragged = false;
      this.svg.setPointerCapture(event.pointerId);
      const near = this.eventNear(x(event), 4);
      if (near >= 0) marks.go(near); else moveTo(this.scaleAt(x(event)));
    });
    this.svg.addEventListener("pointermove", (event) => {
      if (event.buttons & 1) {
        if (Math.abs(event.movementX) > 0) dragged = true;
        if (dragged) moveTo(this.scaleAt(x(event)));
        return;
      }
      const near = this.eventNear(x(event), 4);
      tip(near < 0 ? `${marks.letter} = ${short(this.scaleAt(x(event)), 4)}` : marks.tell(near), event);
    });
    this.svg.addEventListener("pointerleave", () => tip(""));
  },
};
