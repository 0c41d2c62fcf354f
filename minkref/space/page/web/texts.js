// Frames, facets and vertices in words.
const meaning = {
  "fv": "facet of P + vertex of Q", "vf": "vertex of P + facet of Q", "ee": "edge of P + edge of Q",
  "facet+edge": "facet of P + edge of Q", "edge+facet": "edge of P + facet of Q", "facet+facet": "facet of P + facet of Q",
  "several": "of different kinds, in one plane",
};
const place = (point) => `(${point.map(short).join(", ")})`;

function scaleText(scale, whole = false) {
  const told = (text) => (whole || text.length <= longest ? text : `≈ ${about(fraction(text))}`);
  return new Set(scale).size === 1 ? told(scale[0]) : `(${scale.map(told).join(", ")})`;
}

// "vertex 3 of P", "edge 3–7 of P", "facet 5 of P".
function faceText(which, vertices) {
  if (vertices.length === 1) return `vertex ${vertices[0]} of ${which}`;
  if (vertices.length === 2) return `edge ${vertices[0]}–${vertices[1]} of ${which}`;
  return `facet ${operands[which].numbers.get(vertices.join())} of ${which}`;
}
const pairText = ({ P, Q }) => `${faceText("P", P)} + ${faceText("Q", Q)}`;
function parentsText(parents, most, between) {
  const told = parents.slice(0, most).map(pairText);
  if (parents.length > most) told.push(`${parents.length - most} more`);
  return told.join(between);
}
const cornersOf = (picture, facet) => picture.outlines[facet].reduce((sum, ring) => sum + ring.length, 0);
const shapeText = ({ components, cavities, tunnels }) =>
  `${several(components, "component")}, ${several(cavities, "cavity", "cavities")}, ${several(tunnels, "tunnel")}`;

function volumeText(frame) {
  const volume = fraction(frame.volume);
  const exact = written(volume);
  return exact.length <= longest ? exact : `≈ ${about(volume)}`;
}

function captionText(frame) {
  const parts = kinds.filter((kind) => frame.kinds[kind]).map((kind) => `${counted(frame.kinds[kind])} ${kind}`);
  return `${counted(frame.vertices)} vertices, ${counted(frame.edges)} edges, ${several(frame.facets, "facet")}: ` +
    `${parts.join(", ")}. ${frame.pairs ? "" : `${shapeText(frame)}. `}Volume ${volumeText(frame)}. SHA-256 ${frame.digest.slice(0, 12)}…`;
}

// The text at the pointer for a facet or vertex of a picture.
function tipText(name, picture, frame, what, number) {
  const corners = what === "facet" ? several(cornersOf(picture, number), "corner") : "";
  if (name === "sum") {
    if (what === "facet") {
      return `facet ${number}: ${picture.kinds[number]}, ${corners}\n${parentsText(picture.parents[number], 4, "\n")}`;
    }
    if (!frame.pairs) return `vertex ${number}\n${place(exactPoint(frame, number))}`;
    const [p, q] = frame.pairs.slice(2 * number, 2 * number + 2);
    return `vertex ${number}\nvertex ${p} of P + vertex ${q} of Q\n${place(exactPoint(frame, number))}`;
  }
  if (what === "facet") return `facet ${number} of ${name}, ${corners}`;
  return `vertex ${number} of ${name}\n${place(operandPoint(name, frame, number))}${name === "P" ? ", scaled" : ""}`;
}

function operandPoint(name, frame, number) {
  const point = operands[name].exact[number];
  return name === "P" ? point.map((axis, i) => times(fraction(frame.scale[i]), axis)) : point;
}
