// @ts-check
// The chosen copy in numbers, and the list of all copies.
import { element, input } from "../../../page/web/elements.js";
import { clamped, counted, cut } from "../../../page/web/numbers.js";
import { cell, fillTable, keepInSight, line, remark } from "../../../page/web/tables.js";
import { exponentBelow, numberOf, roundedText } from "./exact_text.js";

/** @typedef {import("./scene.js").Copy} Copy */
/**
 * @typedef {object} Wishes what a hand asks for in the panel
 * @property {(copy: Copy) => void} select
 * @property {(scale: string) => void} scale of the chosen copy, in the window
 * @property {(place: string[]) => void} move the chosen copy
 */

const MOST_ROWS = 1000;
const FIELDS = ["copy-scale", "copy-x", "copy-y"];

export class Panel {
  /** @param {Wishes} wishes */
  constructor(wishes) {
    this.wishes = wishes;
    /** @type {Copy | null} */
    this.copy = null;
    /** @type {Map<Copy, HTMLTableRowElement>} */
    this.rows = new Map();
    /** @type {Set<Copy>} */
    this.changed = new Set();  // whose numbers the list does not have yet
    this.listen();
  }

  listen() {
    this.read("copy-scale", (text) => {
      if (!this.copy?.has(numberOf(text))) return false;
      this.wishes.scale(text);
      return true;
    });
    for (const id of ["copy-x", "copy-y"]) {
      this.read(id, (text) => {
        if (!this.copy || !Number.isFinite(numberOf(text))) return false;
        const [x, y] = this.copy.place;
        this.wishes.move(id === "copy-x" ? [text, y] : [x, text]);
        return true;
      });
    }
    const slider = input("copy-slider");
    slider.addEventListener("input", () => {
      if (!this.copy) return;
      const [[low, first], [high, last]] = this.copy.sum.window, share = clamped(Number(slider.value), 0, 1);
      const s = first * Math.exp(share * Math.log(last / first));
      this.wishes.scale(share === 0 ? low : share === 1 ? high : this.copy.clamped(roundedText(s, exponentBelow(s) - 3)));
    });
  }

  /** A field is read when it is left; what it refuses is marked. @param {string} id @param {(text: string) => boolean} take */
  read(id, take) {
    const field = input(id);
    field.addEventListener("change", () => field.classList.toggle("bad", !take(field.value.trim())));
  }

  /** The chosen copy in the fields. @param {Copy | null} copy @param {Copy[]} copies */
  show(copy, copies) {
    this.copy = copy;
    element("copy-fields", HTMLFieldSetElement).disabled = !copy;
    element("copy-name").textContent = copy ? `Copy ${counted(copies.indexOf(copy))}: ${copy.name}` : "Click a copy to choose it.";
    const texts = copy ? [copy.scale, ...copy.place] : ["", "", ""];
    FIELDS.forEach((id, i) => {
      const field = input(id);
      if (document.activeElement === field && field.classList.contains("bad")) return;
      field.value = texts[i];
      field.classList.remove("bad");
    });
    if (!copy) return;
    const [[low, first], [high, last]] = copy.sum.window;
    input("copy-slider").value = String(Math.log(copy.s / first) / Math.log(last / first));
    element("copy-window").textContent = `${cut(low)} to ${cut(high)}`;
  }

  /** All copies. @param {Copy[]} copies */
  list(copies) {
    this.rows.clear();
    copies.slice(0, MOST_ROWS).forEach((copy, number) => {
      const cells = [cell(String(number)), cell(copy.name), cell(""), cell("")];
      this.rows.set(copy, line(cells, () => this.wishes.select(copy)));
      this.tell(copy);
    });
    const more = copies.length - MOST_ROWS;
    const last = more > 0 ? [remark(`and ${counted(more)} more`, 4)] : copies.length ? [] : [remark("There is no copy.", 4)];
    fillTable("events", [...this.rows.values(), ...last]);
  }

  /** Brings the list up to date; not at each frame, for a table's layout takes long. */
  tellChanged() {
    for (const copy of this.changed) this.tell(copy);
    this.changed.clear();
  }

  /** A copy's numbers in the list. @param {Copy} copy */
  tell(copy) {
    const row = this.rows.get(copy);
    if (!row) return;
    row.cells[2].textContent = cut(copy.scale);
    row.cells[3].textContent = copy.place.map((text) => cut(text)).join(", ");
  }

  /** Marks the chosen copy in the list. @param {Copy | null} copy */
  mark(copy) {
    for (const [each, row] of this.rows) row.classList.toggle("here", each === copy);
    const row = copy && this.rows.get(copy);
    if (row) keepInSight("events", row);
  }
}
