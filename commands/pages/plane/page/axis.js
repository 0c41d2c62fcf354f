// The logarithmic axis of scales, and elements of SVG.
const logFirst = Math.log(windowFirst), logLength = Math.log(windowLast) - Math.log(windowFirst);
const shareOf = (s) => (Math.log(s) - logFirst) / logLength;  // 0 to 1 along the axis
const clampScale = (s) => Math.min(Math.max(s, windowFirst), windowLast);
const scaleAt = (share) => clampScale(Math.exp(logFirst + Math.min(Math.max(share, 0), 1) * logLength));

function svg(name, attributes = {}, ...children) {
  const element = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  element.append(...children);
  return element;
}

// Round numbers of the window: 1, 2, 5 in each power of ten if there are several, else more.
function roundScales() {
  const decades = logLength / Math.LN10, found = [];
  if (decades >= 0.8) {
    const steps = decades > 8 ? [1] : decades > 4 ? [1, 3] : [1, 2, 5];
    const stride = Math.ceil(decades / 12);
    for (let e = Math.floor(Math.log10(windowFirst)); e <= Math.log10(windowLast) + 1; e += stride) {
      for (const step of steps) found.push(Number(`${step}e${e}`));
    }
  } else {
    const length = windowLast - windowFirst, unit = 10 ** Math.floor(Math.log10(length / 4));
    const step = [1, 2, 5, 10].map((n) => n * unit).find((n) => length / n <= 8);
    for (let i = Math.ceil(windowFirst / step); i * step <= windowLast * (1 + 1e-12); ++i) {
      found.push(Number((i * step).toPrecision(12)));
    }
  }
  return found.filter((s) => s >= windowFirst * (1 - 1e-12) && s <= windowLast * (1 + 1e-12));
}

// Ticks from `left` to `left + width`, with labels at height `y` where there is room for them.
function axisTicks(left, width, top, bottom, y) {
  const group = svg("g", { class: "axis" });
  let taken = -Infinity;
  for (const s of roundScales()) {
    const x = left + width * shareOf(s), half = 3.5 * String(s).length;
    group.append(svg("line", { x1: x, x2: x, y1: top, y2: bottom }));
    if (x - half < taken) continue;
    const text = svg("text", { x, y, "text-anchor": "middle" });
    text.textContent = String(s);
    group.append(text);
    taken = x + half + 3;
  }
  return group;
}
