// @ts-check
// The marks of the strip: each boundary event, and in colours those of the topology.
import { data } from "./data.js";

/** @returns {import("../../../page/web/strip.js").Group[]} */
export function groups() {
  const topology = ["touch", "split", "merge", "death", "birth"].map((change) => ({
    id: `marks-${change}`, name: change, isTall: true,
    scales: data.topology.filter((row) => row[2] === change).map((row) => data.about[row[0]]),
  }));
  return [{ id: "marks", name: "mark", isTall: false, scales: data.about }, ...topology];
}
