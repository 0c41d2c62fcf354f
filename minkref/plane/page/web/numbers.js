// Numbers as texts, texts as numbers, and places in lists of them.
const short = (number, digits = 6) => String(Number(Number(number).toPrecision(digits)));

// A long fraction is cut in running text; it is whole where it is chosen.
const cut = (text) => (text.length > 24 ? `${text.slice(0, 11)}…${text.slice(-11)}` : text);

// A number or a fraction; NaN if it is neither.
function scaleOf(text) {
  const parts = text.trim().replace(",", ".").split("/");
  if (parts.length > 2 || parts.some((part) => !/^\d*\.?\d+(e[+-]?\d+)?$|^\d+\.$/i.test(part.trim()))) return NaN;
  return parts.length === 2 ? Number(parts[0]) / Number(parts[1]) : Number(parts[0]);
}

// The first number in an ascending list that is greater than s: its place.
function placeAfter(list, s) {
  let low = 0, high = list.length;
  while (low < high) {
    const middle = (low + high) >> 1;
    if (list[middle] > s) high = middle; else low = middle + 1;
  }
  return low;
}
