// @ts-check
// The data of the page (docs/command-line.md, "minkref view with a path"): part, obstacles and path, the bad polygons,
// the valid scales and their bounds.
import { linearAxis } from "../../../page/web/axis.js";
import { dataOf } from "../../../page/web/elements.js";

/** @typedef {[number, number]} Point */
/** @typedef {Record<string, [number, number]>} Feature its kind, with ring and number */
/** @typedef {{ segment: number, t: string, point: string[] }} Place */
/**
 * @typedef {object} Bound
 * @property {string} scale
 * @property {"blocks" | "frees"} event
 * @property {Feature} part
 * @property {Feature} obstacle
 * @property {Place} at
 * @property {string[]} touching
 * @property {{ scale: number, t: number, point: Point, touching: Point }} about
 */
/** @typedef {{ from: string, to: string | null, from_in: boolean, to_in: boolean, about: [number, number | null] }} Range */
/**
 * @typedef {object} Data
 * @property {"allowed" | "forbidden"} contact
 * @property {[string, number][]} window
 * @property {number[][][]} part
 * @property {number[][][]} obstacles
 * @property {number[]} path
 * @property {Range[]} valid
 * @property {Bound[]} bounds
 * @property {{ part: number[][], obstacles: number[][] }} pieces
 * @property {number[][]} polygons
 */

/** @type {Data} */
export const data = dataOf("data");
export const axis = linearAxis(data.window[0][1], data.window[1][1]);
export const scalesOfBounds = data.bounds.map(({ about }) => about.scale);
/** Whether there is such a bound in the window. @param {number} bound */
export const isInside = (bound) => bound in scalesOfBounds && axis.has(scalesOfBounds[bound]);
