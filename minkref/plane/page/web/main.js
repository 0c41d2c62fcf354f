// @ts-check
// The page: one scale, and what follows from it.
import { Barcode } from "../../../page/web/barcode.js";
import { featureFill } from "../../../page/web/colours.js";
import { listenToControls } from "../../../page/web/controls.js";
import { button, element, isChecked, node, swatch } from "../../../page/web/elements.js";
import { Explorer } from "../../../page/web/explorer.js";
import { counted, scaleOf, several, short } from "../../../page/web/numbers.js";
import { Strip } from "../../../page/web/strip.js";
import { canonicalPolygons } from "./canonical.js";
import { axis, data, isInside } from "./data.js";
import { drawing } from "./drawing.js";
import { eventList } from "./events.js";
import { drawInputs } from "./inputs.js";
import { groups } from "./marks.js";
import { paper } from "./paper.js";
import { bornText, describe, diedText, exactAndAbout, featureName, kindNames, lives, tellChange } from "./texts.js";
import { timeline } from "./timeline.js";

/** @type {import("../../../page/web/picture.js").Chosen | null} */
let chosen = null;

/** @param {number} s */
const moveTo = (s) => explorer.moveTo(s);
const explorer = new Explorer({
  axis, isInside, show,
  scales: data.about,
  start: axis.first < 1 && axis.last > 1 ? 1 : Math.sqrt(axis.first * axis.last),
  go: goToEvent,
  arrive: () => { drawing.place = null; },
  snap: (s) => paper.scaleNear(s),
  stepped: paper.isThere ? (s, share) => paper.scaleAfter(s, Math.sign(share)) : undefined,
});
const strip = new Strip({
  axis, isInside, groups, moveTo,
  letter: "s",
  scales: data.about,
  bars: (x) => paper.bars(x),
  tell: (event) => `boundary event ${event + 1}: ${exactAndAbout(event)}`,
  go: goToEvent,
});
const barcode = new Barcode({ axis, isInside, describe, choose, scales: data.about, lives: { h: data.holes, c: data.components } });

/** @param {number} event */
function goToEvent(event) {
  if (!isInside(event)) return;
  explorer.moveTo(data.about[event], event);
  drawing.place = data.places.slice(2 * event, 2 * event + 2);
}

/** The tight passages of the sum, if the page stands at an event. */
const passagesHere = () => (explorer.at >= 0 ? data.passages?.[explorer.at] ?? [] : []);

function tellSituation() {
  const box = element("situation"), rings = [...timeline.at(explorer.scale).values()], event = explorer.at;
  box.replaceChildren();
  if (event >= 0) {
    const changes = data.topology.filter((row) => row[0] === event);
    box.append(`Boundary event ${counted(event + 1)} of ${counted(data.scales.length)}`);
    if (!changes.length) box.append(`: ${kindNames[data.kinds[event]]} of vertices.`);
    if (passagesHere().length) box.append(` · ${several(passagesHere().length, "tight passage")}`);
    changes.forEach((row) => {
      box.append(" · ", node("b", { class: row[2] }, row[2]), ": ");
      tellChange(box, row);
    });
  } else if (rings.length) {
    const corners = rings.reduce((sum, ring) => sum + ring.vertices.length, 0);
    const holes = new Set(rings.filter((ring) => ring.isHole).map((ring) => ring.hole)).size;
    const components = new Set(rings.map((ring) => ring.component)).size;
    box.append(`${several(corners, "vertex", "vertices")}, ${told(components, holes)}`);
  }
}

/** Components and holes of the sum, or of the erosion inside of it. @param {number} components @param {number} holes */
function told(components, holes) {
  const [own, inner] = data.erode ? [holes, Math.max(components - 1, 0)] : [components, holes];
  return `${several(own, "component")}, ${several(inner, "hole")}`;
}

/** Words of an erosion: the sum of the outside is what surrounds it. */
function nameErosion() {
  element("key-sum").textContent = "outside";
  element("key-holes").textContent = "erosion";
  element("sum").setAttribute("aria-label", "The erosion at this scale");
  element("features").textContent = barcode.hasComponents
    ? "Components and holes (C) of the erosion from birth to death" : "Components of the erosion from birth to death";
}

function showChosen() {
  const box = element("chosen");
  const one = data.erode ? "a component" : "a hole";
  if (!chosen) { box.replaceChildren(`Point at ${one} or a bar to see when it is born and when it dies; click to keep it.`); return; }
  const { feature, id } = chosen, life = lives[feature][id];
  box.replaceChildren(node("b", {}, swatch(featureFill(feature, id)), featureName(feature, id)), " ");
  if (!life) return;
  for (const [event, text] of /** @type {const} */ ([[life[0], bornText(life, true)], [life[1], diedText(life, true)]])) {
    box.append(node("div", {}, isInside(event) ? button(text, () => goToEvent(event)) : text));
  }
}

function show() {
  const { scale, at } = explorer, exact = at >= 0 ? data.scales[at] : null;
  if (isChecked("follow")) drawing.fit(scale);
  drawing.draw(scale, chosen, passagesHere());
  drawInputs(scale);
  strip.show(scale);
  barcode.show(scale, chosen);
  eventList.show(scale, at);
  paper.show(scale);
  explorer.showScale(exact ?? short(scale, 8), true);
  element("scale").title = exact ?? "A number or a fraction: 0.25, 7/5";
  element("about").textContent = exact !== null && exact !== short(scale) ? `≈ ${short(scale, 9)}` : "";
  tellSituation();
}

/** @param {string} feature @param {number} id */
function choose(feature, id) {
  chosen = chosen?.feature === feature && chosen.id === id ? null : { feature, id };
  const life = lives[feature][id];
  if (chosen && life) {
    const born = isInside(life[0]) ? data.about[life[0]] : axis.first, died = isInside(life[1]) ? data.about[life[1]] : axis.last;
    barcode.reveal(feature, id);
    if (!(explorer.scale > born && explorer.scale < died)) moveTo(Math.sqrt(born * died));
  }
  showChosen();
  show();
}

function layOut() {
  strip.draw();
  barcode.draw();
  show();
}

/** @param {import("./data.js").Change} change */
function goToTopology([event, feature, change, before, after, , place]) {
  explorer.moveTo(data.about[event], event);
  drawing.place = place;
  const ids = (change === "birth" ? after : before).filter((id) => feature === "c" || id > 0);
  chosen = ids.length ? { feature, id: ids[0] } : chosen;
  showChosen();
  if (chosen) barcode.reveal(chosen.feature, chosen.id);
}

/** @param {string} text */
function read(text) {
  const event = data.scales.indexOf(text.trim()), s = scaleOf(text);
  if (event >= 0) return () => goToEvent(event);
  return axis.has(s) ? () => moveTo(s) : null;
}

element("key-tight").hidden = !Object.keys(data.passages ?? {}).length;
element("count-S").textContent = counted(data.S.length / 2);
element("count-T").textContent = counted(data.T.length / 2);
if (data.erode) nameErosion();
else if (barcode.hasComponents) element("features").textContent = "Holes and components (C) from birth to death";
element("counts").textContent = [
  `s from ${data.window[0][0]} to ${data.window[1][0]}`, several(data.scales.length, "boundary event"),
  several(data.topology.length, "topology event"),
  told(data.components.filter(Boolean).length, data.holes.slice(1).filter(Boolean).length),
].join(" · ");
eventList.fill(goToTopology);
paper.fill(moveTo);
showChosen();
listenToControls({
  explorer, read, show, layOut,
  keys: { ...explorer.keys(), Escape: () => { if (chosen) choose(chosen.feature, chosen.id); } },
  fit: () => drawing.fit(explorer.scale),
  redraw: ["show-S", "show-T", "follow"],
  recolour: () => { eventList.fill(goToTopology); showChosen(); },
});
drawing.listen(show, { find: (x, y) => drawing.holeAt(x, y), tell: (id) => describe("h", id), take: (id) => choose("h", id) });
layOut();

// For tests and scripts.
Object.assign(window, { minkref: {
  rings: canonicalPolygons,
  moveTo,
  get scale() { return explorer.scale; },
  get step() { return paper.stepAt(explorer.scale); },
  events: data.scales,
  goToEvent,
  get passages() { return passagesHere(); },
} });
