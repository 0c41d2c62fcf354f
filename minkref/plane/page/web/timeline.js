// The rings of the boundary at any scale of the window, from what changes between its states.
const data = JSON.parse(document.getElementById("data").textContent);
const [windowFirst, windowLast] = data.window.map(([, about]) => about);

// x or y of a track: r + m (s - c).
const centres = new Float64Array(data.tracks.length / 2);
for (const [place, c] of Object.entries(data.centres)) centres[place] = c;
const coordinate = (place, s) => data.tracks[2 * place] + data.tracks[2 * place + 1] * (s - centres[place]);
const xOf = (track, s) => coordinate(2 * track, s);
const yOf = (track, s) => coordinate(2 * track + 1, s);

// State k begins at the boundary event k - 1; state 0 with the window.
const timeline = {
  state: -1,
  rings: new Map(),  // slot: {isHole, component, hole, vertices}
  undo: [],          // of each state that was entered: what it replaced

  forward() {
    const [gone = [], ...changed] = data.states[++this.state];
    const replaced = [];
    for (const slot of gone) {
      replaced.push([slot, this.rings.get(slot), null]);
      this.rings.delete(slot);
    }
    for (const [slot, isHole, component, hole, ...splices] of changed) {
      const before = this.rings.get(slot);
      const vertices = before ? before.vertices : [];
      const back = splices.map(([at, removed, ...added]) => [at, added.length, vertices.splice(at, removed, ...added)]);
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

  // At the scale of an event: the state from it on.
  stateAt(s) { return placeAfter(data.about, s); },

  at(s) {
    const wanted = this.stateAt(s);
    while (this.state < wanted) this.forward();
    while (this.state > wanted) this.backward();
    return this.rings;
  },
};
