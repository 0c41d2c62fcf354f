// @ts-check
// What a hand does in the picture: drags a copy or its handle, moves and zooms the view, leads the robot.
import { placeIn } from "../../../page/web/elements.js";
import { exponentBelow, roundedText } from "./exact_text.js";
import { cornerOf } from "./drawing.js";

/** @typedef {import("./drawing.js").Drawing} Drawing */
/** @typedef {import("./scene.js").Copy} Copy */
/**
 * @typedef {object} Deeds what follows from it
 * @property {() => Copy[]} copies
 * @property {() => Copy | null} selected
 * @property {(copy: Copy | null) => void} select
 * @property {(copy: Copy) => void} begin to drag
 * @property {(copy: Copy, place: string[]) => void} move
 * @property {(copy: Copy, scale: string) => void} scale
 * @property {() => void} end
 * @property {() => void} look the view changed
 * @property {(place: { x: number, y: number } | null) => void} lead the robot
 * @property {() => void} pin the robot where it is
 */

/** @param {Drawing} drawing @param {Deeds} deeds */
export function listenToHand(drawing, deeds) {
  const { canvas } = drawing;
  /** @type {((at: number[]) => void) | null} */
  let drag = null;
  /** @type {number[]} */
  let start = [0, 0];
  let isMoved = false;

  canvas.addEventListener("pointerdown", (event) => {
    if (event.button !== 0) return;
    start = placeIn(event, canvas);
    isMoved = false;
    canvas.setPointerCapture(event.pointerId);
    const selected = deeds.selected();
    if (selected && drawing.isHandleAt(selected, start)) {
      deeds.begin(selected);
      drag = dragHandle(drawing, deeds, selected);
      return;
    }
    const copy = drawing.copyAt(deeds.copies(), start);
    if (copy) {
      deeds.select(copy);
      deeds.begin(copy);
      drag = dragCopy(drawing, deeds, copy, start);
    } else {
      drag = dragView(drawing, deeds, start);
    }
  });
  canvas.addEventListener("pointermove", (event) => {
    const at = placeIn(event, canvas);
    if (drag && event.buttons & 1) {
      isMoved = isMoved || Math.hypot(at[0] - start[0], at[1] - start[1]) > 3;
      if (isMoved) drag(at);
      return;
    }
    deeds.lead(drawing.worldAt(at));
    const selected = deeds.selected(), isHandle = selected && drawing.isHandleAt(selected, at);
    canvas.style.cursor = isHandle ? "nwse-resize" : drawing.copyAt(deeds.copies(), at) ? "move" : "grab";
  });
  const stop = () => { drag = null; deeds.end(); };
  canvas.addEventListener("pointerup", (event) => {
    if (drag && !isMoved) {
      deeds.lead(drawing.worldAt(placeIn(event, canvas)));
      if (!drawing.copyAt(deeds.copies(), start)) deeds.pin();
    }
    stop();
  });
  canvas.addEventListener("pointercancel", stop);
  canvas.addEventListener("pointerleave", () => { if (!drag) deeds.lead(null); });
  canvas.addEventListener("wheel", (event) => {
    event.preventDefault();
    const at = placeIn(event, canvas), turn = event.deltaY || event.deltaX;
    const copy = event.shiftKey ? drawing.copyAt(deeds.copies(), at) ?? deeds.selected() : null;
    if (copy) turnWheel(deeds, copy, turn); else if (!event.shiftKey) zoom(drawing, deeds, at, turn);
  }, { passive: false });
}

/** @type {(drawing: Drawing, deeds: Deeds, copy: Copy, start: number[]) => (at: number[]) => void} */
function dragCopy(drawing, deeds, copy, [x, y]) {
  const from = { x: copy.x, y: copy.y };
  return ([u, v]) => {
    const { unit } = drawing.view, exponent = exponentBelow(0.5 / unit);
    deeds.move(copy, [roundedText(from.x + (u - x) / unit, exponent), roundedText(from.y - (v - y) / unit, exponent)]);
  };
}

/** @type {(drawing: Drawing, deeds: Deeds, copy: Copy) => (at: number[]) => void} */
function dragHandle(drawing, deeds, copy) {
  const [x, y] = cornerOf(copy), square = x * x + y * y;
  return (at) => {
    const place = drawing.worldAt(at), s = ((place.x - copy.x) * x + (place.y - copy.y) * y) / square;
    const exponent = exponentBelow(0.5 / drawing.view.unit / Math.sqrt(square));
    deeds.scale(copy, copy.clamped(roundedText(Math.max(s, 0), exponent)));
  };
}

/** @type {(drawing: Drawing, deeds: Deeds, start: number[]) => (at: number[]) => void} */
function dragView(drawing, deeds, [x, y]) {
  const from = drawing.view;
  return ([u, v]) => {
    drawing.view = { unit: from.unit, x: from.x - (u - x) / from.unit, y: from.y + (v - y) / from.unit };
    deeds.look();
  };
}

/** @type {(deeds: Deeds, copy: Copy, turn: number) => void} */
function turnWheel(deeds, copy, turn) {
  const s = copy.s * Math.exp(-turn * 0.0005);
  deeds.scale(copy, copy.clamped(roundedText(s, exponentBelow(s) - 3)));
}

/** @type {(drawing: Drawing, deeds: Deeds, at: number[], turn: number) => void} */
function zoom(drawing, deeds, at, turn) {
  const before = drawing.worldAt(at), { view } = drawing;
  drawing.view = { ...view, unit: view.unit * Math.exp(-turn * 0.0015) };
  const after = drawing.worldAt(at);
  drawing.view = { ...drawing.view, x: view.x + before.x - after.x, y: view.y + before.y - after.y };
  deeds.look();
}
