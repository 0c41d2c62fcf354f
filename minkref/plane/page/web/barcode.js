// A bar for each hole from birth to death; for components too if there is ever more than one.
const barcode = {
  rows: [],  // {feature, id, life, bar}
  cursor: svg("line", { class: "cursor" }),
  axisCursor: svg("line", { class: "cursor" }),
  left: 34,

  x(s, width) { return this.left + (width - this.left - 10) * shareOf(s); },

  // First those of the first birth, the longer ones first; components below.
  collect() {
    const order = (a, b) => a.life[0] - b.life[0] || b.life[1] - a.life[1] || a.id - b.id;
    const of = (feature, first) => lives[feature]
      .map((life, id) => ({ feature, id, life })).slice(first).filter((row) => row.life).sort(order);
    const components = of("c", 0);
    this.rows = [...of("h", 1), ...(components.length > 1 ? components : [])];
  },

  draw(choose) {
    const box = element("barcode"), width = Math.max(box.offsetWidth - 16, 120);  // room for a scroll bar
    const count = this.rows.length, step = Math.min(Math.max(300 / Math.max(count, 1), 5), 17);
    const height = Math.max(count * step + 4, 20), labels = step >= 11;
    const root = svg("svg", { viewBox: `0 0 ${width} ${height}`, width, height });
    const lines = svg("g", { class: "axis" });
    for (const s of roundScales()) {
      const x = this.x(s, width);
      lines.append(svg("line", { x1: x, x2: x, y1: 0, y2: height }));
    }
    root.append(lines);
    this.rows.forEach((row, i) => {
      const [born, died] = row.life, y = 2 + i * step;
      const from = isInside(born) ? this.x(data.about[born], width) : this.left;
      const to = isInside(died) ? this.x(data.about[died], width) : width - 10;
      const group = svg("g", { class: "bar" });
      const thickness = Math.max(step - (step > 8 ? 4 : 1.5), 3);
      row.bar = svg("rect", {
        x: from, y, width: Math.max(to - from, 2), height: thickness, rx: Math.min(2, thickness / 3),
        fill: featureFill(row.feature, row.id),
      });
      group.append(svg("rect", { x: 0, y: y - 1, width, height: step, fill: "transparent" }), row.bar);
      if (labels) {
        const text = svg("text", { x: this.left - 5, y: y + thickness - 1, "text-anchor": "end" });
        text.textContent = (row.feature === "c" ? "C" : "") + row.id;
        group.append(text);
      }
      group.addEventListener("pointermove", (event) => tip(describe(row.feature, row.id), event));
      group.addEventListener("pointerleave", () => tip(""));
      group.addEventListener("click", () => choose(row.feature, row.id));
      root.append(group);
    });
    this.cursor.setAttribute("y1", 0);
    this.cursor.setAttribute("y2", height);
    root.append(this.cursor);
    if (!count) {
      const text = svg("text", { x: this.left, y: 14 });
      text.textContent = "No holes in this window.";
      root.append(text);
    }
    box.replaceChildren(root);
    this.width = width;
    const axis = svg("svg", { viewBox: `0 0 ${width} 18`, width, height: 18 });
    axis.append(axisTicks(this.left, width - this.left - 10, 13, 18, 10), this.axisCursor);
    element("barcode-axis").replaceChildren(axis);
  },

  show(s, chosen) {
    const x = this.x(s, this.width);
    for (const [cursor, top] of [[this.cursor, null], [this.axisCursor, 13]]) {
      cursor.setAttribute("x1", x);
      cursor.setAttribute("x2", x);
      if (top !== null) { cursor.setAttribute("y1", top); cursor.setAttribute("y2", 18); }
    }
    for (const row of this.rows) {
      const here = chosen && row.feature === chosen.feature && row.id === chosen.id;
      row.bar.setAttribute("stroke", here ? colour("ink") : "none");
      row.bar.setAttribute("stroke-width", 1.5);
      row.bar.setAttribute("opacity", chosen && !here ? 0.5 : 1);
    }
  },

  reveal(feature, id) {
    const row = this.rows.find((one) => one.feature === feature && one.id === id);
    if (row) revealIn(element("barcode"), row.bar);
  },
};

function describe(feature, id) {
  const life = lives[feature][id];
  return life ? `${featureName(feature, id)}: ${bornText(life)}, ${diedText(life)}` : featureName(feature, id);
}
