// @ts-check
// Free cells of a raster that hang together, as components that keep their numbers while copies move.

/** @typedef {import("./raster.js").Raster} Raster */
/** @typedef {"forbidden" | "allowed"} Contact */
/**
 * @typedef {object} Components
 * @property {Int32Array} runs first cell, last cell and component of each run of free cells of a row, one after another
 * @property {Int32Array} cells the component of each cell, -1 where none is
 * @property {number[]} sizes in cells
 */

/**
 * Contact forbidden: cells that no sum meets, joined along sides; so what is one component is connected.
 * Contact allowed: cells in the interior of no single sum, joined at corners too and, unless the picture has all sums,
 * beyond the border; so components are apart.
 * @param {Raster} raster
 * @param {Contact} contact
 * @param {boolean} isWhole whether all sums are in the picture
 * @returns {Components}
 */
export function componentsOf({ columns, rows, touched, inner }, contact, isWhole) {
  const blocked = contact === "allowed" ? inner : touched, reach = contact === "allowed" ? 1 : 0;
  /** @type {number[]} */
  const ends = [];  // first and last cell of each run
  /** @type {number[]} */
  const parents = [];
  let above = 0;  // the first run of the row above that may touch
  for (let row = 0; row < rows; ++row) {
    const start = row * columns, stop = start + columns, own = parents.length;
    for (let cell = start; cell < stop; ++cell) {
      if (blocked[cell]) continue;
      const first = cell;
      while (cell + 1 < stop && !blocked[cell + 1]) ++cell;
      const run = parents.length;
      ends.push(first, cell);
      parents.push(run);
      while (above < own && ends[2 * above + 1] + columns + reach < first) ++above;
      for (let other = above; other < own && ends[2 * other] + columns - reach <= cell; ++other) join(parents, run, other);
    }
    above = own;
  }
  if (contact === "allowed" && !isWhole) joinBorder(ends, parents, columns, rows);
  return numbered(ends, parents, columns * rows);
}

/** @param {number[]} parents @param {number} run */
function root(parents, run) {
  while (parents[run] !== run) run = parents[run] = parents[parents[run]];
  return run;
}

/** @param {number[]} parents @param {number} a @param {number} b */
function join(parents, a, b) {
  const one = root(parents, a), other = root(parents, b);
  parents[Math.max(one, other)] = Math.min(one, other);
}

/** Makes one of all that reach the border. @type {(ends: number[], parents: number[], columns: number, rows: number) => void} */
function joinBorder(ends, parents, columns, rows) {
  let first = -1;
  for (let run = 0; run < parents.length; ++run) {
    const from = ends[2 * run], to = ends[2 * run + 1], row = Math.floor(from / columns);
    if (row > 0 && row < rows - 1 && from % columns && (to + 1) % columns) continue;
    if (first < 0) first = run; else join(parents, run, first);
  }
}

/** @type {(ends: number[], parents: number[], count: number) => Components} */
function numbered(ends, parents, count) {
  const runs = new Int32Array(3 * parents.length), cells = new Int32Array(count).fill(-1);
  /** @type {number[]} */
  const sizes = [], numbers = new Int32Array(parents.length);
  for (let run = 0; run < parents.length; ++run) {
    const top = root(parents, run), first = ends[2 * run], last = ends[2 * run + 1];
    if (top === run) numbers[run] = sizes.push(0) - 1;
    const component = numbers[top];
    runs.set([first, last, component], 3 * run);
    cells.fill(component, first, last + 1);
    sizes[component] += last - first + 1;
  }
  return { runs, cells, sizes };
}

/**
 * Where an exact seam may be: cells in the interior of no single sum, and near no cell that no sum meets.
 * @param {Raster} raster
 * @returns {number[]} cells
 */
export function seamsOf({ columns, rows, touched, inner }) {
  const found = [];
  for (let row = 2; row < rows - 2; ++row) {
    for (let cell = row * columns + 2, end = (row + 1) * columns - 2; cell < end; ++cell) {
      if (inner[cell] || !touched[cell]) continue;
      let isNear = false;
      for (let other = cell - 2 * columns; other <= cell + 2 * columns && !isNear; other += columns) {
        isNear = !touched[other - 2] || !touched[other - 1] || !touched[other] || !touched[other + 1] || !touched[other + 2];
      }
      if (!isNear) found.push(cell);
    }
  }
  return found;
}

/** Numbers of components, kept from one picture to the next by the cells that they share. */
export class Names {
  constructor() {
    /** @type {{ raster: Raster, components: Components, names: number[] } | null} */
    this.last = null;
  }

  /**
   * The name of each component. The largest common part keeps a name.
   * @param {Raster} raster
   * @param {Components} components
   * @param {boolean} isWhole whether the picture has all sums, so that its border is the outside
   */
  of(raster, components, isWhole) {
    const { sizes, cells } = components, votes = sizes.map(() => /** @type {Map<number, number>} */ (new Map()));
    if (this.last) this.vote(raster, components, votes);
    const pairs = votes.flatMap((each, component) => [...each].map(([name, count]) => ({ component, name, count })));
    pairs.sort((a, b) => b.count - a.count);
    /** @type {number[]} */
    const names = sizes.map(() => -1), taken = new Set();
    if (isWhole && cells[0] >= 0) { names[cells[0]] = 0; taken.add(0); }
    for (const { component, name } of pairs) {
      if (names[component] >= 0 || taken.has(name)) continue;
      names[component] = name;
      taken.add(name);
    }
    let next = 1;  // 0 is the outside
    names.forEach((name, component) => {
      if (name >= 0) return;
      while (taken.has(next)) ++next;
      names[component] = next++;
    });
    this.last = { raster, components, names };
    return names;
  }

  /** @type {(raster: Raster, components: Components, votes: Map<number, number>[]) => void} */
  vote(raster, { runs }, votes) {
    const last = /** @type {NonNullable<typeof this.last>} */ (this.last), { columns, frame } = raster;
    const old = last.raster, ratio = old.frame.unit / frame.unit;
    const x = (frame.x - old.frame.x) * old.frame.unit, y = (old.frame.y - frame.y) * old.frame.unit;
    for (let i = 0; i < runs.length; i += 3) {
      const from = runs[i], to = runs[i + 1], row = Math.floor(from / columns), start = row * columns;
      const oldRow = Math.floor(y + (row + 0.5) * ratio);
      if (oldRow < 0 || oldRow >= old.rows) continue;
      const column = Math.floor(x + ((from + to + 1) / 2 - start) * ratio);
      if (column < 0 || column >= old.columns) continue;
      const component = last.components.cells[oldRow * old.columns + column];
      if (component < 0) continue;
      const mine = votes[runs[i + 2]], name = last.names[component];
      mine.set(name, (mine.get(name) ?? 0) + to - from + 1);
    }
  }
}
