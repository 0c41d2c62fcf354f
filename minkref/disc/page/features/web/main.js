// @ts-check
// The page: one diameter and one persistence, and what follows from them.
import { logarithmicAxis } from "../../../../page/web/axis.js";
import { Barcode } from "../../../../page/web/barcode.js";
import { holeFill } from "../../../../page/web/colours.js";
import { listenToControls } from "../../../../page/web/controls.js";
import { element, input, isChecked, node, onSlide, swatch } from "../../../../page/web/elements.js";
import { Explorer } from "../../../../page/web/explorer.js";
import { counted, scaleOf, several, short } from "../../../../page/web/numbers.js";
import { Strip } from "../../../../page/web/strip.js";
import { data } from "../../web/data.js";
import { alphas, axis, bars, changes, isAlive, isInWindow, isInside, lengths, levelOf, lifeOf } from "./bars.js";
import { drawing } from "./drawing.js";
import { areaOf, featuresAt } from "./regions.js";
import { bornText, changeText, describe, endText, lengthText, pointText } from "./texts.js";

/** @typedef {import("./regions.js").Feature} Feature */

let persistence = 0;
/** @type {number | null} */
let chosen = null;  // a bar
/** @type {number | null} */
let pointed = null;

const explorer = new Explorer({
  axis, isInside, show,
  scales: alphas,
  start: Math.sqrt(axis.first * axis.last),
  go: (change) => { if (isInside(change)) explorer.moveTo(alphas[change], change); },
});
const strip = new Strip({
  axis, isInside,
  letter: "α",
  scales: alphas,
  tell: changeText,
  groups: stripGroups,
  go: explorer.way.go,
  moveTo: (alpha) => explorer.moveTo(alpha),
});
let barcode = newBarcode();

/** @param {number} bar */
const isLong = (bar) => lengths[bar] > persistence;
/** Bars that are longer, alive at a level. @param {number} level */
const longAt = (level) => bars.flatMap((_, bar) => (isAlive(bar, level) && isLong(bar) ? [bar] : []));

/** Longer bars of the window, by number. */
function newBarcode() {
  const f = bars.map((_, bar) => (isInWindow(bar) && lengths[bar] > persistence ? lifeOf(bar) : null));
  return new Barcode({
    axis, isInside,
    lives: { h: [], c: [], f },
    scales: alphas,
    none: "No bar is longer.",
    describe: (_, bar) => describe(bar),
    choose: (_, bar) => choose(bar),
    point: (bar) => { if (pointed !== bar) { pointed = bar; explorer.show(); } },
  });
}

/** Marks where longer bars are born and end. @returns {import("../../../../page/web/strip.js").Group[]} */
function stripGroups() {
  const long = bars.filter((_, bar) => isLong(bar));
  /** @param {number[]} numbers */
  const scales = (numbers) => [...new Set(numbers)].map((number) => changes.indexOf(number)).filter(isInside).map((change) => alphas[change]);
  return [
    { id: "marks", name: "mark", isTall: false, scales: alphas.filter((_, change) => isInside(change)) },
    { id: "marks-birth", name: "birth", isTall: true, scales: scales(long.map((bar) => bar[1])) },
    { id: "marks-end", name: "death", isTall: true, scales: scales(long.map((bar) => bar[2])) },
  ];
}

/** @type {{ level: number, alpha: number, features: Feature[] }} */
let kept = { level: -1, alpha: 0, features: [] };
function featuresHere() {
  const alpha = explorer.scale, level = levelOf(alpha, explorer.at);
  if (kept.level !== level || kept.alpha !== alpha) kept = { level, alpha, features: featuresAt(level, alpha / 2) };
  return kept;
}

function show() {
  const { level, alpha, features } = featuresHere();
  const shown = features.filter(({ bar }) => bar === null || isLong(bar));
  if (isChecked("follow")) drawing.fit();
  const one = pointed ?? chosen;
  drawing.draw(shown, one);
  strip.show(alpha);
  barcode.show(alpha, one === null ? null : { feature: "f", id: one });
  explorer.showScale(short(alpha, explorer.at >= 0 ? 12 : 8), false);
  const own = shown.filter(({ bar }) => bar !== null), all = features.filter(({ bar }) => bar !== null);
  const bridges = own.reduce((sum, feature) => sum + feature.bridges.length, 0);
  element("situation").textContent = `${counted(own.length)} of ${several(all.length, "feature")}, ${several(bridges, "bridge")}`;
  element("persistence-text").textContent = short(persistence, 4);
  element("bars-shown").textContent = `${counted(barcode.rows.length)} of ${several(bars.length, "bar")}; ${counted(longAt(level).length)} alive`;
  tellChosen(features);
}

/** @param {Feature[]} features */
function tellChosen(features) {
  const box = element("chosen");
  if (chosen === null) {
    box.replaceChildren("Point at a feature or a bar to see its life; click to keep it.");
    return;
  }
  const here = features.find(({ bar }) => bar === chosen), pocket = here?.pocket;
  const depth = pocket && Number.isFinite(pocket.depth) ? `, ${short(pocket.depth)} deep` : "";
  /** @param {string} text */
  const line = (text) => node("div", {}, text);
  box.replaceChildren(
    node("b", {}, swatch(holeFill(chosen)), `feature ${counted(chosen)}`),
    line(`${bornText(chosen)}, ${endText(chosen)}; persistence: ${lengthText(chosen)}`),
    ...(here ? [line(`${several(here.bridges.length, "bridge")}, area ${short(areaOf(here.rings))}`)] : [line("not alive here")]),
    ...(pocket ? [line(`pocket minimum ${pointText(pocket.vertex)}${depth}`)] : []),
  );
}

/** Keeps a bar; the page goes to a diameter at which it is alive. @param {number} bar */
function choose(bar) {
  chosen = chosen === bar ? null : bar;
  if (chosen !== null) {
    const [born, died] = lifeOf(bar);
    barcode.reveal("f", bar);
    if (!isAlive(bar, featuresHere().level)) {
      explorer.moveTo(Math.sqrt(Math.max(alphas[born] ?? 0, axis.first) * Math.min(alphas[died] ?? Infinity, axis.last)));
    }
  }
  explorer.show();
}

// From 0 at the left end, by powers to the longest bar that ends.
const finite = lengths.filter((length) => Number.isFinite(length) && length > 0), longest = Math.max(0, ...finite);
const lengthAxis = longest ? logarithmicAxis(Math.min(longest / 10, Math.max(Math.min(...finite) / 2, longest * 1e-6)), longest) : null;
input("persistence").disabled = !lengthAxis;

/** @param {number} wanted */
function setPersistence(wanted) {
  persistence = wanted;
  input("persistence").value = String(lengthAxis && wanted > 0 ? lengthAxis.shareOf(wanted) : 0);
  barcode = newBarcode();
  layOut();
}
onSlide("persistence", (share) => setPersistence(share > 0 && lengthAxis ? lengthAxis.scaleAt(share) : 0));

function layOut() {
  strip.draw();
  barcode.draw();
  show();
}

element("counts").textContent = [
  `α from ${short(axis.first)} to ${short(axis.last)}`, several(bars.length, "bar"), several(data.halves.length / 2, "part of the diagram", "parts of the diagram"),
].join(" · ");
listenToControls({
  explorer, show, layOut,
  read: (text) => { const alpha = scaleOf(text); return axis.has(alpha) ? () => explorer.moveTo(alpha) : null; },
  keys: { ...explorer.keys(), Escape: () => { chosen = null; show(); } },
  fit: () => drawing.fit(),
  redraw: ["follow"],
  recolour: () => {},
});
drawing.listen(show, { find: (x, y) => drawing.holeAt(x, y), tell: describe, take: choose });
layOut();

// For tests and scripts.
Object.assign(window, { minkref: {
  /** Features at a diameter, with places in coordinates of P. @param {number} alpha */
  features(alpha) {
    /** @param {import("../../web/data.js").Point} point */
    const absolute = ([x, y]) => [x + data.origin[0], y + data.origin[1]];
    return featuresAt(levelOf(alpha), alpha / 2).map(({ bar, bridges, rings, pocket }) => ({
      bar,
      area: areaOf(rings),
      bridges: bridges.map(({ from, to, centre }) => [from, to, centre].map(absolute)),
      rings: rings.map((ring) => ring.map(absolute)),
      pocket: pocket && { vertex: absolute(pocket.vertex), depth: Number.isFinite(pocket.depth) ? pocket.depth : null },
    }));
  },
  /** @param {number} alpha */
  moveTo: (alpha) => explorer.moveTo(alpha),
  /** @param {number} change */
  goToChange: (change) => explorer.way.go(change),
  setPersistence, choose, alphas,
  /** The bars that are longer and alive at a diameter. @param {number} alpha */
  bars: (alpha) => longAt(levelOf(alpha)),
  get alpha() { return explorer.scale; },
  get persistence() { return persistence; },
  get chosen() { return chosen; },
} });
