// The controls, and the three pictures that follow them.
const names = ["sum", "P", "Q"];
const plots = Object.fromEntries(names.map((name) => [name, element(`plot-${name}`)]));
const state = { index: 0, chosen: null, camera: home, cut: null };
const margin = 1.06;
let pictures = null, pending = null, turning = false, wanted = null, held = null;  // held: the picture under the pointer

// Half the sides of the box of all frames, in the unit of a frame; null where a size is beyond doubles.
function commonHalves(frame) {
  if (frames.some(({ size }) => size === null)) return null;
  return [0, 1, 2].map((i) => Math.max(...frames.map((f) => ((f.P[i] + f.Q[i]) * f.size) / frame.size)) / 2);
}

function sumHalves(frame) {
  const halves = element("fitted").checked ? null : commonHalves(frame);
  const own = halves ?? pictures.sum.sides.map((side) => side / 2);
  const least = 0.02 * Math.max(...own);
  return own.map((half) => half * margin + least);
}

function halvesOf(name, frame) {
  if (name === "sum") return sumHalves(frame);
  const body = pictures[name];
  if (!element("one-unit").checked) return body.sides.map((side) => (side / 2) * margin + 0.02);
  return sumHalves(frame).map((half) => half / (body.share || 1));
}

function marked(name) {
  if (!state.chosen) return [];
  const { what, number } = state.chosen, { pairs } = frames[state.index];
  if (what === "vertex") {
    if (name === "sum") return [[number]];
    return pairs ? [[pairs[2 * number + (name === "P" ? 0 : 1)]]] : [];
  }
  if (name === "sum") return pictures.sum.outlines[number];
  const found = new Map(pictures.sum.parents[number].map((pair) => [pair[name].join(), pair[name]]));
  return [...found].map(([text, vertices]) =>
    (vertices.length > 2 ? operands[name].faces[operands[name].numbers.get(text)] : vertices));
}

function traces(name, halves, share) {
  const body = pictures[name];
  const drawn = name === "sum" ? present : [name === "P" ? "fv" : "vf"];
  const shown = (id) => element(id).checked, cut = name === "sum" ? state.cut : null;
  const pixels = Math.max((plots[name].clientHeight * 0.5 * drawnLength(halves, share)) / seenHeight, 1);
  return [
    ...drawn.map((kind) => facets(body, kind, name !== "sum" || isShown(kind), cut)),
    ...(name === "sum" ? section(body, cut, pixels) : []),
    edgeLines(body, pixels, shown("show-edges"), cut), vertexMarks(body, pixels, shown("show-vertices"), cut),
    chosenMark(body, pixels, marked(name)),
  ];
}

async function draw() {
  const frame = frames[state.index];
  for (const name of names) {
    const axes = name === "sum" && element("show-axes").checked ? frame : null;
    const halves = halvesOf(name, frame), share = Math.min(plots[name].clientWidth / plots[name].clientHeight, 1) || 1;
    await Plotly.react(plots[name], traces(name, halves, share), layout(halves, axes, state.camera, share), config);
  }
}

// One drawing at a time; what changes meanwhile is drawn after it.
function redraw() {
  if (pending) {
    pending.again = true;
    return pending.done;
  }
  const mine = { again: false };
  pending = mine;
  mine.done = (async () => {
    do {
      mine.again = false;
      await draw();
    } while (mine.again);
    pending = null;
  })();
  return mine.done;
}

function show(index) {
  const next = Math.min(Math.max(Math.round(index), 0), frames.length - 1);
  if (next !== state.index || !pictures) {
    const frame = frames[next];
    state.index = next;
    state.chosen = null;
    pictures = { sum: sumSolid(frame), P: operandSolid(frame, "P"), Q: operandSolid(frame, "Q") };
  }
  tip("");
  state.cut = wantedCut(frames[next], pictures.sum);
  tellFrame(state.index);
  tellEvents(state.index);
  tellChosen(frames[state.index], pictures.sum, state.chosen);
  return redraw();
}

function choose(what, number) {
  const count = what === "facet" ? frames[state.index].facets : frames[state.index].vertices;
  state.chosen = Number.isInteger(number) && number >= 0 && number < count ? { what, number } : null;
  tellChosen(frames[state.index], pictures.sum, state.chosen);
  return redraw();
}

// Turns the chosen to the front: its parents face the same way.
function face() {
  if (!state.chosen) return;
  const { what, number } = state.chosen, body = pictures.sum;
  const towards = what === "facet" ? body.normals[number] : body.outward[number];
  const { eye, center } = state.camera;
  const far = Math.hypot(eye.x - center.x, eye.y - center.y, eye.z - center.z);
  const [x, y, z] = towards.map((axis) => axis * far);
  const up = Math.abs(towards[2]) > 0.98 ? { x: 0, y: 1, z: 0 } : home.up;
  turn({ ...home, up, eye: { x, y, z } });
}

// All pictures look the same way; `from` already does. A turn asked for meanwhile is done after.
async function turn(camera, from = null) {
  state.camera = camera;
  wanted = from;
  tip("");
  if (turning) return;
  turning = true;
  let done = null;
  while (done !== state.camera) {
    await new Promise(requestAnimationFrame);
    done = state.camera;
    for (const name of names) {
      if (name !== wanted) await Plotly.relayout(plots[name], { "scene.camera": done });
    }
  }
  turning = false;
}

// The facet or vertex that an event of a picture means.
function pointed(event) {
  const point = event.points?.[0], meta = point && (point.data ?? point.fullData).meta;
  if (!meta?.numbers) return null;
  return { what: meta.what, number: meta.numbers[point.pointNumber] };
}

function listen(name) {
  const plot = plots[name];
  let mouse = { clientX: 0, clientY: 0 }, pressed = null, under = null;
  const on = (type, heard) => plot.addEventListener(type, heard, true);
  on("pointermove", (event) => { mouse = event; });
  on("pointerenter", () => { held = name; });
  on("pointerdown", (event) => {
    held = name;
    pressed = event;
    tip("");
  });
  on("pointerleave", () => {
    under = null;
    tip("");
  });
  on("click", (event) => {
    const still = pressed && Math.hypot(event.clientX - pressed.clientX, event.clientY - pressed.clientY) < 4;
    if (still && under && name === "sum") choose(under.what, under.number);
  });
  plot.on("plotly_hover", (event) => {
    under = pointed(event);
    tip(under ? tipText(name, pictures[name], frames[state.index], under.what, under.number) : "", mouse);
  });
  plot.on("plotly_unhover", () => {
    under = null;
    tip("");
  });
  // Only the picture that is being turned leads.
  const lead = (changes) => {
    const camera = changes["scene.camera"];
    if (camera && held === name) turn(camera, name);
  };
  plot.on("plotly_relayouting", lead);
  plot.on("plotly_relayout", lead);
}

buildLegend(redraw);
buildAxis(show);
document.body.classList.toggle("still", frames.length === 1);
const sort = frames[0].pairs ? "convex polyhedra" : "polyhedra";
element("counts").textContent = frames.length === 1 ? `Minkowski sum of ${sort}, exact`
  : `Minkowski sums of ${sort}, exact, at ${several(frames.length, "scale")}${frames[0].pairs ? ", each got from the one before" : ""}`;
element("slider").max = frames.length - 1;
element("fitted").disabled = frames.some(({ size }) => size === null);
element("slider").addEventListener("input", (event) => show(Number(event.target.value)));
element("previous").addEventListener("click", () => show(state.index - 1));
element("next").addEventListener("click", () => show(state.index + 1));
for (const id of ["show-edges", "show-vertices", "show-axes", "fitted", "one-unit"]) element(id).addEventListener("change", redraw);
for (const what of ["facet", "vertex"]) {
  element(what).addEventListener("change", (event) => {
    choose(what, event.target.value === "" ? NaN : Number(event.target.value)).then(face);
  });
}
for (const id of ["cut-axis", "cut", "cut-flip"]) {
  element(id).addEventListener("input", () => {
    state.cut = wantedCut(frames[state.index], pictures.sum);
    redraw();
  });
}
element("clear").addEventListener("click", () => choose("facet", NaN));
for (const button of document.querySelectorAll("[data-view]")) {
  const up = button.dataset.view === "z" ? { x: 0, y: 1, z: 0 } : home.up;
  button.addEventListener("click", () => turn({ ...home, up, eye: views[button.dataset.view] }));
}
matchMedia("(prefers-color-scheme: dark)").addEventListener("change", redraw);

window.minkref = { show, choose, frames, operands, exactPoint, get index() { return state.index; } };
window.minkref.ready = show(0).then(() => names.forEach(listen));
