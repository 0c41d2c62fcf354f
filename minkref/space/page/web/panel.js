// @ts-check
// The panel beside the picture: the legend with its counts, exact facts, the update, what is chosen.
import { element, input, isChecked, node } from "../../../page/web/elements.js";
import { about, fraction, written } from "../../../page/web/fractions.js";
import { counted, several } from "../../../page/web/numbers.js";
import { frames, operands, present } from "./data.js";
import { exactPoint } from "./solid.js";
import { captionText, cutText, meaning, parentsText, scaleText, shapeText, signed } from "./texts.js";

/** @typedef {import("./data.js").Frame} Frame */
/** @typedef {import("./solid.js").Solid} Solid */

/** @param {() => void} changed */
export function buildLegend(changed) {
  for (const kind of present) {
    const box = node("input", { type: "checkbox", id: `show-${kind}`, checked: "" });
    box.addEventListener("change", changed);
    element("kinds").append(node("li", {}, node("label", {}, box, node("b", { class: `key ${kind.replace("+", "-")}` }),
      node("b", {}, kind), node("span", {}, meaning[kind]), node("output", { class: "many", id: `count-${kind}` }))));
  }
}
/** @param {string} kind */
export const isShown = (kind) => isChecked(`show-${kind}`);

/** @param {HTMLElement} list @param {string[][]} rows */
function facts(list, rows) {
  list.replaceChildren(...rows.flatMap(([name, value, title]) => [
    node("dt", {}, name), node("dd", title ? { title, class: "long" } : {}, value),
  ]));
}

/** @param {number} index */
export function tellFrame(index) {
  const frame = frames[index], slider = input("slider");
  element("scale").textContent = `S = ${scaleText(frame.scale)}`;
  element("scale").title = scaleText(frame.scale, true);
  element("number").textContent = `frame ${index + 1} of ${frames.length}`;
  element("caption").textContent = captionText(frame);
  slider.value = String(index);
  slider.setAttribute("aria-valuetext", `frame ${index + 1}, S = ${scaleText(frame.scale)}`);
  element("previous", HTMLButtonElement).disabled = index === 0;
  element("next", HTMLButtonElement).disabled = index === frames.length - 1;
  for (const kind of present) {
    const count = element(`count-${kind}`);
    count.textContent = counted(frame.kinds[kind]);
    count.closest("label")?.classList.toggle("none", !frame.kinds[kind]);
  }
  const volume = fraction(frame.volume);
  const exact = written(volume);
  facts(element("facts"), [
    ["volume", cutText(exact), exact],
    ...(exact.length > 10 ? [["", `≈ ${about(volume)}`]] : []),
    ...(frame.pairs ? [] : [["shape", shapeText(frame)]]),
    ["SHA-256", frame.digest, frame.digest],
  ]);
  tellStep(index);
  for (const [which, scaled] of /** @type {const} */ ([["P", true], ["Q", false]])) {
    const body = operands[which];
    element(`told-${which}`).textContent = `${which} = ${body.name.split("/").pop()}${scaled ? ", scaled" : ""}: ` +
      `${counted(body.points.length)} vertices, ${several(body.faces.length, "facet")}`;
  }
}

/** @param {number} index */
function tellStep(index) {
  const frame = frames[index], box = element("step");
  if (!frame.pairs || index === 0) {
    box.replaceChildren(node("p", {}, `Nothing: ${frame.pairs ? "the first" : "each"} frame is found from scratch.`));
    return;
  }
  const found = [several(frame.fv_errors, "fv-error"), several(frame.vf_errors, "vf-error"), several(frame.ee_errors, "ee-error")];
  const walked = `${several(frame.descent_steps, "descent step")}, ${several(frame.chains_walked, "chain")} walked`;
  box.replaceChildren(node("p", {}, `From frame ${index}, S = ${scaleText(frames[index - 1].scale)}: `,
    node("b", {}, found.join(", ")), `; ${walked}.`));
}

const MOST_CORNERS = 60;
/** @param {import("./data.js").Fraction[]} point */
const exactly = (point) => node("span", { class: "exact", title: `(${point.map(written).join(", ")})` },
  `(${point.map((number) => signed(cutText(written(number)))).join(", ")})`);

/** @typedef {{ what: string, number: number } | null} Chosen a facet or a vertex of the sum */

/** @type {(frame: Frame, picture: Solid, chosen: Chosen) => void} */
export function tellChosen(frame, picture, chosen) {
  element("clear", HTMLButtonElement).disabled = !chosen;
  for (const [what, count] of /** @type {const} */ ([["facet", frame.facets], ["vertex", frame.vertices]])) {
    input(what).value = chosen?.what === what ? String(chosen.number) : "";
    input(what).max = String(count - 1);
  }
  const told = !chosen ? [node("p", { class: "faint" }, "Click one in the picture, or type its number: its parents are marked in P and Q.")]
    : chosen.what === "vertex" ? tellVertex(frame, chosen.number) : tellFacet(frame, picture, chosen.number);
  element("chosen").replaceChildren(...told);
}

/** @param {Frame} frame @param {number} number */
function tellVertex(frame, number) {
  const [p, q] = frame.pairs?.slice(2 * number, 2 * number + 2) ?? [], point = exactPoint(frame, number);
  return [
    node("p", {}, node("b", {}, `vertex ${number}`), ...(frame.pairs ? [` = vertex ${p} of P + vertex ${q} of Q`] : [])),
    node("p", {}, exactly(point)), node("p", { class: "faint" }, `≈ (${point.map(about).join(", ")})`),
  ];
}

/** @param {Frame} frame @param {Solid} picture @param {number} number */
function tellFacet(frame, picture, number) {
  const ring = picture.outlines[number].flat(), parents = picture.parents[number], kind = picture.kinds[number];
  const corners = ring.slice(0, MOST_CORNERS).map((vertex) =>
    node("li", {}, node("span", { class: "faint" }, `vertex ${vertex} ${frame.pairs ? `= ${frame.pairs[2 * vertex]} + ${frame.pairs[2 * vertex + 1]} ` : ""}`),
      exactly(exactPoint(frame, vertex))));
  if (ring.length > MOST_CORNERS) corners.push(node("li", {}, `and ${ring.length - MOST_CORNERS} more`));
  return [
    node("p", {}, node("b", {}, `facet ${number}: ${kind}`), `${parents.length > 1 ? " in the plane of" : " ="} ${parentsText(parents, MOST_CORNERS, ", ")}`),
    node("p", { class: "faint" }, `${several(ring.length, "corner")}, as vertices of the sum${frame.pairs ? " = of P + of Q" : ""}:`), node("ol", {}, ...corners),
  ];
}
