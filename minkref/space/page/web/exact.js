// Exact numbers: fractions in lowest terms as [numerator, denominator], denominators positive.
const gcd = (a, b) => {
  if (a < 0n) a = -a;
  while (b) [a, b] = [b, a % b];
  return a;
};
const lowest = (n, d) => {
  const common = gcd(n, d);
  return common > 1n ? [n / common, d / common] : [n, d];
};
const fraction = (text) => {
  const [n, d = "1"] = text.split("/");
  return [BigInt(n), BigInt(d)];
};
const plus = ([a, b], [c, d]) => lowest(a * d + c * b, b * d);
const times = ([a, b], [c, d]) => lowest(a * c, b * d);
const written = ([n, d]) => (d === 1n ? String(n) : `${n}/${d}`);

// To eight digits, of numbers of any size.
function about([n, d]) {
  const sign = n < 0n ? "−" : "", size = n < 0n ? -n : n;
  if (!size) return "0";
  const places = 18 - (String(size).length - String(d).length);
  const digits = places >= 0 ? (size * 10n ** BigInt(places)) / d : size / (d * 10n ** BigInt(-places));
  const value = Number(`${digits}e${-places}`);
  if (value >= 1e-4 && value < 1e12) return sign + Number(value.toPrecision(8));
  const lead = String(digits);
  return `${sign}${Number(`${lead[0]}.${lead.slice(1)}`).toPrecision(8).replace(/\.?0+$/, "")}e${lead.length - 1 - places}`;
}

const longest = 22;  // characters of a number in running text
const signed = (text) => text.replace("-", "−");
const short = (number) => {
  const text = written(number);
  return text.length <= longest ? signed(text) : `≈ ${about(number)}`;
};
const cut = (text) => (text.length > 2 * longest ? `${text.slice(0, longest)}…${text.slice(-longest)}` : text);
