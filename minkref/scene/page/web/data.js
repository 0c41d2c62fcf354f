// @ts-check
// The data of the page (docs/command-line.md, "minkref view of a scene").
import { dataOf } from "../../../page/web/elements.js";

/** @typedef {number[][][]} Operand polygons, each the rings x, y, x, y, ..., the outer one first */
/** @typedef {{ rings: Operand, set: unknown }} Drawn a set as drawn, and exactly, for the file of a scene */
/** @typedef {Drawn & { name: string, sum: number | null }} Shape `sum`: its number; null for a shape without copies */
/** @typedef {Record<string, number[][]>} Passages x, y, x, y, ... of each, by the exact scale of the sum */
/** @typedef {import("../../../page/web/timeline.js").RingData & { window: [string, number][], passages: Passages | null }} Sum */
/**
 * @typedef {object} Data
 * @property {Drawn} robot
 * @property {Shape[]} shapes
 * @property {Sum[]} sums
 * @property {[number, string, string, string][]} copies shape, scale, x and y, exact
 */

/** @type {Data} */
export const data = dataOf("data");
