// Radii, holes, events and features in words.
const kindNames = { c: "corner", j: "joint", s: "saddle", r: "ridge", m: "maximum" };
const kindPlurals = { c: "corners", j: "joints", s: "saddles", r: "ridges", m: "maxima" };
const kindTexts = {
  c: "as far from three features or more: curves start or stop to be on the boundary",
  j: "right in front of an end of an edge: a curve passes from its line to the arc about the end",
  s: "right between two features, nearest to each other there: curves start to touch",
  r: "right between two features, and as far from a third: all between parallel edges may be reached at once",
  m: "inside of the triangle of its features: a hole ends",
};
const topologyKinds = "srm";
const isTopology = (event) => topologyKinds.includes(data.kinds[event]);

const radiusText = (event, digits = 9) => short(data.radii[event], digits);
const featureName = (feature, id) => (id === 0 ? "the outside" : `hole ${id}`);
const bornText = (life) => (life[0] < 0 ? "a hole of P, there from the start" : `born at the radius ${radiusText(life[0])}`);
const diedText = (life) => `ends at the radius ${radiusText(life[1])}`;

// Coordinates are those of P again.
const pointText = ([x, y], digits = 9) => `(${short(x + data.origin[0], digits)}, ${short(y + data.origin[1], digits)})`;
function featureText(number) {
  const feature = data.features[number];
  return feature.length === 2 ? `vertex ${pointText(feature)}` : `edge ${feature[2]}.${feature[3]}`;
}

// "2 corners, 1 saddle": the events at one radius.
function kindsAt(radius) {
  const kinds = data.kinds.slice(firstEvents[radius], firstEvents[radius + 1]);
  return Object.keys(kindNames).map((kind) => [kind, kinds.split(kind).length - 1]).filter(([, count]) => count)
    .map(([kind, count]) => `${counted(count)} ${count === 1 ? kindNames[kind] : kindPlurals[kind]}`).join(", ");
}

function changeText({ change, hole, from, a, b }) {
  if (change === "merge") return `the components of polygons ${a} and ${b} become one`;
  return change === "death" ? `hole ${hole} ends` : `hole ${hole} is born, of ${from ? `hole ${from}` : "the outside"}`;
}
