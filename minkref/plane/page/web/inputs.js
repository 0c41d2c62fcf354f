// The two operands in one unit, so that their sizes can be compared.
function drawInputs(s) {
  const canvases = [element("input-P"), element("input-Q")];
  const parts = [[data.P, s, "P"], [data.Q, 1, "Q"]].map(([operand, factor, name]) => {
    const box = new Box();
    for (const ring of flat(operand)) {
      for (let i = 0; i < ring.length; i += 2) box.add(factor * ring[i], factor * ring[i + 1]);
    }
    return { operand, factor, name, box };
  });
  const unit = Math.min(...parts.map(({ box }, i) => fitted(box, canvases[i].clientWidth, canvases[i].clientHeight, 12))
    .filter((_, i) => parts[i].box.across || parts[i].box.up).map((view) => view.unit), Infinity);
  parts.forEach(({ operand, factor, name, box }, i) => {
    const { context, width, height } = prepared(canvases[i]);
    const [X, Y] = toScreen({ x: box.x, y: box.y, unit: Number.isFinite(unit) ? unit : 1 }, width, height);
    context.fillStyle = colour(name);
    context.strokeStyle = colour(`${name}-line`);
    context.lineWidth = 1;
    for (const polygon of operand) {
      const path = new Path2D();
      for (const ring of polygon) addRing(path, ring, factor, X, Y);
      context.fill(path, "evenodd");
      context.stroke(path);
    }
    if (!box.empty && Math.max(box.across, box.up) * (Number.isFinite(unit) ? unit : 1) < 3) {
      context.beginPath();  // a point, or too small to be seen
      context.arc(width / 2, height / 2, 3, 0, 2 * Math.PI);
      context.fill();
      context.stroke();
    }
  });
}
