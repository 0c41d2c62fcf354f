// @ts-check
// The rings of a sum's boundary at any scale of a window, from what changes between its states.
import { placeAfter } from "./numbers.js";

/** @typedef {{ isHole: boolean, component: number, hole: number, vertices: number[] }} Ring `vertices`: tracks */
/**
 * @typedef {object} RingData the part of a page's data that has the rings
 * @property {number[]} about the scales of the boundary events
 * @property {number[]} tracks
 * @property {Record<string, number>} centres
 * @property {any[][]} states state k begins at the boundary event k - 1; state 0 with the window
 */
/** @typedef {[number, Ring | undefined, [number, number, number[]][] | null][]} Replaced */

export class Timeline {
  /** @param {RingData} data */
  constructor(data) {
    this.data = data;
    // x or y of a track: r + m (s - c).
    this.centres = new Float64Array(data.tracks.length / 2);
    for (const [place, c] of Object.entries(data.centres)) this.centres[Number(place)] = c;
    this.state = -1;
    /** @type {Map<number, Ring>} */
    this.rings = new Map();  // by slot
    /** @type {Replaced[]} */
    this.undo = [];  // of each state that was entered: what it replaced
  }

  /** @param {number} place @param {number} s */
  coordinate(place, s) { return this.data.tracks[2 * place] + this.data.tracks[2 * place + 1] * (s - this.centres[place]); }
  /** @param {number} track @param {number} s */
  x(track, s) { return this.coordinate(2 * track, s); }
  /** @param {number} track @param {number} s */
  y(track, s) { return this.coordinate(2 * track + 1, s); }

  forward() {
    const [gone = [], ...changed] = this.data.states[++this.state];
    /** @type {Replaced} */
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
  }

  backward() {
    for (const [slot, before, back] of this.undo[this.state]) {
      if (!before) { this.rings.delete(slot); continue; }
      if (back) for (const [at, added, removed] of back) before.vertices.splice(at, added, ...removed);
      this.rings.set(slot, before);
    }
    --this.state;
  }

  /** At the scale of an event: the state from it on. @param {number} s */
  at(s) {
    const wanted = placeAfter(this.data.about, s);
    while (this.state < wanted) this.forward();
    while (this.state > wanted) this.backward();
    return this.rings;
  }
}
