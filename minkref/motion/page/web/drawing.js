// The part at a place and a scale among the obstacles, what collides, and the contact of a bound.
const ringsOf = (operand) => operand.flat(1);

function boxOf(rings, factor = 1, x = 0, y = 0, box = new Box()) {
  for (const ring of rings) for (let i = 0; i < ring.length; i += 2) box.add(x + factor * ring[i], y + factor * ring[i + 1]);
  return box;
}

const drawing = {
  canvas: element("picture"),
  view: { x: 0, y: 0, unit: 1 },

  box(place, s) {
    const box = boxOf(ringsOf(data.obstacles));
    boxOf([data.path], 1, 0, 0, box);
    return boxOf(ringsOf(data.part), s, place.x, place.y, box);
  },

  fit(place, s) { this.view = fitted(this.box(place, s), this.canvas.clientWidth, this.canvas.clientHeight, 26); },

  draw(place, s, collision, bound) {
    const { context, width, height } = prepared(this.canvas);
    const [X, Y] = toScreen(this.view, width, height);
    const atPlace = [(x) => X(place.x + x), (y) => Y(place.y + y)];
    const obstacles = this.path(data.obstacles, 1, X, Y), part = this.path(data.part, s, ...atPlace);
    this.paint(context, obstacles, "Q");
    this.drawWay(context, X, Y);
    this.paint(context, part, "P");
    context.save();
    context.clip(part, "evenodd");
    context.fillStyle = colour("overlap");
    context.fill(obstacles, "evenodd");
    context.restore();
    if (collision && element("show-pieces").checked) {
      this.outline(context, data.pieces.obstacles[collision.obstacle], 1, X, Y);
      this.outline(context, data.pieces.part[collision.part], s, ...atPlace);
    }
    this.dot(context, X(place.x), Y(place.y), 3.5, "way");
    if (bound) this.drawContact(context, bound, s, X, Y, atPlace);
    drawRuler(context, this.view.unit, height);
  },

  path(operand, factor, X, Y) {
    const path = new Path2D();
    for (const ring of ringsOf(operand)) addRing(path, ring, factor, X, Y);
    return path;
  },

  paint(context, path, name) {
    context.fillStyle = colour(name);
    context.fill(path, "evenodd");
    context.strokeStyle = colour(`${name}-line`);
    context.lineWidth = 1;
    context.stroke(path);
  },

  drawWay(context, X, Y) {
    context.beginPath();
    corners.forEach(([x, y], i) => { if (i) context.lineTo(X(x), Y(y)); else context.moveTo(X(x), Y(y)); });
    context.strokeStyle = colour("way");
    context.lineWidth = 1.4;
    context.stroke();
    for (const [x, y] of corners.length > 400 ? [corners[0], corners[corners.length - 1]] : corners) this.dot(context, X(x), Y(y), 1.8, "way");
  },

  dot(context, x, y, radius, name) {
    context.beginPath();
    context.arc(x, y, radius, 0, 2 * Math.PI);
    context.fillStyle = colour(name);
    context.fill();
  },

  outline(context, numbers, factor, X, Y) {
    const path = new Path2D();
    addRing(path, numbers, factor, X, Y);
    context.strokeStyle = colour("ink");
    context.lineWidth = 1.6;
    context.setLineDash([5, 3]);
    context.stroke(path);
    context.setLineDash([]);
  },

  // Both features, thick, and where they touch.
  drawContact(context, bound, s, X, Y, atPlace) {
    for (const [feature, operand, factor, axes] of [
      [bound.obstacle, data.obstacles, 1, [X, Y]], [bound.part, data.part, s, atPlace],
    ]) {
      const [kind, [ring, index]] = Object.entries(feature)[0], numbers = ringsOf(operand)[ring];
      if (kind !== "edge") continue;
      const next = (2 * index + 2) % numbers.length;
      context.beginPath();
      context.moveTo(axes[0](factor * numbers[2 * index]), axes[1](factor * numbers[2 * index + 1]));
      context.lineTo(axes[0](factor * numbers[next]), axes[1](factor * numbers[next + 1]));
      context.strokeStyle = colour("overlap");
      context.lineWidth = 3;
      context.stroke();
    }
    const [x, y] = bound.about.touching;
    this.dot(context, X(x), Y(y), 6, "panel");
    this.dot(context, X(x), Y(y), 4.5, "overlap");
  },
};
