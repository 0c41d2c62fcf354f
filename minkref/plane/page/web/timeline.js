// @ts-check
// The rings of the page's sum at any scale of the window.
import { Timeline } from "../../../page/web/timeline.js";
import { data } from "./data.js";

export const timeline = new Timeline(data);
/** @param {number} track @param {number} s */
export const xOf = (track, s) => timeline.x(track, s);
/** @param {number} track @param {number} s */
export const yOf = (track, s) => timeline.y(track, s);
