// @ts-check
// Elements of SVG.
const namespace = document.querySelector("svg")?.namespaceURI ?? null;  // no address stands in a page

/**
 * @template {keyof SVGElementTagNameMap} Name
 * @param {Name} name
 * @param {Record<string, string | number>} attributes
 * @param {...(Node | string)} children
 */
export function svg(name, attributes = {}, ...children) {
  const made = /** @type {SVGElementTagNameMap[Name]} */ (document.createElementNS(namespace, name));
  set(made, attributes);
  made.append(...children);
  return made;
}

/** @param {Element} one @param {Record<string, string | number>} attributes */
export function set(one, attributes) {
  for (const [key, value] of Object.entries(attributes)) one.setAttribute(key, String(value));
}
