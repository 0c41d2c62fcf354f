// The page: one radius, and what follows from it.
const MOST_PLACES = 200;  // of events at one radius that are marked
let radius = clampScale(data.radii.length ? data.radii[Math.floor((firstInside + endInside) / 2)] ?? windowLast : Math.sqrt(windowFirst * windowLast));
let at = -1;        // the radius of events where the page stands, by number
let chosen = null;  // {feature: "h", id: hole} or {feature: "e", id: event}
let asked = false;

// At the radius of events the boundary is the one that begins there.
const gapHere = () => (at >= 0 ? at + 1 : placeAfter(data.radii, radius));

function moveTo(r, number = -1) {
  if (!Number.isFinite(r)) return;
  radius = clampScale(r);
  at = number;
  if (chosen?.feature === "e" && radiusOf(chosen.id) !== at) { chosen = null; showChosen(); }
  if (!asked) { asked = true; requestAnimationFrame(() => { asked = false; show(); }); }
}

// A radius of events: its only event is chosen, or the first that does something to holes or components.
function goToRadius(number) {
  if (!isInside(number)) return;
  const events = [];
  for (let event = firstEvents[number]; event < firstEvents[number + 1]; ++event) events.push(event);
  goToEvent(events.find((event) => changes.has(event)) ?? events.find(isTopology) ?? events[0]);
}

function goToEvent(event) {
  moveTo(data.radii[radiusOf(event)], radiusOf(event));
  chosen = { feature: "e", id: event };
  showChosen();
}

const nextRadius = () => (at >= 0 ? at + 1 : placeAfter(data.radii, radius));
function previousRadius() {
  if (at >= 0) return at - 1;
  let number = placeAfter(data.radii, radius) - 1;
  while (number >= 0 && data.radii[number] >= radius) --number;
  return number;
}

// The tight passages of the sum, if the page stands at a radius of events.
const passagesHere = () => (at >= 0 ? data.passages?.[at] ?? [] : []);

function tellSituation() {
  const gap = gapHere(), { components, holes } = countsAt(gap, at >= 0);
  const corners = boundary.at(gap).reduce((sum, ring) => sum + ring.corners.length, 0);
  const told = `${several(components, "component")}, ${several(holes, "hole")}`;
  element("situation").textContent = at >= 0
    ? `Radius ${counted(at + 1)} of ${counted(data.radii.length)} with events: ${kindsAt(at)} · ${told}`
    : `${told}, ${several(corners, "corner")}`;
}

function line(text, ...more) {
  const box = document.createElement("div");
  box.append(text, ...more);
  return box;
}

function button(text, go) {
  const made = document.createElement("button");
  made.textContent = text;
  made.addEventListener("click", go);
  return made;
}

function showChosen() {
  const box = element("chosen");
  if (!chosen) { box.replaceChildren("Point at a hole or a bar to see when it is born and when it ends; click to keep it. Click a mark to see its event."); return; }
  if (chosen.feature === "h") { box.replaceChildren(...tellHole(chosen.id)); return; }
  box.replaceChildren(...tellEvent(chosen.id));
}

function tellHole(id) {
  const [birth, end, , endsAt, from] = data.holes[id - 1];
  const name = document.createElement("b"), swatch = document.createElement("span");
  swatch.className = "swatch";
  swatch.style.background = holeFill(id);
  name.append(swatch, featureName("h", id));
  const step = (text, number) => (isInside(number) ? line(button(text, () => goToRadius(number))) : line(text));
  const origin = birth ? `, of ${featureName("h", from)}` : "";
  return [
    name, step(bornText([birth - 1]) + origin, birth - 1), step(diedText([0, end - 1]), end - 1),
    line(`The last point of it is ${pointText(data.places.slice(2 * endsAt, 2 * endsAt + 2))}.`),
  ];
}

function tellEvent(event) {
  const name = document.createElement("b"), kind = data.kinds[event], number = radiusOf(event);
  name.textContent = kindNames[kind];
  name.className = kindColours[kind] ?? "";
  const lines = [
    line(name, ` at the radius ${short(data.radii[number], 12)}, at ${pointText(data.places.slice(2 * event, 2 * event + 2))}: ${kindTexts[kind]}.`),
    line(`As near: ${data.near[event].map(featureText).join(", ")}.`),
    ...(changes.get(event) ?? []).map((change) => line(`Here ${changeText(change)}.`)),
  ];
  const [first, end] = [firstEvents[number], firstEvents[number + 1]];
  if (end - first > 1) {
    const other = event + 1 < end ? event + 1 : first;
    lines.push(line(`${counted(event - first + 1)} of ${counted(end - first)} events at this radius. `, button("the next", () => goToEvent(other))));
  }
  return lines;
}

function show() {
  if (element("follow").checked) drawing.fit(radius);
  const marked = [];
  if (at >= 0) for (let event = firstEvents[at]; event < firstEvents[at + 1] && marked.length < MOST_PLACES; ++event) marked.push(event);
  drawing.draw(radius, gapHere(), marked, chosen);
  strip.show(radius);
  barcode.show(radius, chosen?.feature === "h" ? chosen : null);
  eventList.show(radius, at, chosen);
  element("slider").value = shareOf(radius);
  const field = element("scale");
  if (document.activeElement !== field || !field.classList.contains("bad")) {
    field.value = short(radius, at >= 0 ? 12 : 8);
    field.classList.remove("bad");
  }
  element("previous").disabled = !isInside(previousRadius());
  element("next").disabled = !isInside(nextRadius());
  tellSituation();
}

// A hole; the page goes to a radius at which it is there.
function choose(feature, id) {
  chosen = chosen?.feature === feature && chosen.id === id ? null : { feature, id };
  if (chosen) {
    const [birth, end] = data.holes[id - 1];
    const born = Math.max(birth ? data.radii[birth - 1] : 0, windowFirst), ends = Math.min(data.radii[end - 1], windowLast);
    barcode.reveal(feature, id);
    if (!(birth <= gapHere() && gapHere() < end)) moveTo(Math.sqrt(born * ends));
  }
  showChosen();
  show();
}

function layOut() {
  strip.draw();
  barcode.draw(choose);
  show();
}

const step = (share) => moveTo(scaleAt(shareOf(radius) + share));
const keys = {
  ArrowLeft: (event) => step(event.shiftKey ? -0.0005 : -0.005),
  ArrowRight: (event) => step(event.shiftKey ? 0.0005 : 0.005),
  PageDown: () => goToRadius(previousRadius()),
  PageUp: () => goToRadius(nextRadius()),
  Home: () => moveTo(windowFirst),
  End: () => moveTo(windowLast),
  Escape: () => { chosen = null; showChosen(); show(); },
};

function enter(field) {
  const r = scaleOf(field.value);
  field.classList.toggle("bad", !(r >= windowFirst && r <= windowLast));
  if (!field.classList.contains("bad")) moveTo(r);
}

function listen() {
  element("slider").addEventListener("input", (event) => moveTo(scaleAt(Number(event.target.value))));
  listenToControls({
    keys, enter, layOut,
    previous: () => goToRadius(previousRadius()),
    next: () => goToRadius(nextRadius()),
    fit: () => { drawing.fit(radius); show(); },
    redraw: ["show-diagram", "follow"],
    recolour: () => { eventList.fill(); showChosen(); },
  });
  element("show-all").addEventListener("change", () => { eventList.fill(); show(); });
  strip.listen();
  listenToPicture(holesAtPointer);
}

barcode.collect();
element("counts").textContent = [
  `ρ from ${cut(data.window[0][0])} to ${cut(data.window[1][0])}`, several(firstEvents[endInside] - firstEvents[firstInside], "event"),
  several(barcode.rows.length, "hole"), several(data.polygons, "polygon"),
].join(" · ");
element("key-tight").hidden = !Object.values(data.passages ?? {}).some((found) => found.length);
eventList.fill();
showChosen();
listen();
layOut();

// For tests and scripts.
window.minkref = {
  // [{hole, pieces: [[centre or null, from, to], ...]}, ...] in coordinates of P.
  rings(r) {
    const absolute = (point) => point && [point[0] + data.origin[0], point[1] + data.origin[1]];
    return boundary.at(placeAfter(data.radii, r)).map((ring) => ({
      hole: ring.hole,
      pieces: piecesOf(ring, r).map(({ centre, from, to }) => [centre, from, to].map(absolute)),
    }));
  },
  diagram: () => skeletonParts(windowLast),
  counts: (r) => countsAt(placeAfter(data.radii, r), false),
  moveTo,
  goToEvent,
  get radius() { return radius; },
  get chosen() { return chosen; },
  events: data.kinds.length,
  goToRadius,
  get passages() { return passagesHere(); },
};
