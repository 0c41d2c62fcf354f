// Numbers as fractions of whole numbers, [n, d] with d > 0: whether a scale is valid is decided exactly.
function fractionOf(text) {
  const parts = text.trim().replace(",", ".").split("/").map(decimal);
  if (parts.length > 2 || parts.includes(null)) return null;
  const [[n, d], [m, e]] = [parts[0], parts[1] ?? [1n, 1n]];
  return m === 0n ? null : [n * e, d * m];
}

function decimal(text) {
  const found = /^(\d*)\.?(\d*)(?:e([+-]?\d{1,3}))?$/i.exec(text.trim());
  if (!found || !(found[1] + found[2])) return null;
  const power = Number(found[3] ?? 0) - found[2].length, digits = BigInt(found[1] + found[2]);
  return power < 0 ? [digits, 10n ** BigInt(-power)] : [digits * 10n ** BigInt(power), 1n];
}

// A double is a fraction, too.
function fractionOfDouble(number) {
  let d = 1n;
  while (!Number.isInteger(number)) { number *= 2; d *= 2n; }
  return [BigInt(number), d];
}

const difference = (a, b) => a[0] * b[1] - b[0] * a[1];  // its sign compares them

const validRanges = data.valid.map((range) => ({
  ...range, low: fractionOf(range.from), high: range.to === null ? null : fractionOf(range.to),
}));

function isValid(scale) {
  return validRanges.some((range) => {
    const low = difference(scale, range.low), high = range.high ? difference(scale, range.high) : -1n;
    return (low > 0n || (range.from_in && low === 0n)) && (high < 0n || (range.to_in && high === 0n));
  });
}
