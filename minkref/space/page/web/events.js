// @ts-check
// The axis of events: a bar for each part of the window, a tick for each frame, the frame that is shown.
import { element } from "../../../page/web/elements.js";
import { fraction, written } from "../../../page/web/fractions.js";
import { counted, several } from "../../../page/web/numbers.js";
import { svg } from "../../../page/web/svg.js";
import { events } from "./data.js";
import { cutText } from "./texts.js";

const KINDS = ["vertex", "edge", "parallel", "triple", "four"];
const WIDTH = 960, HEIGHT = 56;

/** @param {(frame: number) => void} go */
export function buildAxis(go) {
  element("events-axis").hidden = !events;
  if (!events) return;
  const box = element("axis", SVGSVGElement), step = WIDTH / events.bins.length;
  const most = Math.max(1, ...events.bins.map((bin) => bin.reduce((a, b) => a + b, 0)));
  events.bins.forEach((bin, k) => {
    let top = HEIGHT;
    bin.forEach((count, kind) => {
      if (!count) return;
      const high = Math.max((HEIGHT * Math.log1p(count)) / Math.log1p(most) / KINDS.length, 1);
      top -= high;
      box.append(svg("rect", { x: k * step, y: top, width: Math.max(step - 1, 1), height: high, class: `of-${KINDS[kind]}` }));
    });
  });
  events.frames.forEach(({ share }, k) => {
    const tick = svg("line", { x1: share * WIDTH, x2: share * WIDTH, y1: 0, y2: HEIGHT + 8, class: "tick", id: `tick-${k}` });
    tick.addEventListener("click", () => go(k));
    box.append(tick);
  });
  const { from, to, counts } = events, parts = KINDS.filter((kind) => counts[kind]).map((kind) => `${counted(counts[kind])} ${kind}`);
  element("axis-text").textContent = `Events of facets of the convolution from ${from} to ${to}: ${parts.join(", ") || "none"}.`;
}

/** @param {number} index */
export function tellEvents(index) {
  if (!events) return;
  for (const tick of element("axis", SVGSVGElement).querySelectorAll(".tick")) tick.classList.toggle("shown", tick.id === `tick-${index}`);
  const { at, below, above } = events.frames[index];
  const beside = [below && `the last one below at ${cutText(written(fraction(below)))}`, above && `the next one above at ${cutText(written(fraction(above)))}`];
  element("axis-here").textContent = `${[at ? `${several(at, "event")} at this scale` : "No event at this scale", ...beside.filter(Boolean)].join("; ")}.`;
}
