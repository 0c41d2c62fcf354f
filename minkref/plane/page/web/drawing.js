// The sum at one scale, with its holes and the convolution.
const flat = (operand) => operand.flat(1);  // rings: outer, holes, outer, ...
const verticesOf = (operand) => flat(operand).flat();
const vertices = { P: verticesOf(data.P), Q: verticesOf(data.Q) };

// The number of the next vertex along its ring.
function followers(operand) {
  const next = [];
  for (const ring of flat(operand)) {
    const first = next.length, n = ring.length / 2;
    for (let i = 0; i < n; ++i) next.push(first + ((i + 1) % n));
  }
  return next;
}
const followerOf = { P: followers(data.P), Q: followers(data.Q) };

const drawing = {
  canvas: element("sum"),
  view: { x: 0, y: 0, unit: 1 },
  holes: [],   // {id, path} in screen coordinates
  place: null, // of the chosen event

  box(s) {
    const box = new Box();
    for (const { isHole, vertices: ring } of timeline.at(s).values()) {
      if (!isHole) for (const track of ring) box.add(xOf(track, s), yOf(track, s));
    }
    paper.widen(box, s);
    return box;
  },

  fit(s) { this.view = fitted(this.box(s), this.canvas.clientWidth, this.canvas.clientHeight, 26); },

  draw(s, chosen) {
    const { context, width, height } = prepared(this.canvas);
    const [X, Y] = toScreen(this.view, width, height);
    const components = new Map(), holes = new Map();
    const pathIn = (map, id) => map.get(id) ?? map.set(id, new Path2D()).get(id);
    for (const ring of timeline.at(s).values()) {
      const path = new Path2D();
      ring.vertices.forEach((track, i) => {
        const x = X(xOf(track, s)), y = Y(yOf(track, s));
        if (i) path.lineTo(x, y); else path.moveTo(x, y);
      });
      path.closePath();
      pathIn(components, ring.component).addPath(path);
      if (ring.isHole) pathIn(holes, ring.hole).addPath(path);
    }
    const dimmed = chosen && chosen.feature === "h" && holes.has(chosen.id);
    for (const [id, path] of holes) {
      context.globalAlpha = dimmed && id !== chosen.id ? 0.35 : 1;
      context.fillStyle = holeFill(id);
      context.fill(path);
    }
    context.globalAlpha = 1;
    for (const [id, path] of components) {  // over the holes: what lies inside of a hole shows
      context.fillStyle = colour("sum");
      context.fill(path, "evenodd");
      context.strokeStyle = colour("sum-line");
      context.lineWidth = chosen && chosen.feature === "c" && chosen.id === id ? 3 : 1.1;
      context.stroke(path);
    }
    paper.draw(context, s, X, Y);
    for (const kind of ["T", "S"]) if (element(`show-${kind}`).checked) this.drawEdges(context, kind, s, X, Y);
    if (dimmed) {
      context.strokeStyle = colour("ink");
      context.lineWidth = 2.4;
      context.stroke(holes.get(chosen.id));
    }
    drawPassages(context, passagesHere(), X, Y);
    if (this.place) this.drawPlace(context, X(this.place[0]), Y(this.place[1]));
    if (components.size) drawRuler(context, this.view.unit, height);
    else this.drawEmpty(context, width, height);
    this.holes = [...holes].map(([id, path]) => ({ id, path }));
  },

  drawEdges(context, kind, s, X, Y) {
    const list = data[kind];
    const [own, other] = kind === "S" ? ["P", "Q"] : ["Q", "P"];
    const [of, at] = kind === "S" ? [s, 1] : [1, s];
    const edges = vertices[own], points = vertices[other], next = followerOf[own];
    context.beginPath();
    for (let i = 0; i < list.length; i += 2) {
      const a = 2 * list[i], b = 2 * next[list[i]], p = 2 * list[i + 1];
      const x = at * points[p], y = at * points[p + 1];
      context.moveTo(X(of * edges[a] + x), Y(of * edges[a + 1] + y));
      context.lineTo(X(of * edges[b] + x), Y(of * edges[b + 1] + y));
    }
    context.strokeStyle = colour(kind);
    context.lineWidth = list.length > 4000 ? 0.5 : 0.9;
    context.stroke();
  },

  drawPlace(context, x, y) {
    context.lineWidth = 2;
    for (const [radius, name] of [[9, "panel"], [7, "death"]]) {
      context.beginPath();
      context.arc(x, y, radius, 0, 2 * Math.PI);
      context.strokeStyle = colour(name);
      context.stroke();
    }
  },

  drawEmpty(context, width, height) {
    context.fillStyle = colour("soft");
    context.font = "16px system-ui, 'DejaVu Sans', sans-serif";
    context.textAlign = "center";
    context.fillText("The sum is empty at every scale.", width / 2, height / 2);
    context.textAlign = "start";
  },

  // The hole at a pixel of the canvas, or null.
  holeAt(x, y) {
    const ratio = devicePixelRatio || 1, context = this.canvas.getContext("2d");
    const found = this.holes.filter(({ path }) => context.isPointInPath(path, x * ratio, y * ratio));
    return found.length ? found[found.length - 1].id : null;
  },
};
