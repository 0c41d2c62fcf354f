// The strip over the slider: a mark for each event, taller ones where holes and components may change.
const stripMargin = 8;  // half of the slider's thumb
const kindColours = { s: "birth", r: "touch", m: "death" };

const strip = {
  svg: element("strip"),
  cursor: svg("line", { class: "cursor", y1: 2, y2: 52 }),
  width: 1,

  x(s) { return stripMargin + (this.width - 2 * stripMargin) * shareOf(s); },
  scaleAt(x) { return scaleAt((x - stripMargin) / (this.width - 2 * stripMargin)); },

  draw() {
    this.width = Math.max(this.svg.clientWidth, 60);
    const inner = this.width - 2 * stripMargin;
    const mark = (event, top) => `M${this.x(clampScale(data.radii[radiusOf(event)])).toFixed(2)} ${top}V46`;
    const events = [];
    for (let event = 0; event < eventCount; ++event) if (isInside(radiusOf(event))) events.push(event);
    const paths = [svg("path", {
      id: "marks", fill: "none", stroke: colour("mark"), "stroke-width": 1,
      "stroke-opacity": events.length > 2 * inner ? 0.35 : 0.8,
      d: events.map((event) => mark(event, 30)).join(""),
    })];
    for (const kind of ["r", "m", "s"]) {
      const own = events.filter((event) => data.kinds[event] === kind);
      paths.push(svg("path", {
        id: `marks-${kindNames[kind]}`, fill: "none", stroke: colour(kindColours[kind]), "stroke-width": 1.4,
        "stroke-opacity": own.length > inner / 3 ? 0.55 : 0.95,
        d: own.map((event) => mark(event, 12)).join(""),
      }));
    }
    this.svg.replaceChildren(axisTicks(stripMargin, inner, 46, 51, 63), ...paths, this.cursor);
    this.svg.setAttribute("viewBox", `0 0 ${this.width} 66`);
  },

  show(s) {
    const x = this.x(s);
    this.cursor.setAttribute("x1", x);
    this.cursor.setAttribute("x2", x);
  },

  // The radius of an event whose mark is within some pixels of x, the nearest; or -1.
  eventNear(x, pixels) {
    const after = placeAfter(data.radii, this.scaleAt(x));
    let best = -1, least = pixels;
    for (const event of [after - 1, after]) {
      if (!isInside(event)) continue;
      const distance = Math.abs(this.x(data.radii[event]) - x);
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
      if (near >= 0) goToRadius(near); else moveTo(this.scaleAt(x(event)));
    });
    this.svg.addEventListener("pointermove", (event) => {
      if (event.buttons & 1) {
        if (Math.abs(event.movementX) > 0) dragged = true;
        if (dragged) moveTo(this.scaleAt(x(event)));
        return;
      }
      const near = this.eventNear(x(event), 4);
      tip(near < 0 ? `ρ = ${short(this.scaleAt(x(event)), 4)}` : `radius ${radiusText(near)}: ${kindsAt(near)}`, event);
    });
    this.svg.addEventListener("pointerleave", () => tip(""));
  },
};
