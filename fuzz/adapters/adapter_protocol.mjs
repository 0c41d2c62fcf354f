// The loop of an adapter in JavaScript: requests from standard input, answers to standard output
// (docs/adapter-protocol.md). `serve(hello, verbs)` takes the declaration and the functions
// sumOf(sP, Q), unionOf(sets) and offsetOf(P, radius, request); each returns the members of a result.
import { createInterface } from "node:readline";

export class Skipped extends Error {}

/** All rings of a set: outer ones counter-clockwise, holes clockwise. */
export function ringsOf(set) {
  return set.polygons.flatMap((polygon) => [polygon.outer, ...polygon.holes]);
}

export function onlyRing(set) {
  const rings = ringsOf(set);
  if (rings.length !== 1) throw new Skipped("one ring each only");
  return rings[0];
}

export function largest(sets) {
  const sizes = sets.flatMap(ringsOf).flat(2).map(Math.abs);
  return sizes.reduce((a, b) => Math.max(a, b), 0);
}

/** A grid with a power of two as its unit, as integer_grid.hpp: sizes have at most `bits` bits. */
export class IntegerGrid {
  constructor(size, bits) {
    if (!Number.isFinite(size)) throw new Skipped("coordinates exceed the doubles");
    let exponent = size > 0 ? Math.floor(Math.log2(size)) + 1 : 0;
    if (size >= 2 ** exponent) exponent++;
    if (size > 0 && size < 2 ** (exponent - 1)) exponent--;
    this.unit = 2 ** (exponent - bits);
    if (this.unit < 2 ** -1000 || !Number.isFinite(this.unit)) throw new Skipped("far from 1");
  }
  to(value) {
    const scaled = value / this.unit;
    return Math.sign(scaled) * Math.round(Math.abs(scaled)) + 0;
  }
  from(value) {
    return value * this.unit;
  }
}

function result(request, hello, state, verbs) {
  const { verb } = request;
  if (verb === "hello") return { protocol: "adapter-v1", ...hello };
  if (verb === "stop") return {};
  if (verb === "load") {
    if (!request.Q) throw new Error("`load` without Q");
    state.Q = request.Q;
    return {};
  }
  if (verb === "union" && verbs.unionOf) return verbs.unionOf(request.sets);
  if (verb === "offset" && verbs.offsetOf) return verbs.offsetOf(request.P, request.radius, request);
  if (verb === "at" && verbs.sumOf) {
    if (!state.Q) throw new Error("`at` before any `load`");
    return verbs.sumOf(request.sP, state.Q);
  }
  throw new Skipped("no such verb here");
}

export function serve(hello, verbs) {
  const state = {};
  createInterface({ input: process.stdin }).on("line", (line) => {
    let request = null;
    let value = null;
    try {
      request = JSON.parse(line);
      value = { status: "result", ...result(request, hello, state, verbs) };
    } catch (error) {
      const status = error instanceof Skipped ? "skipped" : "errored";
      value = { status, reason: String(error).slice(0, 4000) };
    }
    process.stdout.write(`${JSON.stringify({ seq: request?.seq ?? null, ...value })}\n`);
    if (request?.verb === "stop") process.exit(0);
  });
}
