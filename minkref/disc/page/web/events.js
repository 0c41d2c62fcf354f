// @ts-check
// The list of events in the window; saddles, ridges and maxima, or all of them.
import { isChecked } from "../../../page/web/elements.js";
import { counted } from "../../../page/web/numbers.js";
import { cell, fillTable, keepInSight, line, remark } from "../../../page/web/tables.js";
import { changes, data, endInside, firstEvents, firstInside, radiusOf } from "./data.js";
import { changeText, isTopology, kindColours, kindNames, radiusText } from "./texts.js";

const MOST_ROWS = 2000;

export const eventList = {
  /** @type {HTMLTableRowElement[]} */
  rows: [],  // of the table
  /** @type {number[]} */
  events: [],  // of each row

  /** @param {(event: number) => void} goTo */
  fill(goTo) {
    const all = isChecked("show-all"), wanted = [];
    for (let event = firstEvents[firstInside]; event < firstEvents[endInside]; ++event) {
      if (all || isTopology(event)) wanted.push(event);
    }
    this.events = wanted.slice(0, MOST_ROWS);
    this.rows = this.events.map((event) => {
      const kind = data.kinds[event], does = changes.get(event) ?? [];
      const cells = [cell(radiusText(radiusOf(event), 6)), cell(kindNames[kind], { class: kindColours[kind] ?? "" }), cell(does.map(changeText).join("; "))];
      return line(cells, () => goTo(event));
    });
    const more = wanted.length > MOST_ROWS ? [remark(`… ${counted(wanted.length - MOST_ROWS)} more: take a narrower window.`, 3)] : [];
    fillTable("events", wanted.length ? [...this.rows, ...more] : [remark("None in this window.", 3)]);
  },

  /**
   * Marks those at the radius where the page stands, or the chosen one, and scrolls to the first after it.
   * @param {number} radius
   * @param {number} at its number
   * @param {number | null} chosen
   */
  show(radius, at, chosen) {
    this.rows.forEach((row, i) => {
      const event = this.events[i];
      row.classList.toggle("here", chosen === null ? radiusOf(event) === at : event === chosen);
    });
    if (!this.rows.length) return;
    let i = chosen === null ? -1 : this.events.indexOf(chosen);
    if (i < 0) i = this.events.findIndex((event) => data.radii[radiusOf(event)] >= radius);
    keepInSight("events", this.rows[i < 0 ? this.rows.length - 1 : i]);
  },
};
