// @ts-check
// The list of bounds, ascending.
import { element, revealIn } from "../../../page/web/elements.js";
import { cut, short } from "../../../page/web/numbers.js";
import { cell, fillTable, line, remark } from "../../../page/web/tables.js";
import { data } from "./data.js";
import { boundColour, exactAndAbout, featureText } from "./texts.js";

export const boundList = {
  /** @type {HTMLTableRowElement[]} */
  rows: [],

  /** @param {(bound: number) => void} choose */
  fill(choose) {
    this.rows = data.bounds.map(({ scale, event, part, obstacle, at, about }, i) => line([
      cell(exactAndAbout(cut(scale), about.scale)), cell(event, { class: boundColour[event] }), cell(featureText(part)),
      cell(featureText(obstacle)), cell(`segment ${at.segment}, t = ${short(about.t, 4)}`),
    ], () => choose(i)));
    const none = data.valid.length ? "None: all scales are valid." : "None: no scale is valid.";
    fillTable("events", this.rows.length ? this.rows : [remark(none, 5)]);
  },

  /** @param {number} bound */
  show(bound) {
    this.rows.forEach((row, i) => row.classList.toggle("here", i === bound));
    if (bound >= 0) revealIn(element("events"), this.rows[bound]);
  },
};
