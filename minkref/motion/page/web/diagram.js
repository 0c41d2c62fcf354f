// The diagram: places of the path across, scales upwards, bad polygons filled. A scale is valid if its line meets none.
const MOST_OUTLINES = 4000;  // polygons that are outlined, too
const MOST_CORNERS = 300;    // of the path that have a line

const diagram = {
  canvas: element("diagram"),
  svg: element("diagram-axes"),
  margin: { left: 58, right: 12, top: 10, bottom: 24 },
  width: 1,
  height: 1,

  x(share) { return this.margin.left + share * (this.width - this.margin.left - this.margin.right); },
  y(s) { return this.height - this.margin.bottom - shareOfScale(s) * (this.height - this.margin.top - this.margin.bottom); },
  shareAt(x) { return Math.min(Math.max((x - this.margin.left) / (this.width - this.margin.left - this.margin.right), 0), 1); },
  scaleAt(y) { return scaleAt(Math.min(Math.max((this.height - this.margin.bottom - y) / (this.height - this.margin.top - this.margin.bottom), 0), 1)); },

  // A path of one place has no places across: its polygons are bands.
  pathOf({ segment, points, least, greatest }) {
    const path = new Path2D();
    if (isOnePlace) {
      path.rect(this.x(0), this.y(greatest), this.x(1) - this.x(0), this.y(least) - this.y(greatest));
      return path;
    }
    if (!hasLength(segment)) return path;
    points.forEach(([t, s], i) => {
      const at = [this.x(shareOfPlace(segment, t)), this.y(s)];
      if (i) path.lineTo(...at); else path.moveTo(...at);
    });
    path.closePath();
    return path;
  },

  // All that stays where it is.
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
    this.svg.setAttribute("viewBox", `0 0 ${width} ${height}`);
    this.crossing = [svg("line", { class: "cursor" }), svg("line", { class: "cursor" })];
    this.hand = svg("circle", { class: "hand", r: 4.5 });
    this.here = svg("path", { fill: "none", stroke: colour("ink"), "stroke-width": 1.6 });
    this.marks = data.bounds.map((bound, i) => this.mark(bound, i, choose));
    this.svg.replaceChildren(this.axes(), ...this.ranges(), this.here, ...this.crossing, ...this.marks, this.hand);
  },

  axes() {
    const group = svg("g", { class: "axis" }), [left, right] = [this.x(0), this.x(1)];
    for (const s of roundNumbers(windowFirst, windowLast)) {
      const y = this.y(s), text = svg("text", { x: left - 12, y: y + 4, "text-anchor": "end" });
      text.textContent = short(s);
      group.append(svg("line", { x1: left - 9, x2: left - 5, y1: y, y2: y }), text);
    }
    const bottom = this.y(windowFirst);
    group.append(svg("path", { d: `M${left} ${this.margin.top}V${bottom}H${right}V${this.margin.top}Z` }));
    if (isOnePlace) {
      const text = svg("text", { x: (left + right) / 2, y: bottom + 16, "text-anchor": "middle" });
      text.textContent = "one place";
      group.append(text);
      return group;
    }
    let taken = -Infinity;
    reached.forEach((share, k) => {
      const x = this.x(share);
      if (reached.length <= MOST_CORNERS) group.append(svg("line", { class: "vertex", x1: x, x2: x, y1: this.margin.top, y2: bottom }));
      if (x < taken) return;
      const text = svg("text", { x, y: bottom + 16, "text-anchor": "middle" });
      text.textContent = String(k);
      group.append(text);
      taken = x + 7 * String(k).length + 10;
    });
    return group;
  },

  // Valid scales: a bar beside the axis and a pale band; of a single scale a line.
  ranges() {
    const [left, right] = [this.x(0), this.x(1)], made = [];
    for (const range of data.valid) {
      const low = range.about[0], high = range.about[1] ?? windowLast;
      if (high < windowFirst || low > windowLast) continue;
      const top = this.y(clampScale(high)), bottom = this.y(clampScale(low));
      const shape = low === high
        ? [svg("line", { class: "alone", x1: left - 8, x2: right, y1: top, y2: top })]
        : [svg("rect", { class: "range", x: left - 6, width: 4, y: top, height: Math.max(bottom - top, 1) }),
          svg("rect", { class: "band", x: left, width: right - left, y: top, height: bottom - top })];
      const group = svg("g", { class: "valid-range" }, ...shape), title = svg("title");
      title.textContent = rangeText(range);
      group.append(title);
      made.push(group);
    }
    return made;
  },

  mark(bound, i, choose) {
    const { scale: s, t } = bound.about;
    const circle = svg("circle", { class: "bound", r: 4.5, cx: this.x(isOnePlace ? 0.5 : shareOfPlace(bound.at.segment, t)), cy: this.y(clampScale(s)) });
    if (s < windowFirst || s > windowLast) circle.setAttribute("visibility", "hidden");
    circle.addEventListener("pointerdown", (event) => { event.stopPropagation(); choose(i); });
    circle.addEventListener("pointermove", (event) => { event.stopPropagation(); tip(`${cut(bound.scale)} ${bound.event}: ${featureText(bound.part)}, ${featureText(bound.obstacle)}`, event); });
    circle.addEventListener("pointerleave", () => tip(""));
    return circle;
  },

  // Where the page stands.
  show(share, s, collision, bound) {
    const x = this.x(isOnePlace ? 0.5 : share), y = this.y(s), [across, up] = this.crossing;
    for (const [key, value] of Object.entries({ x1: this.x(0), x2: this.x(1), y1: y, y2: y })) across.setAttribute(key, value);
    for (const [key, value] of Object.entries({ x1: x, x2: x, y1: this.margin.top, y2: this.y(windowFirst) })) up.setAttribute(key, value);
    this.hand.setAttribute("cx", x);
    this.hand.setAttribute("cy", y);
    this.here.setAttribute("d", collision ? this.outline(collision) : "");
    this.marks.forEach((mark, i) => mark.classList.toggle("here", i === bound));
  },

  outline({ segment, points, least, greatest }) {
    if (isOnePlace) return `M${this.x(0)} ${this.y(least)}H${this.x(1)}V${this.y(greatest)}H${this.x(0)}Z`;
    return `M${points.map(([t, s]) => `${this.x(shareOfPlace(segment, t))} ${this.y(s)}`).join("L")}Z`;
  },

  listen(move) {
    const at = (event) => {
      const box = this.svg.getBoundingClientRect();
      return [this.shareAt(event.clientX - box.left), this.scaleAt(event.clientY - box.top)];
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
