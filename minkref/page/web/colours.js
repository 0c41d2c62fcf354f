// @ts-check
// Colours of the page, which its style names, and one for each hole for all its life.
const style = getComputedStyle(document.documentElement);  // changes with the colours of the system

/** @param {string} name */
export const colour = (name) => style.getPropertyValue(`--${name}`).trim();
/** @param {number} id */
export const holeFill = (id) => `hsl(${((id * 137.508 + 62.5) % 360).toFixed(1)} 70% ${colour("hole-light")})`;
/** Of a hole ("h"), where 0 is the outside, a concave feature ("f"), or a component ("c"). @param {string} feature @param {number} id */
export function featureFill(feature, id) {
  if (feature === "c") return colour("sum-line");
  return feature === "h" && id === 0 ? colour("rule") : holeFill(id);
}
