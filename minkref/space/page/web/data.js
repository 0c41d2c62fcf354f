// @ts-check
// The data of the page (docs/command-line.md, "minkref view in space"): the operands, the frames and the events.
import { dataOf } from "../../../page/web/elements.js";
import { fraction } from "../../../page/web/fractions.js";

/** @typedef {number[]} Point in doubles */
/** @typedef {[number, number, number]} Triangle vertices by number */
/** @typedef {import("../../../page/web/fractions.js").Fraction} Fraction */
/** @typedef {{ P: number[], Q: number[] }} Pair faces of P and Q, by their vertices, ascending */
/** @typedef {{ name: string, points: string[][], near: Point[], faces: number[][], triangles?: Triangle[][] }} Operand */
/**
 * @typedef {object} Row of a frame
 * @property {string[]} scale
 * @property {string} digest
 * @property {string} volume
 * @property {number} vertices
 * @property {number} edges
 * @property {number} facets
 * @property {Record<string, number>} kinds
 * @property {number} fv_errors
 * @property {number} vf_errors
 * @property {number} ee_errors
 * @property {number} descent_steps
 * @property {number} chains_walked
 * @property {number[]} P sides of its box in the unit of the frame
 * @property {number[]} Q
 * @property {number | null} size
 * @property {(number | null)[]} centre
 */
/** @typedef {Row & { pairs: number[], rings: number[][] }} ConvexFrame */
/**
 * @typedef {Row & { pairs?: undefined, components: number, cavities: number, tunnels: number, points: string[][], near: Point[],
 *   outlines: number[][][], triangles: Triangle[][], parents: [number[], number[]][][] }} GeneralFrame
 */
/** @typedef {ConvexFrame | GeneralFrame} Frame */
/**
 * @typedef {object} Events
 * @property {string} from
 * @property {string} to
 * @property {Record<string, number>} counts
 * @property {number[][]} bins
 * @property {{ share: number, at: number, below: string | null, above: string | null }[]} frames
 */

/** @typedef {"P" | "Q"} Which */

/** @type {Record<Which, Operand>} */
const given = dataOf("operands");
/** @type {Frame[]} */
export const frames = dataOf("data");
/** @type {Events | null} */
export const events = dataOf("events");

/** Each number once, ascending. @param {number[]} numbers */
export const ascending = (numbers) => [...new Set(numbers)].sort((a, b) => a - b);

/** With exact points, and the faces by their vertices. @param {Operand} body */
const prepared = (body) => ({
  ...body,
  exact: body.points.map((point) => point.map(fraction)),
  numbers: new Map(body.faces.map((ring, number) => [ascending(ring).join(), number])),
});
export const operands = { P: prepared(given.P), Q: prepared(given.Q) };
export const kinds = ["fv", "vf", "ee", "facet+edge", "edge+facet", "facet+facet", "several"];
/** The kinds of facets that some frame has. */
export const present = kinds.filter((kind) => frames.some((frame) => frame.kinds[kind]));
