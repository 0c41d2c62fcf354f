// The logarithmic axis of scales.
const logFirst = Math.log(windowFirst), logLength = Math.log(windowLast) - Math.log(windowFirst);
const shareOf = (s) => (Math.log(s) - logFirst) / logLength;  // 0 to 1 along the axis
const clampScale = (s) => Math.min(Math.max(s, windowFirst), windowLast);
const scaleAt = (share) => clampScale(Math.exp(logFirst + Math.min(Math.max(share, 0), 1) * logLength));

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
    found.push(...roundNumbers(windowFirst, windowLast));
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
