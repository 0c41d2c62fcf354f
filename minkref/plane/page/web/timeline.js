// @ts-check
// The rings of the boundary at any scale of the window, from what changes between its states.
import { placeAfter } from "../../../page/web/numbers.js";
import { data } from "./data.js";

/** @typedef {{ isHole: boolean, component: number, hole: number, vertices: number[] }} Ring `vertices`: tracks */

// x or y of a track: r + m (s - c).
const centres = new Float64Array(data.tracks.length / 2);
for (const [place, c] of Object.entries(data.centres)) centres[Number(place)] = c;
/** @param {number} place @param {number} s */
const coordinate = (place, s) => data.tracks[2 * place] + data.tracks[2 * place + 1] * (s - centres[place]);
/** @param {number} track @param {number} s */
export const xOf = (track, s) => coordinate(2 * track, s);
/** @param {number} track @param {number} s */
export const yOf = (track, s) => coordinate(2 * track + 1, s);

// State k begins at the boundary event k - 1; state 0 with the window.
export const timeline = {
  state: -1,
  /** @type {Map<number, Ring>} */
  rings: new Map(),  // by slot
  /** @type {[number, Ring | undefined, [number, number, number[]][] | null][][]} */
  undo: [],  // of each state that was entered: what it replaced

  forward() {
    const [gone = [], ...changed] = data.states[++this.state];
    /** @type {typeof this.undo[number]} */
    const replaced = [];
    for (const slot of gone) {
      replaced.push([slot, this.rings.get(slot), null]);
      this.rings.delete(slot);
    }
    for (const [slot, isHole, component, hole, ...splices] of changed) {
      const before = this.rings.get(slot);
      /** @type {number[]} */
      const vertices = before ? before.vertices : [];
      /** @type {[number, number, number[]][]} */
      const back = splices.map((/** @type {number[]} */ [at, removed, ...added]) => [at, added.length, vertices.splice(at, removed, ...added)]);
      replaced.push([slot, before, back.reverse()]);
      this.rings.set(slot, { isHole: !!isHole, component, hole, vertices });
    }
    this.undo[this.state] = replaced.reverse();
  },

  backward() {
    for (const [slot, before, back] of this.undo[this.state]) {
      if (!before) { this.rings.delete(slot); continue; }
      if (back) for (const [at, added, removed] of back) before.vertices.splice(at, added, ...removed);
      this.rings.set(slot, before);
    }
    --this.state;
  },

  /** At the scale of an event: the state from it on. @param {number} s */
  at(s) {
    const wanted = placeAfter(data.about, s);
    while (this.state < wanted) this.forward();
    while (this.state > wanted) this.backward();
    return this.rings;
  },
};
