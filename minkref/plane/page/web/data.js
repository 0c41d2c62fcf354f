// @ts-check
// The data of the page (docs/command-line.md, "minkref view"), and the axis of its scales.
import { logarithmicAxis } from "../../../page/web/axis.js";
import { dataOf } from "../../../page/web/elements.js";

/** @typedef {import("../../../page/web/barcode.js").Life} Life */
/** @typedef {number[][][]} Operand polygons, each the rings x, y, x, y, ..., the outer one first */
/** @typedef {[number, string, string, number[], number[], unknown, number[]]} Change event, feature, change, numbers before and after, parts, place */
/** @typedef {{ scale: string, about: number, change: string, a: string, b: string }} PairEvent */
/**
 * @typedef {object} Step of the paper's own program
 * @property {string} scale
 * @property {number} about
 * @property {boolean} right
 * @property {string} words
 * @property {[number, number] | null} witness
 * @property {Operand | null} lost
 * @property {Operand | null} added
 */
/**
 * @typedef {object} Run of the paper's own program
 * @property {string} arithmetic
 * @property {Record<string, string>} readings
 * @property {Record<"missed" | "invented" | "right" | "misplaced", number>} events
 * @property {PairEvent[]} missed
 * @property {PairEvent[]} invented
 * @property {Step[]} steps
 */
/**
 * @typedef {object} Data
 * @property {[string, number][]} window
 * @property {Operand} P
 * @property {Operand} Q
 * @property {number[]} S
 * @property {number[]} T
 * @property {string[]} scales
 * @property {number[]} about
 * @property {string} kinds
 * @property {number[]} places
 * @property {Record<number, number[][]> | null} passages
 * @property {Change[]} topology
 * @property {(Life | null)[]} holes
 * @property {(Life | null)[]} components
 * @property {number[]} tracks
 * @property {Record<string, number>} centres
 * @property {any[][]} states
 * @property {Run} [paper]
 * @property {boolean} [erode] P is what is outside of a set: a box around it comes first
 */

/** @type {Data} */
export const data = dataOf("data");
export const axis = logarithmicAxis(data.window[0][1], data.window[1][1]);
/** @param {number} event */
export const isInside = (event) => event >= 0 && event < data.scales.length;
