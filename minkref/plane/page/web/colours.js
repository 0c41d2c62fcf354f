// Colours of the page, and one for each hole for all its life.
let style = getComputedStyle(document.documentElement);
const colour = (name) => style.getPropertyValue(`--${name}`).trim();
const hue = (id) => (id * 137.508 + 62.5) % 360;
const holeFill = (id) => `hsl(${hue(id).toFixed(1)} 70% ${colour("hole-light")})`;
const holeLine = (id) => `hsl(${hue(id).toFixed(1)} 70% ${colour("hole-line")})`;
const featureFill = (feature, id) => (feature === "h" ? (id === 0 ? colour("rule") : holeFill(id)) : colour("sum-line"));
