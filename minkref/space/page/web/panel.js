// The panel beside the picture: the legend with its counts, exact facts, the update, what is chosen.
function node(name, attributes = {}, ...children) {
  const made = document.createElement(name);
  for (const [key, value] of Object.entries(attributes)) made.setAttribute(key, value);
  made.append(...children);
  return made;
}

const present = kinds.filter((kind) => frames.some((frame) => frame.kinds[kind]));

function buildLegend(changed) {
  for (const kind of present) {
    const box = node("input", { type: "checkbox", id: `show-${kind}`, checked: "" });
    box.addEventListener("change", changed);
    element("kinds").append(node("li", {}, node("label", {}, box, node("b", { class: `key ${kind.replace("+", "-")}` }),
      node("b", {}, kind), node("span", {}, meaning[kind]), node("output", { class: "many", id: `count-${kind}` }))));
  }
}
const isShown = (kind) => element(`show-${kind}`).checked;

function facts(list, rows) {
  list.replaceChildren(...rows.flatMap(([name, value, title]) => [
    node("dt", {}, name), node("dd", title ? { title, class: "long" } : {}, value),
  ]));
}

function tellFrame(index) {
  const frame = frames[index];
  element("scale").textContent = `S = ${scaleText(frame.scale)}`;
  element("scale").title = scaleText(frame.scale, true);
  element("number").textContent = `frame ${index + 1} of ${frames.length}`;
  element("caption").textContent = captionText(frame);
  element("slider").value = index;
  element("slider").setAttribute("aria-valuetext", `frame ${index + 1}, S = ${scaleText(frame.scale)}`);
  element("previous").disabled = index === 0;
  element("next").disabled = index === frames.length - 1;
  for (const kind of present) {
    element(`count-${kind}`).textContent = counted(frame.kinds[kind]);
    element(`count-${kind}`).closest("label").classList.toggle("none", !frame.kinds[kind]);
  }
  const volume = fraction(frame.volume);
  const exact = written(volume);
  facts(element("facts"), [
    ["volume", cut(exact), exact],
    ...(exact.length > 10 ? [["", `≈ ${about(volume)}`]] : []),
    ...(frame.pairs ? [] : [["shape", shapeText(frame)]]),
    ["SHA-256", frame.digest, frame.digest],
  ]);
  tellStep(index);
  for (const [which, scaled] of [["P", true], ["Q", false]]) {
    const body = operands[which];
    element(`told-${which}`).textContent = `${which} = ${body.name.split("/").pop()}${scaled ? ", scaled" : ""}: ` +
      `${counted(body.points.length)} vertices, ${several(body.faces.length, "facet")}`;
  }
}

function tellStep(index) {
  const frame = frames[index], box = element("step");
  if (!frame.pairs) {
    box.replaceChildren(node("p", {}, "Nothing: each frame is found from scratch."));
    return;
  }
  if (index === 0) {
    box.replaceChildren(node("p", {}, "Nothing: the first frame is found from scratch."));
    return;
  }
  const found = [several(frame.fv_errors, "fv-error"), several(frame.vf_errors, "vf-error"), several(frame.ee_errors, "ee-error")];
  const walked = `${several(frame.descent_steps, "descent step")}, ${several(frame.chains_walked, "chain")} walked`;
  box.replaceChildren(node("p", {}, `From frame ${index}, S = ${scaleText(frames[index - 1].scale)}: `,
    node("b", {}, found.join(", ")), `; ${walked}.`));
}

const cornersTold = 60;
const exactly = (point) => node("span", { class: "exact", title: `(${point.map(written).join(", ")})` },
  `(${point.map((number) => signed(cut(written(number)))).join(", ")})`);

function tellChosen(frame, picture, chosen) {
  const box = element("chosen");
  element("clear").disabled = !chosen;
  element("facet").value = chosen?.what === "facet" ? chosen.number : "";
  element("vertex").value = chosen?.what === "vertex" ? chosen.number : "";
  element("facet").max = frame.facets - 1;
  element("vertex").max = frame.vertices - 1;
  if (!chosen) {
    box.replaceChildren(node("p", { class: "faint" }, "Click one in the picture, or type its number: its parents are marked in P and Q."));
    return;
  }
  const { what, number } = chosen;
  if (what === "vertex" && !frame.pairs) {
    const point = exactPoint(frame, number);
    box.replaceChildren(node("p", {}, node("b", {}, `vertex ${number}`)), node("p", {}, exactly(point)),
      node("p", { class: "faint" }, `≈ (${point.map(about).join(", ")})`));
    return;
  }
  if (what === "vertex") {
    const [p, q] = frame.pairs.slice(2 * number, 2 * number + 2);
    const point = exactPoint(frame, number);
    box.replaceChildren(
      node("p", {}, node("b", {}, `vertex ${number}`), ` = vertex ${p} of P + vertex ${q} of Q`), node("p", {}, exactly(point)),
      node("p", { class: "faint" }, `≈ (${point.map(about).join(", ")})`));
    return;
  }
  const ring = picture.outlines[number].flat(), parents = picture.parents[number], kind = picture.kinds[number];
  const corners = ring.slice(0, cornersTold).map((vertex) =>
    node("li", {}, node("span", { class: "faint" }, `vertex ${vertex} ${frame.pairs ? `= ${frame.pairs[2 * vertex]} + ${frame.pairs[2 * vertex + 1]} ` : ""}`),
      exactly(exactPoint(frame, vertex))));
  if (ring.length > cornersTold) corners.push(node("li", {}, `and ${ring.length - cornersTold} more`));
  box.replaceChildren(
    node("p", {}, node("b", {}, `facet ${number}: ${kind}`), `${parents.length > 1 ? " in the plane of" : " ="} ${parentsText(parents, cornersTold, ", ")}`),
    node("p", { class: "faint" }, `${several(ring.length, "corner")}, as vertices of the sum${frame.pairs ? " = of P + of Q" : ""}:`), node("ol", {}, ...corners));
}
