// The sum at one radius: P, the boundary with its arcs, the holes, the diagram.
const drawing = {
  canvas: element("sum"),
  view: { x: 0, y: 0, unit: 1 },
  holes: [],  // {id, path} in screen coordinates

  // The box of P, moved outwards by the radius.
  box(radius) {
    const box = new Box();
    if (!boxOfP.empty) {
      box.add(boxOfP.xmin - radius, boxOfP.ymin - radius);
      box.add(boxOfP.xmax + radius, boxOfP.ymax + radius);
    }
    return box;
  },

  fit(radius) { this.view = fitted(this.box(radius), this.canvas.clientWidth, this.canvas.clientHeight, 26); },

  draw(radius, gap, marked, chosen) {
    const { context, width, height } = prepared(this.canvas);
    const [X, Y] = toScreen(this.view, width, height);
    const sum = new Path2D(), holes = new Map();
    for (const ring of boundary.at(gap)) {
      const path = this.ringPath(piecesOf(ring, radius), radius * this.view.unit, X, Y);
      sum.addPath(path);
      if (ring.hole) (holes.get(ring.hole) ?? holes.set(ring.hole, new Path2D()).get(ring.hole)).addPath(path);
    }
    const isDimmed = chosen?.feature === "h" && holes.has(chosen.id);
    for (const [id, path] of holes) {
      context.globalAlpha = isDimmed && id !== chosen.id ? 0.35 : 1;
      context.fillStyle = holeFill(id);
      context.fill(path, "evenodd");
    }
    context.globalAlpha = 1;
    this.paint(context, sum, "sum", 1.1);
    this.paint(context, this.pathOfP(X, Y), "P", 1);
    if (element("show-diagram").checked) this.drawDiagram(context, X, Y);
    if (isDimmed) {
      context.strokeStyle = colour("ink");
      context.lineWidth = 2.4;
      context.stroke(holes.get(chosen.id));
    }
    drawPassages(context, passagesHere(), X, Y);
    marked.forEach((event) => this.drawPlace(context, event, X, Y));
    if (chosen?.feature === "e") this.drawEvent(context, chosen.id, X, Y);
    if (!boxOfP.empty) drawRuler(context, this.view.unit, height);
    else this.drawEmpty(context, width, height);
    this.holes = [...holes].map(([id, path]) => ({ id, path }));
  },

  // Upwards on the screen is downwards in its numbers: arcs turn the other way.
  ringPath(pieces, radius, X, Y) {
    const path = new Path2D();
    pieces.forEach((piece, i) => {
      const { centre, from, to } = piece;
      if (!i) path.moveTo(X(from[0]), Y(from[1]));
      const { start, turn } = centre ? turnOf(piece) : { turn: 0 };
      if (turn > 0) path.arc(X(centre[0]), Y(centre[1]), radius, -start, -start - turn, true);
      path.lineTo(X(to[0]), Y(to[1]));
    });
    path.closePath();
    return path;
  },

  pathOfP(X, Y) {
    const path = new Path2D();
    for (const { firstSide, endSide } of walks) {
      for (let side = firstSide; side < endSide; ++side) {
        const [x, y] = data.features[sides[side].from];
        if (side === firstSide) path.moveTo(X(x), Y(y)); else path.lineTo(X(x), Y(y));
      }
      path.closePath();
    }
    if (data.point) path.arc(X(data.point[0]), Y(data.point[1]), 1.5, 0, 2 * Math.PI);
    return path;
  },

  paint(context, path, name, width) {
    context.fillStyle = colour(name);
    context.fill(path, "evenodd");
    context.strokeStyle = colour(`${name}-line`);
    context.lineWidth = width;
    context.stroke(path);
  },

  drawDiagram(context, X, Y) {
    const size = Math.max(boxOfP.across, boxOfP.up), far = Math.max(3 * size, 2 * windowLast);
    context.beginPath();
    for (const { from, to, bend } of skeletonParts(far)) {
      context.moveTo(X(from[0]), Y(from[1]));
      if (bend) context.quadraticCurveTo(X(bend[0]), Y(bend[1]), X(to[0]), Y(to[1]));
      else context.lineTo(X(to[0]), Y(to[1]));
    }
    context.strokeStyle = colour("diagram");
    context.lineWidth = halves.length > 8000 ? 0.6 : 1;
    context.stroke();
  },

  drawPlace(context, event, X, Y) {
    for (const [radius, name] of [[6.5, "panel"], [5, "death"]]) {
      context.beginPath();
      context.arc(X(data.places[2 * event]), Y(data.places[2 * event + 1]), radius, 0, 2 * Math.PI);
      context.strokeStyle = colour(name);
      context.lineWidth = 1.8;
      context.stroke();
    }
  },

  // Its empty disc, and its features.
  drawEvent(context, event, X, Y) {
    const [x, y] = data.places.slice(2 * event, 2 * event + 2);
    context.strokeStyle = context.fillStyle = colour("death");
    context.lineWidth = 1.2;
    context.setLineDash([5, 4]);
    context.beginPath();
    context.arc(X(x), Y(y), data.radii[radiusOf(event)] * this.view.unit, 0, 2 * Math.PI);
    context.stroke();
    context.setLineDash([]);
    for (const number of data.near[event]) {
      context.beginPath();
      if (data.features[number].length === 2) {
        const [px, py] = data.features[number];
        context.arc(X(px), Y(py), 4.5, 0, 2 * Math.PI);
        context.fill();
        continue;
      }
      const [, , , , line = number] = data.features[number];
      const [from, to] = sideBefore(line, x, y);
      context.moveTo(X(from[0]), Y(from[1]));
      context.lineTo(X(to[0]), Y(to[1]));
      context.lineWidth = 4;
      context.stroke();
    }
    this.drawPlace(context, event, X, Y);
  },

  drawEmpty(context, width, height) {
    context.fillStyle = colour("soft");
    context.font = "16px system-ui, 'DejaVu Sans', sans-serif";
    context.textAlign = "center";
    context.fillText("The sum is empty at every radius.", width / 2, height / 2);
    context.textAlign = "start";
  },

  // The hole at a pixel of the canvas, or null.
  holeAt(x, y) {
    const ratio = devicePixelRatio || 1, context = this.canvas.getContext("2d");
    const found = this.holes.filter(({ path }) => context.isPointInPath(path, x * ratio, y * ratio, "evenodd"));
    return found.length ? found[found.length - 1].id : null;
  },
};

// The ends of the edge of a line that is nearest to a place.
function sideBefore(line, x, y) {
  let best = null, least = Infinity;
  for (const { feature, from, to } of sides) {
    if (feature !== line) continue;
    const [p, q] = [data.features[from], data.features[to]], dx = q[0] - p[0], dy = q[1] - p[1];
    const share = Math.min(Math.max(((x - p[0]) * dx + (y - p[1]) * dy) / (dx * dx + dy * dy), 0), 1);
    const distance = Math.hypot(x - p[0] - share * dx, y - p[1] - share * dy);
    if (distance < least) { best = [p, q]; least = distance; }
  }
  return best;
}
