// @ts-check
// The free space and the robot in words.
import { node, swatch } from "../../../page/web/elements.js";
import { several, short } from "../../../page/web/numbers.js";
import { fillOf } from "./grid.js";

const MOST_NAMES = 8;
const STATES = { free: "free", touching: "touching", blocked: "not free" };

/** @type {WeakMap<Element, string>} */
const told = new WeakMap();  // what each box says, so that it is written only where that changes

/** Whether a box says something else so far. @param {Element} box @param {unknown[]} said */
function isNew(box, ...said) {
  const key = said.join();
  if (told.get(box) === key) return false;
  told.set(box, key);
  return true;
}

/** Writes all boxes anew the next time: colours changed. @param {Element[]} boxes */
export const forget = (boxes) => boxes.forEach((box) => told.delete(box));

/** @param {number} name */
const nameOf = (name) => (name === 0 ? "the outside" : `part ${name}`);

/** "3 free parts, by pixels: the outside, part 1, part 4". @param {Element} box @param {number[]} names @param {string} contact @param {boolean} isFine */
export function tellFree(box, names, contact, isFine) {
  if (!isNew(box, names, contact, isFine)) return;
  const said = contact === "allowed" ? "different colours are apart" : "one colour is connected";
  box.replaceChildren(
    node("b", {}, several(names.length, "free part")), " ",
    node("small", {}, `by ${isFine ? "" : "coarse "}pixels, ${said}`), " ",
  );
  names.toSorted((a, b) => a - b).slice(0, MOST_NAMES).forEach((name) => {
    box.append(node("span", { class: "name" }, swatch(fillOf(name)), nameOf(name)), " ");
  });
  if (names.length > MOST_NAMES) box.append("…");
}

/**
 * @param {Element} box
 * @param {{ x: number, y: number, isPinned: boolean, situation: import("./robot.js").Situation } | null} robot
 * @param {number} name of the free component there, or -1
 * @param {import("./scene.js").Copy[]} copies
 */
export function tellRobot(box, robot, name, copies) {
  const met = robot?.situation.copies.map((copy) => copies.indexOf(copy)) ?? [];
  if (!isNew(box, robot?.x, robot?.y, robot?.isPinned, robot?.situation.state, name, met)) return;
  if (!robot) { box.replaceChildren("Point at a place to see the robot there; click free space to pin it."); return; }
  const { x, y, isPinned, situation: { state } } = robot;
  box.replaceChildren(
    `Robot ${isPinned ? "pinned " : ""}at (${short(x)}, ${short(y)}): `,
    node("b", { class: `robot-${state}` }, STATES[state]),
  );
  if (met.length) {
    const listed = met.slice(0, 3).map((copy) => `copy ${copy} (${copies[copy].name})`).join(", ");
    box.append(`, ${state === "blocked" ? "meets" : "touches"} ${listed}${met.length > 3 ? ` and ${met.length - 3} more` : ""}`);
  } else if (name >= 0) {
    box.append(", in ", node("span", { class: "name" }, swatch(fillOf(name)), nameOf(name)));
  }
}
