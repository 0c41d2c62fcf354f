// @ts-check
// The field, the slider, buttons, keys and colours of a page with a scale.
import { input, listenTo, onRecolour, onSlide } from "./elements.js";

/**
 * @typedef {object} Controls what the controls of a page do
 * @property {import("./explorer.js").Explorer} explorer
 * @property {import("./explorer.js").Keys} keys by name
 * @property {(text: string) => (() => void) | null} read what follows from a text in the field; null for no scale of the window
 * @property {() => void} fit
 * @property {string[]} redraw boxes that draw anew
 * @property {() => void} show
 * @property {() => void} recolour what colours change beside the layout
 * @property {() => void} layOut
 */

/** @param {Controls} controls */
export function listenToControls({ explorer, keys, read, fit, redraw, show, recolour, layOut }) {
  onSlide("slider", (share) => explorer.moveTo(explorer.way.axis.scaleAt(share)));
  listenTo(["previous"], "click", () => explorer.goPrevious());
  listenTo(["next"], "click", () => explorer.goNext());
  listenTo(["fit"], "click", () => { fit(); show(); });
  listenTo(redraw, "change", show);
  const field = input("scale");
  field.addEventListener("change", () => {
    const go = read(field.value);
    field.classList.toggle("bad", !go);
    go?.();
  });
  addEventListener("keydown", (event) => {
    if (event.target === field || event.ctrlKey || event.metaKey || event.altKey || !keys[event.key]) return;
    if (scrolls(event.target) && event.key !== "Escape" && !event.key.startsWith("Arrow")) return;
    event.preventDefault();
    keys[event.key](event);
  });
  addEventListener("resize", layOut);
  onRecolour(() => {
    recolour();
    layOut();
  });
}

/** Whether keys scroll it. @param {EventTarget | null} target */
const scrolls = (target) => target instanceof Element && ["barcode", "events"].includes(target.id);
