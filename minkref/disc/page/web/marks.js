// @ts-check
// The marks of the strip: each event, and in colours those that change holes and components.
import { data, eventCount, isInside, radiusOf } from "./data.js";
import { kindColours, kindNames } from "./texts.js";

/** @returns {import("../../../page/web/strip.js").Group[]} */
export function groups() {
  const events = Array.from({ length: eventCount }, (_, event) => event).filter((event) => isInside(radiusOf(event)));
  /** @param {number[]} some */
  const radii = (some) => some.map((event) => data.radii[radiusOf(event)]);
  const topology = ["r", "m", "s"].map((kind) => ({
    id: `marks-${kindNames[kind]}`, name: kindColours[kind], isTall: true,
    scales: radii(events.filter((event) => data.kinds[event] === kind)),
  }));
  return [{ id: "marks", name: "mark", isTall: false, scales: radii(events) }, ...topology];
}
