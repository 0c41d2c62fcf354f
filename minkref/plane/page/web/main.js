// The page: one scale, and what follows from it.
let scale = paper.scaleNear(clampScale(windowFirst < 1 && windowLast > 1 ? 1 : Math.sqrt(windowFirst * windowLast)));
let atEvent = -1;    // the boundary event at whose scale the page stands
let chosen = null;   // {feature, id}
let asked = false;

function moveTo(s, event = -1, place = null) {
  if (!Number.isFinite(s)) return;
  scale = event >= 0 ? clampScale(s) : paper.scaleNear(clampScale(s));
  atEvent = event;
  drawing.place = place;
  if (!asked) { asked = true; requestAnimationFrame(() => { asked = false; show(); }); }
}

const placeOf = (event) => data.places.slice(2 * event, 2 * event + 2);
const goToEvent = (event) => { if (isInside(event)) moveTo(data.about[event], event, placeOf(event)); };
const nextEvent = () => (atEvent >= 0 ? atEvent + 1 : placeAfter(data.about, scale));
function previousEvent() {
  if (atEvent >= 0) return atEvent - 1;
  let event = placeAfter(data.about, scale) - 1;
  while (event >= 0 && data.about[event] >= scale) --event;
  return event;
}

// The tight passages of the sum, if the page stands at an event.
const passagesHere = () => (atEvent >= 0 ? data.passages?.[atEvent] ?? [] : []);

function tellSituation() {
  const box = element("situation"), rings = [...timeline.at(scale).values()];
  const corners = rings.reduce((sum, ring) => sum + ring.vertices.length, 0);
  const holes = new Set(rings.filter((ring) => ring.isHole).map((ring) => ring.hole)).size;
  const components = new Set(rings.map((ring) => ring.component)).size;
  box.replaceChildren();
  if (atEvent >= 0) {
    const kind = kindNames[data.kinds[atEvent]];
    const changes = data.topology.filter((row) => row[0] === atEvent);
    box.append(`Boundary event ${(atEvent + 1).toLocaleString("en")} of ${data.scales.length.toLocaleString("en")}`);
    if (!changes.length) box.append(`: ${kind} of vertices.`);
    if (passagesHere().length) box.append(` · ${several(passagesHere().length, "tight passage")}`);
    changes.forEach((row) => {
      const word = document.createElement("b");
      word.className = word.textContent = row[2];
      box.append(" · ", word, ": ");
      tellChange(box, row);
    });
  } else if (rings.length) {
    box.append(`${several(corners, "vertex", "vertices")}, ${several(components, "component")}, ${several(holes, "hole")}`);
  }
}

function showChosen() {
  const box = element("chosen");
  box.replaceChildren();
  if (!chosen) { box.append("Point at a hole or a bar to see when it is born and when it dies; click to keep it."); return; }
  const { feature, id } = chosen, life = lives[feature][id];
  const name = document.createElement("b");
  name.append(swatch(feature, id), featureName(feature, id));
  box.append(name, " ");
  for (const [event, text] of [[life[0], bornText(life, true)], [life[1], diedText(life, true)]]) {
    const line = document.createElement("div");
    if (isInside(event)) {
      const button = document.createElement("button");
      button.textContent = text;
      button.addEventListener("click", () => goToEvent(event));
      line.append(button);
    } else {
      line.textContent = text;
    }
    box.append(line);
  }
}

function show() {
  if (element("follow").checked) drawing.fit(scale);
  drawing.draw(scale, chosen);
  drawInputs(scale);
  strip.show(scale);
  barcode.show(scale, chosen);
  eventList.show(scale, atEvent);
  paper.show(scale);
  element("slider").value = shareOf(scale);
  const field = element("scale");
  if (document.activeElement !== field || !field.classList.contains("bad")) {
    field.value = atEvent >= 0 ? data.scales[atEvent] : short(scale, 8);
    field.classList.remove("bad");
    field.style.width = `${Math.min(Math.max(field.value.length + 3, 14), 72)}ch`;
    field.title = atEvent >= 0 ? field.value : "A number or a fraction: 0.25, 7/5";
  }
  element("about").textContent = atEvent >= 0 && data.scales[atEvent] !== short(scale) ? `≈ ${short(scale, 9)}` : "";
  element("previous").disabled = !isInside(previousEvent());
  element("next").disabled = !isInside(nextEvent());
  tellSituation();
}

function choose(feature, id) {
  chosen = chosen && chosen.feature === feature && chosen.id === id ? null : { feature, id };
  if (chosen) {
    const life = lives[feature][id];
    const born = isInside(life[0]) ? data.about[life[0]] : windowFirst;
    const died = isInside(life[1]) ? data.about[life[1]] : windowLast;
    barcode.reveal(feature, id);
    if (!(scale > born && scale < died)) moveTo(Math.sqrt(born * died));
  }
  showChosen();
  show();
}

function layOut() {
  strip.draw();
  barcode.draw(choose);
  show();
}

function step(share) {
  moveTo(paper.run ? paper.scaleAfter(scale, Math.sign(share)) : scaleAt(shareOf(scale) + share));
}

const keys = {
  ArrowLeft: (event) => step(event.shiftKey ? -0.0005 : -0.005),
  ArrowRight: (event) => step(event.shiftKey ? 0.0005 : 0.005),
  PageDown: () => goToEvent(previousEvent()),
  PageUp: () => goToEvent(nextEvent()),
  Home: () => moveTo(windowFirst),
  End: () => moveTo(windowLast),
  Escape: () => { if (chosen) choose(chosen.feature, chosen.id); },
};

function enter(field) {
  const event = data.scales.indexOf(field.value.trim()), s = scaleOf(field.value);
  field.classList.toggle("bad", event < 0 && !(s >= windowFirst && s <= windowLast));
  if (field.classList.contains("bad")) return;
  if (event >= 0) goToEvent(event); else moveTo(s);
}

function listen() {
  element("slider").addEventListener("input", (event) => moveTo(scaleAt(Number(event.target.value))));
  listenToControls({
    keys, enter, layOut,
    previous: () => goToEvent(previousEvent()),
    next: () => goToEvent(nextEvent()),
    fit: () => { drawing.fit(scale); show(); },
    redraw: ["show-S", "show-T", "follow"],
    recolour: () => { eventList.fill(goToTopology); showChosen(); },
  });
  strip.listen();
  listenToPicture(holesAtPointer);
}

function goToTopology(event, place, [, feature, change, before, after]) {
  moveTo(data.about[event], event, place);
  const ids = (change === "birth" ? after : before).filter((id) => feature === "c" || id > 0);
  chosen = ids.length ? { feature, id: ids[0] } : chosen;
  showChosen();
  if (chosen) barcode.reveal(chosen.feature, chosen.id);
}

element("key-tight").hidden = !Object.keys(data.passages ?? {}).length;
element("count-S").textContent = (data.S.length / 2).toLocaleString("en");
element("count-T").textContent = (data.T.length / 2).toLocaleString("en");
barcode.collect();
if (barcode.rows.some((row) => row.feature === "c")) element("features").textContent = "Holes and components (C) from birth to death";
element("counts").textContent = [
  `s from ${data.window[0][0]} to ${data.window[1][0]}`, several(data.scales.length, "boundary event"),
  several(data.topology.length, "topology event"), several(data.holes.slice(1).filter(Boolean).length, "hole"),
  several(data.components.filter(Boolean).length, "component"),
].join(" · ");
eventList.fill(goToTopology);
paper.fill((s) => moveTo(s));
showChosen();
listen();
layOut();

// For tests and scripts.
window.minkref = {
  rings: canonicalPolygons,
  moveTo,
  get scale() { return scale; },
  get step() { return paper.stepAt(scale); },
  events: data.scales,
  goToEvent,
  get passages() { return passagesHere(); },
};
