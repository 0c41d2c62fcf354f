// The list of topology events.
const swatch = (feature, id) => {
  const box = document.createElement("span");
  box.className = "swatch";
  box.style.background = featureFill(feature, id);
  return box;
};

function nameList(cell, feature, ids) {
  ids.forEach((id, i) => {
    if (i) cell.append(i === ids.length - 1 ? " and " : ", ");
    const name = document.createElement("span");
    name.className = "name";
    name.append(swatch(feature, id), featureName(feature, id));
    cell.append(name);
  });
}

// "hole 3 dies", "hole 4 splits into hole 4 and hole 9".
function tellChange(cell, [, feature, change, before, after]) {
  nameList(cell, feature, before.length ? before : after);
  if (change === "split" || change === "merge") {
    cell.append(" → ");
    nameList(cell, feature, after);
  }
}

const eventList = {
  rows: [],  // of each topology event

  fill(goTo) {
    const body = document.querySelector("#events tbody");
    body.replaceChildren();
    this.rows = data.topology.map((row) => {
      const line = document.createElement("tr"), [event, , change, , , , place] = row;
      const scale = document.createElement("td"), kind = document.createElement("td"), which = document.createElement("td");
      scale.textContent = short(data.about[event]);
      scale.title = data.scales[event];
      kind.textContent = change;
      kind.className = change;
      tellChange(which, row);
      line.append(scale, kind, which);
      line.addEventListener("click", () => goTo(event, place, row));
      body.append(line);
      return line;
    });
    if (!data.topology.length) body.innerHTML = '<tr><td colspan="3">None in this window.</td></tr>';
  },

  // Marks those at the event where the page stands; scrolls to the first after the scale.
  show(s, event) {
    const scale = (row) => data.about[row[0]];
    this.rows.forEach((line, i) => line.classList.toggle("here", data.topology[i][0] === event));
    if (!this.rows.length) return;
    let i = data.topology.findIndex((row) => scale(row) >= s);
    if (i < 0) i = this.rows.length - 1;
    const box = element("events"), line = this.rows[i], top = line.offsetTop;
    if (top < box.scrollTop + 30 || top > box.scrollTop + box.clientHeight - 30) box.scrollTop = top - box.clientHeight / 2;
  },
};
