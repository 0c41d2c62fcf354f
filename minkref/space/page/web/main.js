// @ts-check
// The controls, and the three pictures that follow them.
import { element, input, isChecked, listenTo, onRecolour, onSlide, tip } from "../../../page/web/elements.js";
import { several } from "../../../page/web/numbers.js";
import { section, wantedCut } from "./cut.js";
import { frames, operands, present } from "./data.js";
import { buildAxis, tellEvents } from "./events.js";
import { buildLegend, isShown, tellChosen, tellFrame } from "./panel.js";
import { chosenMark, config, drawnLength, edgeLines, facets, home, layout, SEEN_HEIGHT, vertexMarks, views } from "./scene.js";
import { exactPoint, operandSolid, sumSolid } from "./solid.js";
import { tipText } from "./texts.js";

/** @typedef {import("./data.js").Frame} Frame */
/** @typedef {import("./solid.js").Solid} Solid */
/** @typedef {import("./scene.js").Camera} Camera */
/** @typedef {"sum" | import("./data.js").Which} Name of a picture */
/** @typedef {HTMLElement & { on: (type: string, heard: (event: any) => void) => void }} Plot */

const { Plotly } = /** @type {any} */ (window);
/** @type {Name[]} */
const names = ["sum", "P", "Q"];
const plots = { sum: plotOf("sum"), P: plotOf("P"), Q: plotOf("Q") };
const MARGIN = 1.06;
let index = 0;
/** @type {import("./panel.js").Chosen} */
let chosen = null;
let camera = home;
let pictures = picturesOf(frames[0]);
let cut = wantedCut(frames[0], pictures.sum);
/** @type {{ again: boolean, done: Promise<void> } | null} */
let pending = null;
let isTurning = false;
/** @type {[Name | null, Name | null]} the picture that looks the wanted way already, and the one under the pointer */
let [wanted, held] = [null, null];

/** @param {Name} name */
function plotOf(name) {
  return /** @type {Plot} */ (element(`plot-${name}`));
}

/** @param {Frame} frame @returns {Record<Name, Solid>} */
function picturesOf(frame) {
  return { sum: sumSolid(frame), P: operandSolid(frame, "P"), Q: operandSolid(frame, "Q") };
}

/** Half the sides of the box of all frames, in the unit of a frame; null where a size is beyond doubles. @param {Frame} frame */
function commonHalves(frame) {
  const { size } = frame, sizes = frames.map((one) => one.size ?? NaN);
  if (size === null || sizes.some(Number.isNaN)) return null;
  return [0, 1, 2].map((i) => Math.max(...frames.map(({ P, Q }, k) => ((P[i] + Q[i]) * sizes[k]) / size)) / 2);
}

/** @param {Frame} frame */
function sumHalves(frame) {
  const halves = isChecked("fitted") ? null : commonHalves(frame);
  const own = halves ?? pictures.sum.sides.map((side) => side / 2);
  const least = 0.02 * Math.max(...own);
  return own.map((half) => half * MARGIN + least);
}

/** @param {Name} name @param {Frame} frame */
function halvesOf(name, frame) {
  if (name === "sum") return sumHalves(frame);
  const body = pictures[name];
  if (!isChecked("one-unit")) return body.sides.map((side) => (side / 2) * MARGIN + 0.02);
  return sumHalves(frame).map((half) => half / (body.share || 1));
}

/** What is marked in a picture: lists of vertices. @param {Name} name @returns {number[][]} */
function marked(name) {
  if (!chosen) return [];
  const { what, number } = chosen, { pairs } = frames[index];
  if (what === "vertex") {
    if (name === "sum") return [[number]];
    return pairs ? [[pairs[2 * number + (name === "P" ? 0 : 1)]]] : [];
  }
  if (name === "sum") return pictures.sum.outlines[number];
  const { faces, numbers } = operands[name];
  const found = new Map(pictures.sum.parents[number].map((pair) => [pair[name].join(), pair[name]]));
  return [...found].map(([text, vertices]) => (vertices.length > 2 ? faces[numbers.get(text) ?? -1] : vertices));
}

/** @param {Name} name @param {number[]} halves @param {number} share */
function traces(name, halves, share) {
  const body = pictures[name], isSum = name === "sum", here = isSum ? cut : null;
  const drawn = isSum ? present : [name === "P" ? "fv" : "vf"];
  const pixels = Math.max((plots[name].clientHeight * 0.5 * drawnLength(halves, share)) / SEEN_HEIGHT, 1);
  return [
    ...drawn.map((kind) => facets(body, kind, !isSum || isShown(kind), here)),
    ...section(body, here, pixels),
    edgeLines(body, pixels, isChecked("show-edges"), here), vertexMarks(body, pixels, isChecked("show-vertices"), here),
    chosenMark(body, pixels, marked(name)),
  ];
}

async function draw() {
  const frame = frames[index];
  for (const name of names) {
    const axes = name === "sum" && isChecked("show-axes") ? frame : null;
    const halves = halvesOf(name, frame), share = Math.min(plots[name].clientWidth / plots[name].clientHeight, 1) || 1;
    await Plotly.react(plots[name], traces(name, halves, share), layout(halves, axes, camera, share), config);
  }
}

/** One drawing at a time; what changes meanwhile is drawn after it. */
function redraw() {
  if (pending) {
    pending.again = true;
    return pending.done;
  }
  const mine = { again: false, done: Promise.resolve() };
  pending = mine;
  mine.done = (async () => {
    do {
      mine.again = false;
      await draw();
    } while (mine.again);
    pending = null;
  })();
  return mine.done;
}

/** @param {number} wish */
function show(wish) {
  const next = Math.min(Math.max(Math.round(wish), 0), frames.length - 1), frame = frames[next];
  if (next !== index) {
    index = next;
    chosen = null;
    pictures = picturesOf(frame);
  }
  tip("");
  cut = wantedCut(frame, pictures.sum);
  tellFrame(index);
  tellEvents(index);
  tellChosen(frame, pictures.sum, chosen);
  return redraw();
}

/** @param {string} what @param {number} number */
function choose(what, number) {
  const frame = frames[index], count = what === "facet" ? frame.facets : frame.vertices;
  chosen = Number.isInteger(number) && number >= 0 && number < count ? { what, number } : null;
  tellChosen(frame, pictures.sum, chosen);
  return redraw();
}

/** Turns the chosen to the front: its parents face the same way. */
function face() {
  if (!chosen) return;
  const { what, number } = chosen, body = pictures.sum;
  const towards = what === "facet" ? body.normals[number] : body.outward[number];
  const { eye, center } = camera;
  const far = Math.hypot(eye.x - center.x, eye.y - center.y, eye.z - center.z);
  const [x, y, z] = towards.map((axis) => axis * far);
  const up = Math.abs(towards[2]) > 0.98 ? { x: 0, y: 1, z: 0 } : home.up;
  turn({ ...home, up, eye: { x, y, z } });
}

/**
 * All pictures look the same way; `from` already does. A turn asked for meanwhile is done after.
 * @param {Camera} way
 * @param {Name | null} from
 */
async function turn(way, from = null) {
  camera = way;
  wanted = from;
  tip("");
  if (isTurning) return;
  isTurning = true;
  let done = null;
  while (done !== camera) {
    await new Promise(requestAnimationFrame);
    done = camera;
    for (const name of names) {
      if (name !== wanted) await Plotly.relayout(plots[name], { "scene.camera": done });
    }
  }
  isTurning = false;
}

/** The facet or vertex that an event of a picture means. @param {any} event */
function pointed(event) {
  const point = event.points?.[0], meta = point && (point.data ?? point.fullData).meta;
  if (!meta?.numbers) return null;
  return { what: /** @type {string} */ (meta.what), number: /** @type {number} */ (meta.numbers[point.pointNumber]) };
}

/** @param {Name} name */
function listen(name) {
  const plot = plots[name];
  let mouse = { clientX: 0, clientY: 0 };
  /** @type {MouseEvent | null} */
  let pressed = null;
  /** @type {ReturnType<typeof pointed>} */
  let under = null;
  /** @param {string} type @param {(event: MouseEvent) => void} heard */
  const on = (type, heard) => plot.addEventListener(type, (event) => heard(/** @type {MouseEvent} */ (event)), true);
  on("pointermove", (event) => { mouse = event; });
  on("pointerenter", () => { held = name; });
  on("pointerdown", (event) => {
    held = name;
    pressed = event;
    tip("");
  });
  const leave = () => {
    under = null;
    tip("");
  };
  on("pointerleave", leave);
  on("click", ({ clientX, clientY }) => {
    const isStill = pressed && Math.hypot(clientX - pressed.clientX, clientY - pressed.clientY) < 4;
    if (isStill && under && name === "sum") choose(under.what, under.number);
  });
  plot.on("plotly_hover", (event) => {
    under = pointed(event);
    tip(under ? tipText(name, pictures[name], frames[index], under.what, under.number) : "", mouse);
  });
  plot.on("plotly_unhover", leave);
  // Only the picture that is being turned leads.
  for (const type of ["plotly_relayouting", "plotly_relayout"]) {
    plot.on(type, (changes) => {
      if (changes["scene.camera"] && held === name) turn(changes["scene.camera"], name);
    });
  }
}

buildLegend(redraw);
buildAxis(show);
const isAlone = frames.length === 1, isConvex = !!frames[0].pairs, sort = isConvex ? "convex polyhedra" : "polyhedra";
document.body.classList.toggle("still", isAlone);
element("counts").textContent = isAlone ? `Minkowski sum of ${sort}, exact`
  : `Minkowski sums of ${sort}, exact, at ${several(frames.length, "scale")}${isConvex ? ", each got from the one before" : ""}`;
input("slider").max = String(frames.length - 1);
input("fitted").disabled = frames.some(({ size }) => size === null);
onSlide("slider", show);
listenTo(["previous"], "click", () => show(index - 1));
listenTo(["next"], "click", () => show(index + 1));
listenTo(["show-edges", "show-vertices", "show-axes", "fitted", "one-unit"], "change", redraw);
for (const what of ["facet", "vertex"]) {
  listenTo([what], "change", () => {
    const { value } = input(what);
    choose(what, value === "" ? NaN : Number(value)).then(face);
  });
}
listenTo(["cut-axis", "cut", "cut-flip"], "input", () => {
  cut = wantedCut(frames[index], pictures.sum);
  redraw();
});
listenTo(["clear"], "click", () => choose("facet", NaN));
for (const [name, eye] of Object.entries(views)) {
  const up = name === "z" ? { x: 0, y: 1, z: 0 } : home.up;
  document.querySelector(`[data-view="${name}"]`)?.addEventListener("click", () => turn({ ...home, up, eye }));
}
onRecolour(redraw);

Object.assign(window, { minkref: {
  show, choose, frames, operands, exactPoint, get index() { return index; },
  ready: show(0).then(() => names.forEach(listen)),
} });
