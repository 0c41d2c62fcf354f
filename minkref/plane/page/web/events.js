// @ts-check
// The list of topology events.
import { short } from "../../../page/web/numbers.js";
import { cell, fillTable, keepInSight, line, remark } from "../../../page/web/tables.js";
import { data } from "./data.js";
import { tellChange } from "./texts.js";

export const eventList = {
  /** @type {HTMLTableRowElement[]} */
  rows: [],  // of each topology event

  /** @param {(change: import("./data.js").Change) => void} goTo */
  fill(goTo) {
    this.rows = data.topology.map((row) => {
      const [event, , change] = row, which = cell("");
      tellChange(which, row);
      const scale = cell(short(data.about[event]), { title: data.scales[event] });
      return line([scale, cell(change, { class: change }), which], () => goTo(row));
    });
    fillTable("events", this.rows.length ? this.rows : [remark("None in this window.", 3)]);
  },

  /** Marks those at the event where the page stands; scrolls to the first after the scale. @param {number} s @param {number} event */
  show(s, event) {
    this.rows.forEach((row, i) => row.classList.toggle("here", data.topology[i][0] === event));
    if (!this.rows.length) return;
    const i = data.topology.findIndex(([at]) => data.about[at] >= s);
    keepInSight("events", this.rows[i < 0 ? this.rows.length - 1 : i]);
  },
};
