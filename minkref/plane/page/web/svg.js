// Elements of SVG, and round numbers for an axis.
function svg(name, attributes = {}, ...children) {
  const element = document.createElementNS("http://www.w3.org/2000/svg", name);
  for (const [key, value] of Object.entries(attributes)) element.setAttribute(key, value);
  element.append(...children);
  return element;
}

// The multiples of 1, 2 or 5 times a power of ten between two numbers: some four to eight.
function roundNumbers(first, last) {
  const length = last - first, unit = 10 ** Math.floor(Math.log10(length / 4)), found = [];
  const step = [1, 2, 5, 10].map((n) => n * unit).find((n) => length / n <= 8);
  for (let i = Math.ceil(first / step); i * step <= last * (1 + 1e-12); ++i) found.push(Number((i * step).toPrecision(12)));
  return found;
}
