// @ts-check
// The page: one radius, and what follows from it.
import { Barcode } from "../../../page/web/barcode.js";
import { holeFill } from "../../../page/web/colours.js";
import { listenToControls } from "../../../page/web/controls.js";
import { button, element, isChecked, listenTo, node, swatch } from "../../../page/web/elements.js";
import { Explorer } from "../../../page/web/explorer.js";
import { counted, cut, placeAfter, scaleOf, several, short } from "../../../page/web/numbers.js";
import { Strip } from "../../../page/web/strip.js";
import { axis, changes, data, endInside, eventsAt, firstEvents, firstInside, isInside, pointOf, radiusOf } from "./data.js";
import { drawing } from "./drawing.js";
import { eventList } from "./events.js";
import { boundary, countsAt, lives } from "./history.js";
import { groups } from "./marks.js";
import { piecesOf } from "./rings.js";
import { skeletonParts } from "./skeleton.js";
import {
  bornText, changeText, describe, diedText, featureName, featureText, isTopology, kindColours, kindNames, kindTexts, kindsAt, pointText,
  radiusText,
} from "./texts.js";

/** @typedef {import("./data.js").Point} Point */

const MOST_PLACES = 200;  // of events at one radius that are marked
/** @type {import("../../../page/web/picture.js").Chosen | null} */
let chosen = null;  // a hole ("h") or an event ("e")

const explorer = new Explorer({
  axis, isInside, show,
  scales: data.radii,
  start: data.radii.length ? data.radii[Math.floor((firstInside + endInside) / 2)] ?? axis.last : Math.sqrt(axis.first * axis.last),
  go: goToRadius,
  arrive: (at) => { if (chosen?.feature === "e" && radiusOf(chosen.id) !== at) choose(null); },
});
/** @param {number} radius */
const moveTo = (radius) => explorer.moveTo(radius);
const strip = new Strip({
  axis, isInside, groups, moveTo,
  letter: "ρ",
  scales: data.radii,
  tell: (radius) => `radius ${radiusText(radius)}: ${kindsAt(radius)}`,
  go: goToRadius,
});
const barcode = new Barcode({ axis, isInside, lives, scales: data.radii, describe: (_, id) => describe(id), choose: (_, id) => chooseHole(id) });

/** At the radius of events the boundary is the one that begins there. */
const gapHere = () => (explorer.at >= 0 ? explorer.at + 1 : placeAfter(data.radii, explorer.scale));
const chosenEvent = () => (chosen?.feature === "e" ? chosen.id : null);
/** The tight passages of the sum, if the page stands at a radius of events. */
const passagesHere = () => (explorer.at >= 0 ? data.passages?.[explorer.at] ?? [] : []);

/** A radius of events: its only event is chosen, or the first that does something to holes or components. @param {number} number */
function goToRadius(number) {
  if (!isInside(number)) return;
  const events = eventsAt(number);
  goToEvent(events.find((event) => changes.has(event)) ?? events.find(isTopology) ?? events[0]);
}

/** @param {number} event */
function goToEvent(event) {
  explorer.moveTo(data.radii[radiusOf(event)], radiusOf(event));
  choose({ feature: "e", id: event });
}

function tellSituation() {
  const gap = gapHere(), { at } = explorer, { components, holes } = countsAt(gap, at >= 0);
  const corners = boundary.at(gap).reduce((sum, ring) => sum + ring.corners.length, 0);
  const told = `${several(components, "component")}, ${several(holes, "hole")}`;
  element("situation").textContent = at >= 0
    ? `Radius ${counted(at + 1)} of ${counted(data.radii.length)} with events: ${kindsAt(at)} · ${told}`
    : `${told}, ${several(corners, "corner")}`;
}

/** Tells of a hole or an event in the box below the bars. @param {typeof chosen} wanted */
function choose(wanted) {
  chosen = wanted;
  const nothing = "Point at a hole or a bar to see when it is born and when it ends; click to keep it. Click a mark to see its event.";
  element("chosen").replaceChildren(...!chosen ? [nothing] : chosen.feature === "h" ? tellHole(chosen.id) : tellEvent(chosen.id));
}

/** @param {...(Node | string)} parts */
const line = (...parts) => node("div", {}, ...parts);

/** @param {number} id */
function tellHole(id) {
  const [birth, end, , endsAt, from] = data.holes[id - 1];
  /** @param {string} text @param {number} number */
  const step = (text, number) => line(isInside(number) ? button(text, () => goToRadius(number)) : text);
  const lines = [
    node("b", {}, swatch(holeFill(id)), featureName(id)),
    step(bornText(birth - 1) + (birth ? `, of ${featureName(from)}` : ""), birth - 1), step(diedText(end - 1), end - 1),
  ];
  return endsAt === null ? lines : [...lines, line(`The last point of it is ${pointText(pointOf(endsAt))}.`)];
}

/** @param {number} event */
function tellEvent(event) {
  const kind = data.kinds[event], number = radiusOf(event), events = eventsAt(number), place = events.indexOf(event);
  const lines = [
    line(node("b", { class: kindColours[kind] ?? "" }, kindNames[kind]), ` at the radius ${radiusText(number, 12)}, at ${pointText(pointOf(event))}: ${kindTexts[kind]}.`),
    line(`As near: ${data.near[event].map(featureText).join(", ")}.`),
    ...(changes.get(event) ?? []).map((change) => line(`Here ${changeText(change)}.`)),
  ];
  if (events.length > 1) {
    const other = events[(place + 1) % events.length];
    lines.push(line(`${counted(place + 1)} of ${counted(events.length)} events at this radius. `, button("the next", () => goToEvent(other))));
  }
  return lines;
}

function show() {
  const { scale: radius, at } = explorer;
  if (isChecked("follow")) drawing.fit(radius);
  drawing.draw(radius, gapHere(), at >= 0 ? eventsAt(at).slice(0, MOST_PLACES) : [], chosen, passagesHere());
  strip.show(radius);
  barcode.show(radius, chosen?.feature === "h" ? chosen : null);
  eventList.show(radius, at, chosenEvent());
  explorer.showScale(short(radius, at >= 0 ? 12 : 8), false);
  tellSituation();
}

/** The page goes to a radius at which the hole is there. @param {number} id */
function chooseHole(id) {
  const isKept = chosen?.feature === "h" && chosen.id === id;
  choose(isKept ? null : { feature: "h", id });
  if (!isKept) {
    const [birth, end] = data.holes[id - 1];
    const born = Math.max(birth ? data.radii[birth - 1] : 0, axis.first), ends = Math.min(data.radii[end - 1], axis.last);
    barcode.reveal("h", id);
    if (!(birth <= gapHere() && gapHere() < end)) moveTo(Math.sqrt(born * ends));
  }
  show();
}

function layOut() {
  strip.draw();
  barcode.draw();
  show();
}

/** @param {string} text */
function read(text) {
  const radius = scaleOf(text);
  return axis.has(radius) ? () => moveTo(radius) : null;
}

element("counts").textContent = [
  `ρ from ${cut(data.window[0][0])} to ${cut(data.window[1][0])}`, several(firstEvents[endInside] - firstEvents[firstInside], "event"),
  several(barcode.rows.length, "hole"), several(data.polygons, "polygon"),
].join(" · ");
element("key-tight").hidden = !Object.values(data.passages ?? {}).some((found) => found.length);
eventList.fill(goToEvent);
choose(null);
listenToControls({
  explorer, read, show, layOut,
  keys: { ...explorer.keys(), Escape: () => { choose(null); show(); } },
  fit: () => drawing.fit(explorer.scale),
  redraw: ["show-diagram", "follow"],
  recolour: () => { eventList.fill(goToEvent); choose(chosen); },
});
listenTo(["show-all"], "change", () => { eventList.fill(goToEvent); show(); });
drawing.listen(show, { find: (x, y) => drawing.holeAt(x, y), tell: describe, take: chooseHole });
layOut();

// For tests and scripts.
Object.assign(window, { minkref: {
  /** The boundary as [{hole, pieces: [[centre or null, from, to], ...]}, ...] in coordinates of P. @param {number} radius */
  rings(radius) {
    /** @param {Point | null} point */
    const absolute = (point) => point && [point[0] + data.origin[0], point[1] + data.origin[1]];
    return boundary.at(placeAfter(data.radii, radius)).map((ring) => ({
      hole: ring.hole,
      pieces: piecesOf(ring, radius).map(({ centre, from, to }) => [centre, from, to].map(absolute)),
    }));
  },
  diagram: () => skeletonParts(axis.last),
  counts: /** @param {number} radius */ (radius) => countsAt(placeAfter(data.radii, radius), false),
  moveTo,
  goToEvent,
  get radius() { return explorer.scale; },
  get chosen() { return chosen; },
  events: data.kinds.length,
  goToRadius,
  get passages() { return passagesHere(); },
} });
