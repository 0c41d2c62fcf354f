// The list of bounds, ascending.
const boundList = {
  rows: [],

  fill(choose) {
    this.rows = data.bounds.map((bound, i) => {
      const row = document.createElement("tr");
      const texts = [
        exactAndAbout(cut(bound.scale), bound.about.scale), bound.event, featureText(bound.part), featureText(bound.obstacle),
        `segment ${bound.at.segment}, t = ${short(bound.about.t, 4)}`,
      ];
      row.append(...texts.map((text) => Object.assign(document.createElement("td"), { textContent: text })));
      row.children[1].className = boundColour[bound.event];
      row.addEventListener("click", () => choose(i));
      return row;
    });
    document.querySelector("#events tbody").replaceChildren(...this.rows);
    if (this.rows.length) return;
    const row = document.createElement("tr"), cell = document.createElement("td");
    cell.colSpan = 5;
    cell.textContent = data.valid.length ? "None: all scales are valid." : "None: no scale is valid.";
    row.append(cell);
    document.querySelector("#events tbody").append(row);
  },

  show(bound) {
    this.rows.forEach((row, i) => row.classList.toggle("here", i === bound));
    if (bound >= 0) revealIn(element("events"), this.rows[bound]);
  },
};
