// Scales, holes and events in words.
const short = (number, digits = 6) => String(Number(Number(number).toPrecision(digits)));
const kindNames = { b: "birth", d: "death", s: "swap", t: "touch" };

// A long fraction is cut in running text; it is whole where it is chosen.
const cut = (text) => (text.length > 24 ? `${text.slice(0, 11)}…${text.slice(-11)}` : text);
const exactAndAbout = (event, whole = false) => {
  const exact = data.scales[event], about = short(data.about[event]);
  return exact === about ? exact : `${whole ? exact : cut(exact)} ≈ ${about}`;
};

const lives = { h: data.holes, c: data.components };
const names = { h: "hole", c: "component" };
const isInside = (event) => event >= 0 && event < data.scales.length;
const bornText = (life, whole) => (isInside(life[0]) ? `born at ${exactAndAbout(life[0], whole)}` : "there when the window begins");
const diedText = (life, whole) => (isInside(life[1]) ? `dies at ${exactAndAbout(life[1], whole)}` : "there when the window ends");

function featureName(feature, id) {
  return feature === "h" && id === 0 ? "the outside" : `${names[feature]} ${id}`;
}

// A number or a fraction; NaN if it is neither.
function scaleOf(text) {
  const parts = text.trim().replace(",", ".").split("/");
  if (parts.length > 2 || parts.some((part) => !/^\d*\.?\d+(e[+-]?\d+)?$|^\d+\.$/i.test(part.trim()))) return NaN;
  return parts.length === 2 ? Number(parts[0]) / Number(parts[1]) : Number(parts[0]);
}
