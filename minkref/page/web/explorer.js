// @ts-check
// Where the page stands: a scale on the axis and, at the scale of an event, its number.
import { element, onNextPicture } from "./elements.js";
import { clamped, placeAfter } from "./numbers.js";

/**
 * @typedef {object} Way what there is to go through
 * @property {import("./axis.js").Axis} axis
 * @property {number[]} scales of the events, ascending
 * @property {(event: number) => boolean} isInside the window
 * @property {number} start
 * @property {(event: number) => void} go
 * @property {() => void} show what follows from where the page stands
 * @property {(event: number) => void} [arrive] what a move to the scale of an event, or to none (-1), ends
 * @property {(s: number) => number} [snap] to the scales at which the page may stand
 * @property {(s: number, share: number) => number} [stepped] one step from a scale
 */

/** @typedef {Record<string, (event: KeyboardEvent) => void>} Keys what each key does, by its name */

export class Explorer {
  /** @param {Way} way */
  constructor(way) {
    this.way = way;
    this.at = -1;  // the event at whose scale the page stands
    this.scale = this.snapped(way.start);
    this.show = onNextPicture(way.show);
  }

  /** @param {number} s */
  snapped(s) {
    const { axis, snap } = this.way, inside = axis.clamp(s);
    return snap ? snap(inside) : inside;
  }

  /** @param {number} s */
  moveTo(s, event = -1) {
    if (!Number.isFinite(s)) return;
    this.scale = event >= 0 ? this.way.axis.clamp(s) : this.snapped(s);
    this.at = event;
    this.way.arrive?.(event);
    this.show();
  }

  next() { return this.at >= 0 ? this.at + 1 : placeAfter(this.way.scales, this.scale); }
  previous() {
    if (this.at >= 0) return this.at - 1;
    let event = placeAfter(this.way.scales, this.scale) - 1;
    while (event >= 0 && this.way.scales[event] >= this.scale) --event;
    return event;
  }
  goNext() { this.way.go(this.next()); }
  goPrevious() { this.way.go(this.previous()); }

  /** @param {number} share of the axis */
  step(share) {
    const { axis, stepped } = this.way;
    this.moveTo(stepped ? stepped(this.scale, share) : axis.scaleAt(axis.shareOf(this.scale) + share));
  }

  /** @returns {Keys} */
  keys() {
    const { axis } = this.way;
    return {
      ArrowLeft: (event) => this.step(-stride(event)),
      ArrowRight: (event) => this.step(stride(event)),
      PageDown: () => this.goPrevious(),
      PageUp: () => this.goNext(),
      Home: () => this.moveTo(axis.first),
      End: () => this.moveTo(axis.last),
    };
  }

  /**
   * Shows the scale in the slider, the field and the buttons.
   * @param {string} text
   * @param {boolean} isWide whether the field is as wide as the text
   */
  showScale(text, isWide) {
    const { axis, isInside } = this.way;
    element("slider", HTMLInputElement).value = String(axis.shareOf(this.scale));
    const field = element("scale", HTMLInputElement);
    if (document.activeElement !== field || !field.classList.contains("bad")) {
      field.value = text;
      field.classList.remove("bad");
      if (isWide) field.style.width = `${clamped(text.length + 3, 14, 72)}ch`;
    }
    element("previous", HTMLButtonElement).disabled = !isInside(this.previous());
    element("next", HTMLButtonElement).disabled = !isInside(this.next());
  }
}

/** How far a key goes along an axis: with Shift finely. @param {KeyboardEvent} event */
export const stride = (event) => (event.shiftKey ? 0.0005 : 0.005);
