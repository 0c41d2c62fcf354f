// The page: a scale and a place on the path, and what follows from them.
const state = { scale: windowFirst, exact: null, share: 0, bound: -1 };  // `exact`: the scale as a text, where it is known
let asked = false;

const isInWindow = (i) => data.bounds[i]?.about.scale >= windowFirst && data.bounds[i].about.scale <= windowLast;

function move(change) {
  if (!Number.isFinite(change.scale ?? 0) || !Number.isFinite(change.share ?? 0)) return;
  Object.assign(state, { bound: -1 }, change.scale === undefined ? {} : { exact: null }, change);
  state.scale = clampScale(state.scale);
  state.share = Math.min(Math.max(state.share, 0), 1);
  if (!asked) { asked = true; requestAnimationFrame(() => { asked = false; show(); }); }
}

function goToBound(i) {
  if (!isInWindow(i)) return;
  const { scale: exact, at, about } = data.bounds[i];
  move({ scale: about.scale, exact, share: shareOfPlace(at.segment, about.t), bound: i });
}

function nextBound() {
  if (state.bound >= 0) return state.bound + 1;
  return data.bounds.findIndex(({ about }) => about.scale > state.scale);
}

function previousBound() {
  if (state.bound >= 0) return state.bound - 1;
  return data.bounds.findLastIndex(({ about }) => about.scale < state.scale);
}

// At a bound the place is that of the contact, as the reference gives it.
function placeHere() {
  const place = placeAt(state.share);
  if (state.bound < 0) return place;
  const { at, about } = data.bounds[state.bound];
  return { segment: at.segment, t: about.t, x: about.point[0], y: about.point[1] };
}

const exactScale = () => (state.exact === null ? fractionOfDouble(state.scale) : fractionOf(state.exact));

// No place collides at a valid scale, whatever the polygons say in doubles.
function collisionHere(valid) {
  const { segment, t } = placeHere();
  return valid ? null : collisionAt(segment, t, state.scale);
}

function tellSituation(valid, collision) {
  const word = document.createElement("b"), place = placeHere();
  word.className = valid ? "valid" : "bad";
  word.textContent = valid ? "valid: the part passes" : "not valid";
  const here = valid ? "" : collision ? ", it collides here" : ", it is free here";
  element("situation").replaceChildren(word, `${here} · ${placeText(place)}`);
}

function showChosen() {
  const lines = state.bound >= 0 ? boundLines(data.bounds[state.bound]) : ["Click a bound, in the diagram or in the list, to see the contact that is its cause."];
  element("chosen").replaceChildren(...lines.map((text) => Object.assign(document.createElement("div"), { textContent: text })));
}

function show() {
  const valid = isValid(exactScale()), collision = collisionHere(valid), place = placeHere();
  if (element("follow").checked) drawing.fit(place, state.scale);
  drawing.draw(place, state.scale, collision, data.bounds[state.bound] ?? null);
  diagram.show(state.share, state.scale, collision, state.bound);
  boundList.show(state.bound);
  element("slider").value = shareOfScale(state.scale);
  element("place-slider").value = state.share;
  const field = element("scale");
  if (document.activeElement !== field || !field.classList.contains("bad")) {
    field.value = state.exact ?? short(state.scale, 8);
    field.classList.remove("bad");
    field.style.width = `${Math.min(Math.max(field.value.length + 3, 14), 72)}ch`;
  }
  element("about").textContent = state.exact !== null && state.exact !== short(state.scale) ? `≈ ${short(state.scale, 9)}` : "";
  element("previous").disabled = !isInWindow(previousBound());
  element("next").disabled = !isInWindow(nextBound());
  showChosen();
  tellSituation(valid, collision);
}

function layOut() {
  diagram.draw(goToBound);
  show();
}

const alongBy = (step) => move({ share: state.share + step });
const scaleBy = (step) => move({ scale: scaleAt(shareOfScale(state.scale) + step) });
const fine = (event) => (event.shiftKey ? 0.0005 : 0.005);
const keys = {
  ArrowLeft: (event) => alongBy(-fine(event)),
  ArrowRight: (event) => alongBy(fine(event)),
  ArrowDown: (event) => scaleBy(-fine(event)),
  ArrowUp: (event) => scaleBy(fine(event)),
  PageDown: () => goToBound(previousBound()),
  PageUp: () => goToBound(nextBound()),
  Home: () => move({ share: 0 }),
  End: () => move({ share: 1 }),
};

function enter(field) {
  const s = scaleOf(field.value);
  field.classList.toggle("bad", !(s >= windowFirst && s <= windowLast) || fractionOf(field.value) === null);
  if (!field.classList.contains("bad")) move({ scale: s, exact: field.value.trim().replace(",", ".") });
}

function listen() {
  element("slider").addEventListener("input", (event) => move({ scale: scaleAt(Number(event.target.value)) }));
  element("place-slider").addEventListener("input", (event) => move({ share: Number(event.target.value) }));
  diagram.listen((share, s) => move({ share, scale: s }));
  listenToControls({
    keys, enter, layOut,
    previous: () => goToBound(previousBound()),
    next: () => goToBound(nextBound()),
    fit: () => { drawing.fit(placeHere(), state.scale); show(); },
    redraw: ["show-pieces", "follow"],
    recolour: () => boundList.fill(goToBound),
  });
  listenToPicture(nothingAtPointer);
  new ResizeObserver(layOut).observe(element("diagram-box"));
}

element("counts").textContent = [
  `contact ${data.contact}`, `s from ${data.window[0][0]} to ${data.window[1][0]}`, several(corners.length, "vertex of the path", "vertices of the path"),
  several(polygons.length, "bad polygon"), several(data.bounds.length, "bound"),
].join(" · ");
element("valid").classList.toggle("none", !data.valid.length);
boundList.fill(goToBound);
listen();
layOut();
const firstBound = data.bounds.findIndex((_, i) => isInWindow(i));
if (firstBound >= 0) goToBound(firstBound); else move({ scale: (windowFirst + windowLast) / 2, share: 0.5 });

// For tests and scripts.
window.minkref = {
  moveTo: (scale, share) => move({ scale, share }),
  goToBound,
  isValid: (scale) => isValid(typeof scale === "string" ? fractionOf(scale) : fractionOfDouble(scale)),
  collides: (segment, t, scale) => collisionAt(segment, t, scale) !== null,
  get scale() { return state.scale; },
  get place() { return { ...placeHere(), share: state.share }; },
  get bound() { return state.bound; },
  get part() {
    const { x, y } = placeHere();
    return data.part.map((polygon) => polygon.map((ring) => ring.map((number, i) => (i % 2 ? y : x) + state.scale * number)));
  },
};
