// A plane across an axis that takes away a part of the sum, and what it lays open. A cut is { axis, at, side }: what has
// side * (coordinate - at) <= 0 is left.
const height = (point, { axis, at, side }) => side * (point[axis] - at);
const isLeft = (point, cut) => !cut || height(point, cut) <= 0;

function between(a, b, cut) {
  const s = height(a, cut), t = height(b, cut), part = s / (s - t);
  return a.map((axis, i) => (i === cut.axis ? cut.at : axis + part * (b[i] - axis)));
}
// The same for the two triangles at an edge.
const crossing = (points, v, w, cut) => (v < w ? between(points[v], points[w], cut) : between(points[w], points[v], cut));

// The rest of a triangle after the cut: its corners.
function leftOf(points, triangle, cut) {
  if (!cut) return triangle.map((v) => points[v]);
  return triangle.flatMap((v, k) => {
    const w = triangle[(k + 1) % 3], here = isLeft(points[v], cut);
    return [...(here ? [points[v]] : []), ...(here !== isLeft(points[w], cut) ? [crossing(points, v, w, cut)] : [])];
  });
}

// The rest of a segment after the cut; null for nothing.
function partLeft([a, b], cut) {
  if (!cut) return [a, b];
  const here = isLeft(a, cut), there = isLeft(b, cut);
  if (here === there) return here ? [a, b] : null;
  return here ? [a, between(a, b, cut)] : [between(a, b, cut), b];
}

// The segments in which the plane meets the surface.
function segmentsOf(body, cut) {
  const segments = [];
  for (const triangles of body.triangles) {
    for (const triangle of triangles) {
      const ends = triangle.flatMap((v, k) => {
        const w = triangle[(k + 1) % 3];
        return isLeft(body.points[v], cut) === isLeft(body.points[w], cut) ? [] : [crossing(body.points, v, w, cut)];
      });
      if (ends.length === 2) segments.push(ends);
    }
  }
  return segments;
}

// Trapezoids that fill what closed curves enclose: between two levels of `v` the segments in the order of `u`, in pairs.
const mostTrapezoids = 200000;
function filled(segments, u, v) {
  const rising = segments.map(([a, b]) => (a[v] < b[v] ? [a, b] : [b, a])).filter(([a, b]) => a[v] < b[v]);
  rising.sort(([a], [b]) => a[v] - b[v]);
  const levels = [...new Set(rising.flatMap(([a, b]) => [a[v], b[v]]))].sort((a, b) => a - b);
  const along = ([a, b], level) => (level === b[v] ? b[u] : a[u] + ((level - a[v]) / (b[v] - a[v])) * (b[u] - a[u]));
  const found = [];
  let active = [], next = 0;
  for (let k = 0; k + 1 < levels.length; ++k) {
    const low = levels[k], high = levels[k + 1];
    active = active.filter(([, b]) => b[v] > low);
    while (next < rising.length && rising[next][0][v] <= low) active.push(rising[next++]);
    const places = active.map((segment) => [along(segment, low), along(segment, high)]);
    places.sort((a, b) => a[0] + a[1] - b[0] - b[1]);
    for (let j = 0; j + 1 < places.length; j += 2) found.push([low, high, places[j], places[j + 1]]);
    if (found.length > mostTrapezoids) return [];
  }
  return found;
}

// The section and its outline, as traces.
function section(body, cut, pixels) {
  if (!cut) return [];
  const [u, v] = [0, 1, 2].filter((axis) => axis !== cut.axis);
  const segments = segmentsOf(body, cut), points = [], i = [], j = [], k = [];
  const put = (along, level) => {
    const point = [0, 0, 0];
    [point[cut.axis], point[u], point[v]] = [cut.at, along, level];
    points.push(point);
  };
  for (const [low, high, left, right] of filled(segments, u, v)) {
    const first = points.length;
    put(left[0], low);
    put(right[0], low);
    put(right[1], high);
    put(left[1], high);
    i.push(first, first);
    j.push(first + 1, first + 2);
    k.push(first + 2, first + 3);
  }
  const stand = cut.side * Math.max(0.5 / pixels, standOff);
  const raised = (point) => point.map((axis, n) => (n === cut.axis ? axis + stand : axis));
  return [
    { type: "mesh3d", name: "section", ...columns(points), i, j, k, color: colour("section"), hoverinfo: "skip", showscale: false,
      lighting: { ambient: 1, diffuse: 0, specular: 0, fresnel: 0, roughness: 1 } },
    { type: "scatter3d", mode: "lines", name: "outline", hoverinfo: "skip",
      ...columns(segments.flatMap((ends) => [...ends.map(raised), null])), line: { color: colour("chosen"), width: 3 } },
  ];
}

// As the controls have it. The plane keeps off round numbers, where faces may lie.
function wantedCut(frame, body) {
  const chosen = element("cut-axis").value, off = chosen === "";
  element("cut").disabled = off;
  element("cut-flip").disabled = off;
  element("cut-at").textContent = "";
  if (off) return null;
  const axis = Number(chosen), share = Number(element("cut").value) / 1000 - 0.5;
  const at = share * body.sides[axis] + 3.7e-7;
  if (frame.size !== null && frame.centre[axis] !== null) {
    element("cut-at").textContent = `at ${signed(String(Number((frame.centre[axis] + frame.size * share * body.sides[axis]).toPrecision(6))))}`;
  }
  return { axis, at, side: element("cut-flip").checked ? -1 : 1 };
}
