// The list of events in the window; saddles, ridges and maxima, or all of them.
const MOST_ROWS = 2000;

const eventList = {
  rows: [],    // of the table
  events: [],  // of each row

  fill() {
    const body = document.querySelector("#events tbody"), all = element("show-all").checked;
    const wanted = [];
    for (let event = firstEvents[firstInside]; event < firstEvents[endInside]; ++event) {
      if (all || isTopology(event)) wanted.push(event);
    }
    this.events = wanted.slice(0, MOST_ROWS);
    this.rows = this.events.map((event) => {
      const line = document.createElement("tr");
      const does = changes.get(event) ?? [];
      const texts = [radiusText(radiusOf(event), 6), kindNames[data.kinds[event]], does.map(changeText).join("; ")];
      line.append(...texts.map((text) => Object.assign(document.createElement("td"), { textContent: text })));
      line.children[1].className = kindColours[data.kinds[event]] ?? "";
      line.addEventListener("click", () => goToEvent(event));
      return line;
    });
    body.replaceChildren(...this.rows);
    if (wanted.length > this.events.length) body.append(this.note(`… ${counted(wanted.length - MOST_ROWS)} more: take a narrower window.`));
    if (!wanted.length) body.append(this.note("None in this window."));
  },

  note(text) {
    const line = document.createElement("tr"), cell = document.createElement("td");
    cell.colSpan = 3;
    cell.textContent = text;
    line.append(cell);
    return line;
  },

  // Marks those at the radius where the page stands, and scrolls to the first after it.
  show(radius, at, chosen) {
    this.rows.forEach((line, i) => {
      const event = this.events[i];
      line.classList.toggle("here", chosen?.feature === "e" ? chosen.id === event : radiusOf(event) === at);
    });
    if (!this.rows.length) return;
    let i = this.events.findIndex((event) => data.radii[radiusOf(event)] >= radius);
    if (chosen?.feature === "e" && this.events.includes(chosen.id)) i = this.events.indexOf(chosen.id);
    if (i < 0) i = this.rows.length - 1;
    const box = element("events"), top = this.rows[i].offsetTop;
    if (top < box.scrollTop + 30 || top > box.scrollTop + box.clientHeight - 30) box.scrollTop = top - box.clientHeight / 2;
  },
};
