// The marks of the strip: each event, and in colours those that change holes and components.
const kindColours = { s: "birth", r: "touch", m: "death" };

const marks = {
  letter: "ρ",
  scales: data.radii,

  groups() {
    const events = [];
    for (let event = 0; event < eventCount; ++event) if (isInside(radiusOf(event))) events.push(event);
    const radii = (some) => some.map((event) => data.radii[radiusOf(event)]);
    const topology = ["r", "m", "s"].map((kind) => ({
      id: `marks-${kindNames[kind]}`, name: kindColours[kind], isTall: true,
      scales: radii(events.filter((event) => data.kinds[event] === kind)),
    }));
    return [{ id: "marks", name: "mark", isTall: false, scales: radii(events) }, ...topology];
  },

  bars: () => [],
  tell: (radius) => `radius ${radiusText(radius)}: ${kindsAt(radius)}`,
  go: (radius) => goToRadius(radius),
};
