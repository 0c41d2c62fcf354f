// The strip over the slider: a mark for each boundary event, taller ones where the topology changes.
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
    const mark = (event, top) => `M${this.x(data.about[event]).toFixed(2)} ${top}V46`;
    const paths = [svg("path", {
      id: "marks", fill: "none", stroke: colour("mark"), "stroke-width": 1,
      "stroke-opacity": data.about.length > 2 * inner ? 0.35 : 0.8,
      d: data.about.map((_, event) => mark(event, 30)).join(""),
    })];
    for (const change of ["touch", "split", "merge", "death", "birth"]) {
      const events = data.topology.filter((row) => row[2] === change).map((row) => row[0]);
      paths.push(svg("path", {
        fill: "none", stroke: colour(change), "stroke-width": 1.4,
        "stroke-opacity": events.length > inner / 3 ? 0.55 : 0.95,
        d: events.map((event) => mark(event, 12)).join(""),
      }));
    }
    this.svg.replaceChildren(axisTicks(stripMargin, inner, 46, 51, 63), ...paths, ...paper.bars((s) => this.x(s)), this.cursor);
    this.svg.setAttribute("viewBox", `0 0 ${this.width} 66`);
  },

  show(s) {
    const x = this.x(s);
    this.cursor.setAttribute("x1", x);
    this.cursor.setAttribute("x2", x);
  },

  // The event whose mark is within some pixels of x, the nearest; or -1.
  eventNear(x, pixels) {
    const after = placeAfter(data.about, this.scaleAt(x));
    let best = -1, least = pixels;
    for (const event of [after - 1, after]) {
      if (!isInside(event)) continue;
      const distance = Math.abs(this.x(data.about[event]) - x);
      if (distance <= least) { best = event; least = distance; }
    }
    return best;
  },
};
