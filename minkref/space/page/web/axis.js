// The axis of events: a bar for each part of the window, a tick for each frame, the frame that is shown.
const events = parse("events");
const eventKinds = ["vertex", "edge", "parallel", "triple", "four"];
const svg = (name, attributes) => {
  const made = document.createElementNS(element("axis").namespaceURI, name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  return made;
};
const axisWidth = 960, axisHeight = 56;

function buildAxis(go) {
  element("events-axis").hidden = !events;
  if (!events) return;
  const box = element("axis");
  const most = Math.max(1, ...events.bins.map((bin) => bin.reduce((a, b) => a + b, 0)));
  const step = axisWidth / events.bins.length;
  events.bins.forEach((bin, k) => {
    let top = axisHeight;
    bin.forEach((count, kind) => {
      if (!count) return;
      const high = Math.max((axisHeight * Math.log1p(count)) / Math.log1p(most) / eventKinds.length, 1);
      top -= high;
      box.append(svg("rect", { x: k * step, y: top, width: Math.max(step - 1, 1), height: high, class: `of-${eventKinds[kind]}` }));
    });
  });
  events.frames.forEach((frame, k) => {
    const tick = svg("line", { x1: frame.share * axisWidth, x2: frame.share * axisWidth, y1: 0, y2: axisHeight + 8, class: "tick", id: `tick-${k}` });
    tick.addEventListener("click", () => go(k));
    box.append(tick);
  });
  const parts = eventKinds.filter((kind) => events.counts[kind]).map((kind) => `${counted(events.counts[kind])} ${kind}`);
  element("axis-text").textContent = `Events of facets of the convolution from ${events.from} to ${events.to}: ${parts.join(", ") || "none"}.`;
}

function tellEvents(index) {
  if (!events) return;
  for (const tick of element("axis").querySelectorAll(".tick")) tick.classList.toggle("shown", tick.id === `tick-${index}`);
  const { at, below, above } = events.frames[index];
  const beside = [below && `the last one below at ${cut(written(fraction(below)))}`, above && `the next one above at ${cut(written(fraction(above)))}`];
  element("axis-here").textContent = [at ? `${several(at, "event")} at this scale` : "No event at this scale", ...beside.filter(Boolean)].join("; ") + ".";
}
