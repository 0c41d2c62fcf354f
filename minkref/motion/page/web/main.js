// @ts-check
// The page: a scale and a place on the path, and what follows from them.
import { listenToControls } from "../../../page/web/controls.js";
import { element, input, isChecked, node, onSlide } from "../../../page/web/elements.js";
import { Explorer, stride } from "../../../page/web/explorer.js";
import { fractionOfDouble, typedFraction } from "../../../page/web/fractions.js";
import { clamped, scaleOf, several, short } from "../../../page/web/numbers.js";
import { boundList } from "./bounds.js";
import { axis, data, isInside, scalesOfBounds } from "./data.js";
import { diagram } from "./diagram.js";
import { drawing } from "./drawing.js";
import { collisionAt, polygons } from "./polygons.js";
import { boundLines, placeText } from "./texts.js";
import { isValid } from "./valid.js";
import { corners, placeAt, shareOfPlace } from "./way.js";

/** @typedef {import("./polygons.js").Polygon} Polygon */

/** @type {string | null} */
let exact = null;  // the scale as a text, where it is known
let share = 0;     // of the path, up to the place

const explorer = new Explorer({ axis, isInside, show, scales: scalesOfBounds, start: axis.first, go: goToBound, arrive: () => { exact = null; } });

/** @param {number} scale @param {number} along @param {string | null} text */
function move(scale, along, text = null, bound = -1) {
  if (!Number.isFinite(scale) || !Number.isFinite(along)) return;
  explorer.moveTo(scale, bound);
  share = clamped(along, 0, 1);
  exact = text;
}
/** @param {number} along */
const goAlong = (along) => move(explorer.scale, along, exact);

/** @param {number} i */
function goToBound(i) {
  if (!isInside(i)) return;
  const { scale, at, about } = data.bounds[i];
  move(about.scale, shareOfPlace(at.segment, about.t), scale, i);
}

const boundHere = () => data.bounds[explorer.at] ?? null;

/** At a bound the place is that of the contact, as the reference gives it. */
function placeHere() {
  const bound = boundHere();
  if (!bound) return placeAt(share);
  const { at, about } = bound;
  return { segment: at.segment, t: about.t, x: about.point[0], y: about.point[1] };
}

/** @param {boolean} valid @param {Polygon | null} collision */
function tellSituation(valid, collision) {
  const word = node("b", { class: valid ? "valid" : "bad" }, valid ? "valid: the part passes" : "not valid");
  const here = valid ? "" : collision ? ", it collides here" : ", it is free here";
  element("situation").replaceChildren(word, `${here} · ${placeText(placeHere())}`);
}

function showChosen() {
  const bound = boundHere();
  const lines = bound ? boundLines(bound) : ["Click a bound, in the diagram or in the list, to see the contact that is its cause."];
  element("chosen").replaceChildren(...lines.map((text) => node("div", {}, text)));
}

function show() {
  const { scale, at } = explorer, place = placeHere(), bound = boundHere();
  const valid = isValid(exact === null ? fractionOfDouble(scale) : typedFraction(exact));
  // No place collides at a valid scale, whatever the polygons say in doubles.
  const collision = valid ? null : collisionAt(place.segment, place.t, scale);
  if (isChecked("follow")) drawing.fit(place, scale);
  drawing.draw(place, scale, collision, bound);
  diagram.show(share, scale, collision, at);
  boundList.show(at);
  input("place-slider").value = String(share);
  explorer.showScale(exact ?? short(scale, 8), true);
  element("about").textContent = exact !== null && exact !== short(scale) ? `≈ ${short(scale, 9)}` : "";
  showChosen();
  tellSituation(valid, collision);
}

function layOut() {
  diagram.draw(goToBound);
  show();
}

/** @param {number} by */
const alongBy = (by) => goAlong(share + by);

/** @param {string} text */
function read(text) {
  const scale = scaleOf(text);
  if (!axis.has(scale) || typedFraction(text) === null) return null;
  return () => move(scale, share, text.trim().replace(",", "."));
}

element("counts").textContent = [
  `contact ${data.contact}`, `s from ${data.window[0][0]} to ${data.window[1][0]}`, several(corners.length, "vertex of the path", "vertices of the path"),
  several(polygons.length, "bad polygon"), several(data.bounds.length, "bound"),
].join(" · ");
element("valid").classList.toggle("none", !data.valid.length);
boundList.fill(goToBound);
onSlide("place-slider", goAlong);
diagram.listen((along, scale) => move(scale, along));
listenToControls({
  explorer, read, show, layOut,
  keys: {
    ...explorer.keys(),
    ArrowLeft: (event) => alongBy(-stride(event)),
    ArrowRight: (event) => alongBy(stride(event)),
    ArrowDown: (event) => explorer.step(-stride(event)),
    ArrowUp: (event) => explorer.step(stride(event)),
    Home: () => goAlong(0),
    End: () => goAlong(1),
  },
  fit: () => drawing.fit(placeHere(), explorer.scale),
  redraw: ["show-pieces", "follow"],
  recolour: () => boundList.fill(goToBound),
});
drawing.listen(show, null);
new ResizeObserver(layOut).observe(element("diagram-box"));
layOut();
const firstBound = data.bounds.findIndex((_, i) => isInside(i));
if (firstBound >= 0) goToBound(firstBound); else move((axis.first + axis.last) / 2, 0.5);

// For tests and scripts.
Object.assign(window, { minkref: {
  /** @param {number} scale @param {number} along */
  moveTo: (scale, along) => move(scale, along),
  goToBound,
  /** @param {string | number} scale */
  isValid: (scale) => isValid(typeof scale === "string" ? typedFraction(scale) : fractionOfDouble(scale)),
  /** @type {(segment: number, t: number, scale: number) => boolean} */
  collides: (segment, t, scale) => collisionAt(segment, t, scale) !== null,
  get scale() { return explorer.scale; },
  get place() { return { ...placeHere(), share }; },
  get bound() { return explorer.at; },
  get part() {
    const { x, y } = placeHere();
    return data.part.map((polygon) => polygon.map((ring) => ring.map((number, i) => (i % 2 ? y : x) + explorer.scale * number)));
  },
} });
