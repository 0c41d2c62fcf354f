// The data of the page: P, the outer Voronoi diagram, its events and holes.
const data = JSON.parse(element("data").textContent);
const [windowFirst, windowLast] = data.window.map(([, about]) => about);
data.about = data.radii;

// Radii of events are numbered from 0 on; those of the window.
const [firstInside, endInside] = data.inside;
const isInside = (event) => event >= firstInside && event < endInside;

// Nodes of the diagram: events, then gaps of the hull, at infinity, then reflex vertices. The number of
// the radius of an event counts from 1 on, 0 is that of reflex vertices, and infinity comes last.
const eventCount = data.kinds.length, gapCount = data.gaps.length;
const isEvent = (node) => node < eventCount;
const isInfinite = (node) => node >= eventCount && node < eventCount + gapCount;

// The events at each radius: the first of them, and where the next radius begins.
const firstEvents = data.radii.map(() => 0);
for (let event = eventCount - 1; event >= 0; --event) firstEvents[data.numbers[event] - 1] = event;
firstEvents.push(eventCount);
const radiusOf = (event) => data.numbers[event] - 1;

// The changes of holes and components at each event.
const changes = new Map();
function note(event, change) {
  if (event === null) return;
  changes.set(event, [...(changes.get(event) ?? []), change]);
}
data.holes.forEach(([, , bornAt, endsAt, from], i) => {
  note(bornAt, { change: "birth", hole: i + 1, from });
  note(endsAt, { change: "death", hole: i + 1 });
});
data.joins.forEach(([, , event, a, b]) => note(event, { change: "merge", a, b }));

// The least box around P.
const boxOfP = new Box();
for (const [, from] of data.sides) boxOfP.add(...data.features[from]);
if (data.point) boxOfP.add(...data.point);
