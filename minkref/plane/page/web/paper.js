// @ts-check
// The paper's own program beside the exact sum, where the page has it. Then the page stands only at
// the scales that the program goes through, and at boundary events.
import { dot, paint, pathOf } from "../../../page/web/canvas.js";
import { colour } from "../../../page/web/colours.js";
import { element } from "../../../page/web/elements.js";
import { clamped, counted, several, short } from "../../../page/web/numbers.js";
import { svg } from "../../../page/web/svg.js";
import { cell, fillTable, line } from "../../../page/web/tables.js";
import { data } from "./data.js";

/** @typedef {import("../../../page/web/canvas.js").Scaled} Scaled */

const run = data.paper ?? null, steps = run?.steps ?? [];

export const paper = {
  isThere: run !== null,
  /** @type {{ first: number, last: number, row: HTMLElement }[]} */
  lines: [],  // of the runs of wrong steps

  /** The step next to a scale on the axis. @param {number} s */
  stepNear(s) {
    let k = 0;
    while (k + 1 < steps.length && Math.sqrt(steps[k].about * steps[k + 1].about) <= s) ++k;
    return k;
  },
  /** The step at a scale, or -1. @param {number} s */
  stepAt: (s) => steps.findIndex((step) => step.about === s),
  /** @param {number} s */
  scaleNear(s) { return run ? steps[this.stepNear(s)].about : s; },
  /** @param {number} s @param {number} by */
  scaleAfter(s, by) { return steps[clamped(this.stepNear(s) + by, 0, steps.length - 1)].about; },

  /**
   * Over the exact sum: what the answer has lost and added, and the witness.
   * @type {(context: CanvasRenderingContext2D, s: number, X: Scaled, Y: Scaled) => void}
   */
  draw(context, s, X, Y) {
    const step = steps[paper.stepAt(s)];
    if (!step) return;
    for (const name of /** @type {const} */ (["lost", "added"])) paint(context, pathOf((step[name] ?? []).flat(1), 1, X, Y), name, 1.1);
    if (step.witness) dot(context, X(step.witness[0]), Y(step.witness[1]), 3.5, "ink");
  },

  /**
   * Widens the box by the added polygons, within one size of the exact sum: farther off nothing else would be seen.
   * @param {import("../../../page/web/canvas.js").Box} box
   * @param {number} s
   */
  widen(box, s) {
    const step = steps[this.stepAt(s)];
    if (!step || box.empty) return;
    const { xmin, ymin, xmax, ymax } = box, reach = Math.max(box.across, box.up);
    /** @type {(v: number, low: number, high: number) => number} */
    const within = (v, low, high) => clamped(v, low - reach, high + reach);
    for (const polygon of step.added ?? []) {
      const ring = polygon[0];
      for (let i = 0; i < ring.length; i += 2) box.add(within(ring[i], xmin, xmax), within(ring[i + 1], ymin, ymax));
    }
  },

  /** Runs of steps at which the structure is another one: first and last. */
  wrongRuns() {
    /** @type {[number, number][]} */
    const runs = [];
    steps.forEach((step, k) => {
      if (step.right) return;
      const last = runs[runs.length - 1];
      if (last && last[1] === k - 1) last[1] = k; else runs.push([k, k]);
    });
    return runs;
  },

  /** A bar along the strip where the program is wrong. @param {(s: number) => number} x */
  bars(x) {
    const abouts = steps.map((step) => step.about);
    /** @param {number} k */
    const edge = (k) => x(k <= 0 ? abouts[0] : k >= abouts.length ? abouts[k - 1] : Math.sqrt(abouts[k - 1] * abouts[k]));
    return this.wrongRuns().map(([first, last]) => svg("rect", {
      class: "wrong", x: edge(first), y: 2, width: Math.max(edge(last + 1) - edge(first), 2), height: 5,
      fill: colour("lost-line"),
    }));
  },

  /** @param {(s: number) => void} goTo */
  fill(goTo) {
    if (!run) return;
    document.documentElement.classList.add("paper");
    for (const one of document.querySelectorAll(".of-paper")) one.removeAttribute("hidden");
    const { events, arithmetic, readings } = run, wrong = steps.filter((step) => !step.right).length;
    element("paper-what").textContent = `${arithmetic}; ${Object.entries(readings).map(([name, value]) => `${name} ${value}`).join(", ")}`;
    element("paper-counts").textContent = wrong ? `Wrong at ${counted(wrong)} of ${several(steps.length, "scale")}.` : `Right at all ${several(steps.length, "scale")}.`;
    this.lines = this.wrongRuns().map(([first, last]) => {
      const from = steps[first], to = steps[last];
      const range = first === last ? short(from.about) : `${short(from.about)} to ${short(to.about)}`;
      return { first, last, row: line([cell(range, { title: from.scale }), cell(from.words)], () => goTo(from.about)) };
    });
    fillTable("paper-wrong", this.lines.map(({ row }) => row));
    for (const name of /** @type {const} */ (["missed", "invented"])) {
      const listed = run[name], words = `${counted(events[name])} ${name} at all scales`;
      element(`paper-${name}-count`).textContent = listed.length ? `${words}; the first ${counted(listed.length)} of the window:` : `${words}, none in the window.`;
      fillTable(`paper-${name}`, listed.map(({ about, scale, change, a, b }) =>
        line([cell(short(about), { title: scale }), cell(change), cell(`${a}, ${b}`)], () => goTo(about))));
    }
    const rest = `${counted(events.right)} right, ${counted(events.misplaced)} at another scale`;
    element("paper-events").textContent = `Pair events, all scales: ${rest}.`;
  },

  /** @param {number} s */
  show(s) {
    if (!run) return;
    const k = this.stepAt(s), step = steps[k], here = element("paper-here");
    here.textContent = !step
      ? "At an event: the program stands only at the steps of the slider."
      : `s = ${step.scale}: ${step.words}.${step.lost === null ? " It is too large to be drawn." : ""}`;
    here.classList.toggle("wrong", !!step && !step.right);
    for (const { first, last, row } of this.lines) row.classList.toggle("here", first <= k && k <= last);
  },
};
