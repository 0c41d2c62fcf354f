// @ts-check
// Elements of a page: found, made, listened to; the tip at the pointer; boxes that scroll.

/**
 * The element of this id. Throws where it is missing or of another kind.
 * @template {Element} [T=HTMLElement]
 * @param {string} id
 * @param {new () => T} [kind]
 * @returns {T}
 */
export function element(id, kind) {
  const found = document.getElementById(id);
  if (!(found instanceof (kind ?? HTMLElement))) throw new Error(`the page has no such element: ${id}`);
  return /** @type {T} */ (/** @type {Element} */ (found));
}

/** @param {string} id */
export const input = (id) => element(id, HTMLInputElement);
/** @param {string} id */
export const isChecked = (id) => input(id).checked;

/**
 * An element with attributes and children.
 * @template {keyof HTMLElementTagNameMap} Name
 * @param {Name} name
 * @param {Record<string, string | number>} attributes
 * @param {...(Node | string)} children
 */
export function node(name, attributes = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, String(value));
  made.append(...children);
  return made;
}

/** @param {string} text @param {() => void} go */
export function button(text, go) {
  const made = node("button", {}, text);
  made.addEventListener("click", go);
  return made;
}

/** A square of a colour before a name. @param {string} fill */
export function swatch(fill) {
  const made = node("span", { class: "swatch" });
  made.style.background = fill;
  return made;
}

/**
 * @template {Event} T
 * @param {string[]} ids
 * @param {string} type
 * @param {(event: T) => void} heard
 */
export function listenTo(ids, type, heard) {
  for (const id of ids) element(id).addEventListener(type, (event) => heard(/** @type {T} */ (event)));
}

/** A slider gives its number. @param {string} id @param {(value: number) => void} go */
export function onSlide(id, go) {
  const slider = input(id);
  slider.addEventListener("input", () => go(Number(slider.value)));
}

/** Calls back where the colours of the system change. @param {() => void} recolour */
export function onRecolour(recolour) {
  matchMedia("(prefers-color-scheme: dark)").addEventListener("change", recolour);
}

/** Shows a text at the pointer, or hides it. @param {string} text */
export function tip(text, event = { clientX: 0, clientY: 0 }) {
  const box = element("tip");
  box.hidden = !text;
  if (!text) return;
  box.textContent = text;
  const { width, height } = box.getBoundingClientRect();
  box.style.left = `${Math.max(Math.min(event.clientX + 14, innerWidth - width - 6), 6)}px`;
  box.style.top = `${event.clientY + 18 + height > innerHeight ? event.clientY - height - 10 : event.clientY + 18}px`;
}

/**
 * Where an event is in an element, in pixels from its upper left corner.
 * @param {MouseEvent} event
 * @param {Element} inside
 */
export function placeIn(event, inside) {
  const box = inside.getBoundingClientRect();
  return [event.clientX - box.left, event.clientY - box.top];
}

/**
 * Scrolls a box so far that an element in it is seen, below a heading that stays; never the page.
 * @param {Element} box
 * @param {Element} inner
 */
export function revealIn(box, inner) {
  const outer = box.getBoundingClientRect(), own = inner.getBoundingClientRect();
  const heading = box.querySelector("thead")?.getBoundingClientRect().height ?? 0;
  if (own.top < outer.top + heading) box.scrollTop -= outer.top + heading - own.top;
  else if (own.bottom > outer.top + box.clientHeight) box.scrollTop += own.bottom - outer.top - box.clientHeight;
}

/** A function that asks for `show` before the next picture, once however often it is called. @param {() => void} show */
export function onNextPicture(show) {
  let isAsked = false;
  return () => {
    if (isAsked) return;
    isAsked = true;
    requestAnimationFrame(() => { isAsked = false; show(); });
  };
}

/** The JSON of a script element. @param {string} id @returns {any} */
export const dataOf = (id) => JSON.parse(element(id).textContent ?? "");
