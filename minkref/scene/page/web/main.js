// @ts-check
// The page: copies, the free space that they leave, and a robot in it.
import { element, input, listenTo, onNextPicture, onRecolour } from "../../../page/web/elements.js";
import { several } from "../../../page/web/numbers.js";
import { data } from "./data.js";
import { Drawing } from "./drawing.js";
import { listenToHand } from "./hand.js";
import { Panel } from "./panel.js";
import { situationAt } from "./robot.js";
import { copiesAsRead, fileOf } from "./scene.js";
import { forget, tellFree, tellRobot } from "./texts.js";

/** @typedef {import("./scene.js").Copy} Copy */

const AT_REST = 200;  // milliseconds without a change, after which the free space is found by finer cells
const NEAR = 0.75;  // pixels from a boundary that count as contact

const drawing = new Drawing(), asRead = copiesAsRead();
let copies = asRead.map((copy) => copy.clone());
/** @type {Copy | null} */
let selected = null;
/** @type {Copy | null} */
let apart = null;  // changes, and is drawn apart from the others
let isHeld = false;
/** @type {{ x: number, y: number } | null} */
let robotAt = null;
let isPinned = false;
let isStale = true;  // the free space is that of an earlier scene, view or rule
let timer = 0;
const drawn = { frames: 0, milliseconds: 0 };

/** @returns {"allowed" | "forbidden"} */
const contact = () => (input("contact-allowed").checked ? "allowed" : "forbidden");
const robot = () => robotAt && (!isHeld || isPinned)
  ? { ...robotAt, isPinned, situation: situationAt(copies, robotAt.x, robotAt.y, NEAR / drawing.view.unit) } : null;

const ask = onNextPicture(show);
function show() {
  const began = performance.now(), shown = { copies, apart, selected, contact: contact(), robot: robot() };
  if (isStale) {
    drawing.colourFree(copies, shown.contact, false);
    isStale = false;
    clearTimeout(timer);
    timer = setTimeout(refine, AT_REST);
  }
  drawing.draw(shown);
  const name = robotAt ? drawing.nameAt(robotAt.x, robotAt.y) : -1;
  // The document last: what asks for sizes or colours after it changed waits for its layout.
  tellFree(element("situation"), drawing.grid.found, shown.contact, drawing.isFine);
  tellRobot(element("robot"), shown.robot, name, copies);
  panel.show(selected, copies);
  ++drawn.frames;
  drawn.milliseconds += performance.now() - began;
}

/** Finer cells, once nothing moves. */
function refine() {
  if (isStale || isHeld) return;
  apart = null;
  drawing.colourFree(copies, contact(), true);
  panel.tellChanged();
  ask();
}

/** The scene, the view or the rule changed. */
function change() { isStale = true; ask(); }

/** @param {Copy} copy */
function changed(copy) {
  drawing.grid.change(copy);
  apart = copy;
  panel.changed.add(copy);
  change();
}

/** @param {Copy} copy @param {string[]} place */
function moveCopy(copy, place) { copy.moveTo(place); changed(copy); }
/** @param {Copy} copy @param {string} text */
function scaleCopy(copy, text) { copy.scaleTo(text); changed(copy); }

/** @param {Copy | null} copy */
function select(copy) { selected = copy; panel.mark(copy); ask(); }

/** The copies of the scene are others now. @param {Copy[]} others @param {Copy | null} chosen */
function take(others, chosen) {
  copies = others;
  apart = null;
  drawing.layer.clear();
  panel.list(copies);
  element("counts").textContent = `${several(copies.length, "copy", "copies")} of ${several(data.shapes.length, "shape")}`;
  select(chosen);
  change();
}

const panel = new Panel({
  select,
  scale: (text) => { if (selected) scaleCopy(selected, text); },
  move: (place) => { if (selected) moveCopy(selected, place); },
});

listenToHand(drawing, {
  copies: () => copies,
  selected: () => selected,
  select,
  move: moveCopy,
  scale: scaleCopy,
  begin: (copy) => { isHeld = true; apart = copy; change(); },
  end: () => { if (isHeld) { isHeld = false; change(); } },
  look: change,
  lead: (place) => { if (!isPinned) { robotAt = place; ask(); } },
  pin: () => { if (isPinned) unpin(); else { isPinned = true; ask(); } },
});

function unpin() { isPinned = false; ask(); }

/** Copies the scene as JSON. Tells so, or shows the text to be copied by hand. */
async function copyFile() {
  const text = fileOf(copies), told = element("copied");
  try {
    await navigator.clipboard.writeText(text);
    told.textContent = "Copied. Paste it to minkref scene -";
  } catch {
    const field = element("file", HTMLTextAreaElement);
    field.hidden = false;
    field.value = text;
    field.select();
    told.textContent = "The browser does not copy: take the text below.";
  }
}

listenTo(["contact-allowed", "contact-forbidden"], "change", change);
listenTo(["fit"], "click", () => { drawing.fit(copies); change(); });
listenTo(["copy-file"], "click", copyFile);
listenTo(["as-read"], "click", () => take(asRead.map((copy) => copy.clone()), null));
listenTo(["duplicate"], "click", () => {
  if (!selected) return;
  const twin = selected.clone();
  take([...copies, twin], twin);
});
listenTo(["remove"], "click", () => take(copies.filter((copy) => copy !== selected), null));
addEventListener("keydown", (event) => { if (event.key === "Escape") { unpin(); select(null); } });
addEventListener("resize", change);
onRecolour(() => { forget([element("situation"), element("robot")]); drawing.grid.recolour(); drawing.layer.clear(); change(); });

drawing.fit(copies);
take(copies, null);

// For tests and scripts.
Object.assign(window, { minkref: {
  get copies() { return copies.map(({ shape, scale, place }) => ({ shape, scale, place })); },
  get file() { return JSON.parse(fileOf(copies)); },
  get isChanged() { return copies.length !== asRead.length || copies.some((copy, i) => !copy.equals(asRead[i])); },
  get free() { return { names: drawing.grid.found, isFine: drawing.isFine, side: drawing.grid.side, hasSeams: drawing.grid.hasSeams }; },
  get robot() { return robot()?.situation.state ?? null; },
  get drawn() { return drawn; },
  holdOf: (/** @type {number} */ number, isHandle = false) => {
    const copy = copies[number];
    if (isHandle) select(copy);
    return isHandle ? drawing.handleOf(copy) : drawing.holdOf(copies, copy);
  },
  sums: () => copies.map(({ x, y, outline }) => outline.rings.map((ring) => Array.from(ring, (axis, i) => axis + (i % 2 ? y : x)))),
  change: (/** @type {number} */ copy, /** @type {string} */ text, /** @type {string[]} */ place) => { moveCopy(copies[copy], place); scaleCopy(copies[copy], text); },
  situation: (/** @type {number} */ x, /** @type {number} */ y) => situationAt(copies, x, y, 0).state,
  nameAt: (/** @type {number} */ x, /** @type {number} */ y) => drawing.nameAt(x, y),
  pixelOf: (/** @type {number} */ x, /** @type {number} */ y) => [drawing.screen.X(x), drawing.screen.Y(y)],
} });
