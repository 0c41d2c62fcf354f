// @ts-check
// Lists as tables, each line a way to somewhere.
import { element, node } from "./elements.js";

/** @param {string} text @param {Record<string, string>} attributes */
export const cell = (text, attributes = {}) => node("td", attributes, text);

/** @param {HTMLTableCellElement[]} cells @param {() => void} go */
export function line(cells, go) {
  const made = node("tr", {}, ...cells);
  made.addEventListener("click", go);
  return made;
}

/** A line that only says something. @param {string} text @param {number} columns */
export const remark = (text, columns) => node("tr", {}, node("td", { colspan: columns }, text));

/** Puts lines into the body of the table in a box. @param {string} id @param {Node[]} lines */
export const fillTable = (id, lines) => element(id).querySelector("tbody")?.replaceChildren(...lines);

/** Scrolls a box so that a line is in its middle, unless it is seen well. @param {string} id @param {HTMLElement} row */
export function keepInSight(id, row) {
  const box = element(id), top = row.offsetTop;
  if (top < box.scrollTop + 30 || top > box.scrollTop + box.clientHeight - 30) box.scrollTop = top - box.clientHeight / 2;
}
