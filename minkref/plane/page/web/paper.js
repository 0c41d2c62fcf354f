// The paper's own program beside the exact sum, where the page has it. Then the page stands only at
// the scales that the program goes through, and at boundary events.
const paper = {
  run: data.paper ?? null,
  lines: [],  // of the runs of wrong steps: {first, last, line}

  // The step next to a scale on the axis.
  stepNear(s) {
    const steps = this.run.steps;
    let k = 0;
    while (k + 1 < steps.length && Math.sqrt(steps[k].about * steps[k + 1].about) <= s) ++k;
    return k;
  },
  // The step at a scale, or -1.
  stepAt(s) { return this.run ? this.run.steps.findIndex((step) => step.about === s) : -1; },
  scaleNear(s) { return this.run ? this.run.steps[this.stepNear(s)].about : s; },
  scaleAfter(s, by) {
    const k = this.stepNear(s) + by;
    return this.run.steps[Math.min(Math.max(k, 0), this.run.steps.length - 1)].about;
  },

  // Over the exact sum: what the answer has lost and added, and the witness.
  draw(context, s, X, Y) {
    const step = this.run && this.run.steps[this.stepAt(s)];
    if (!step) return;
    for (const name of ["lost", "added"]) {
      const path = new Path2D();
      for (const polygon of step[name] ?? []) for (const ring of polygon) addRing(path, ring, 1, X, Y);
      context.fillStyle = colour(name);
      context.strokeStyle = colour(`${name}-line`);
      context.lineWidth = 1.1;
      context.fill(path, "evenodd");
      context.stroke(path);
    }
    if (!step.witness) return;
    context.beginPath();
    context.arc(X(step.witness[0]), Y(step.witness[1]), 3.5, 0, 2 * Math.PI);
    context.fillStyle = colour("ink");
    context.fill();
  },

  // Widens the box by the added polygons, within one size of the exact sum: farther off nothing else would be seen.
  widen(box, s) {
    const step = this.run && this.run.steps[this.stepAt(s)];
    if (!step || box.empty) return;
    const { xmin, ymin, xmax, ymax } = box, reach = Math.max(box.across, box.up);
    const within = (v, low, high) => Math.min(Math.max(v, low - reach), high + reach);
    for (const polygon of step.added ?? []) {
      const ring = polygon[0];
      for (let i = 0; i < ring.length; i += 2) box.add(within(ring[i], xmin, xmax), within(ring[i + 1], ymin, ymax));
    }
  },

  // Runs of steps at which the structure is another one: [first, last].
  wrongRuns() {
    const runs = [];
    this.run.steps.forEach((step, k) => {
      if (step.right) return;
      const last = runs[runs.length - 1];
      if (last && last[1] === k - 1) last[1] = k; else runs.push([k, k]);
    });
    return runs;
  },

  // A bar along the strip where the program is wrong.
  bars(x) {
    if (!this.run) return [];
    const abouts = this.run.steps.map((step) => step.about);
    const edge = (k) => x(k <= 0 ? abouts[0] : k >= abouts.length ? abouts[k - 1] : Math.sqrt(abouts[k - 1] * abouts[k]));
    return this.wrongRuns().map(([first, last]) => svg("rect", {
      class: "wrong", x: edge(first), y: 2, width: Math.max(edge(last + 1) - edge(first), 2), height: 5,
      fill: colour("lost-line"),
    }));
  },

  fill(goTo) {
    if (!this.run) return;
    document.documentElement.classList.add("paper");
    document.querySelectorAll(".of-paper").forEach((one) => { one.hidden = false; });
    const { steps, events, arithmetic, readings } = this.run, runs = this.wrongRuns();
    const wrong = steps.filter((step) => !step.right).length;
    element("paper-what").textContent = `${arithmetic}; ${Object.entries(readings).map(([name, value]) => `${name} ${value}`).join(", ")}`;
    element("paper-counts").textContent = wrong ? `Wrong at ${counted(wrong)} of ${several(steps.length, "scale")}.` : `Right at all ${several(steps.length, "scale")}.`;
    const row = (cells, s) => {
      const line = document.createElement("tr");
      cells.forEach(([text, title = ""]) => {
        const cell = document.createElement("td");
        cell.textContent = text;
        cell.title = title;
        line.append(cell);
      });
      line.addEventListener("click", () => goTo(s));
      return line;
    };
    this.lines = runs.map(([first, last]) => {
      const from = steps[first], to = steps[last];
      const range = first === last ? short(from.about) : `${short(from.about)} to ${short(to.about)}`;
      return { first, last, line: row([[range, from.scale], [from.words]], from.about) };
    });
    document.querySelector("#paper-wrong tbody").replaceChildren(...this.lines.map(({ line }) => line));
    for (const name of ["missed", "invented"]) {
      const listed = this.run[name];
      const words = `${counted(events[name])} ${name} at all scales`;
      element(`paper-${name}-count`).textContent = listed.length ? `${words}; the first ${counted(listed.length)} of the window:` : `${words}, none in the window.`;
      document.querySelector(`#paper-${name} tbody`).replaceChildren(...listed.map((event) =>
        row([[short(event.about), event.scale], [event.change], [`${event.a}, ${event.b}`]], event.about)));
    }
    const rest = `${counted(events.right)} right, ${counted(events.misplaced)} at another scale`;
    element("paper-events").textContent = `Pair events, all scales: ${rest}.`;
  },

  show(s) {
    if (!this.run) return;
    const k = this.stepAt(s), step = this.run.steps[k];
    element("paper-here").textContent = !step
      ? "At an event: the program stands only at the steps of the slider."
      : `s = ${step.scale}: ${step.words}.${step.lost === null ? " It is too large to be drawn." : ""}`;
    element("paper-here").classList.toggle("wrong", !!step && !step.right);
    for (const { first, last, line } of this.lines) line.classList.toggle("here", first <= k && k <= last);
  },
};
