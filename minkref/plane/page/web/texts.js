// Scales, holes and events in words.
const kindNames = { b: "birth", d: "death", s: "swap", t: "touch" };

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
