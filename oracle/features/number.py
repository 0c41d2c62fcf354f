"""Exact real numbers: rationals, + - * / and square roots.

Signs come from intervals of more and more bits, and from a separation bound: a number nearer to 0
than its bound is 0 (Burnikel, Funke, Mehlhorn, Schirra and Schmitt, "A separation bound for real
algebraic expressions", ESA 2001)."""

from __future__ import annotations

from fractions import Fraction
from math import inf, isqrt, log2

Rational = Fraction | int
FIRST_BITS = 64
#: primes whose squares are taken out from under a root
PRIMES = [n for n in range(2, 1000) if all(n % k for k in range(2, isqrt(n) + 1))]


class Number:
    """A node of an expression; `rational`: its value, if known without a proof."""

    __slots__ = (
        "_bits", "_high", "_low", "above", "below", "parts", "rational", "root", "roots", "way",
    )  # fmt: skip

    def __init__(
        self, way: str, parts: tuple[Number, ...], rational: Fraction | None = None
    ) -> None:
        self.way, self.parts, self.rational = way, parts, rational
        self._bits, self._low, self._high = -1, 0, 0
        self.root: Number | None = None
        self.above, self.below = self._bounds()
        self.roots: frozenset[Number] = frozenset[Number]().union(*(p.roots for p in parts))
        if way == "root":
            self.roots |= {self}

    def _bounds(self) -> tuple[float, float]:
        """Logarithms: bounds for all conjugates of two algebraic integers with this quotient."""
        if self.rational is not None:
            top, below = abs(self.rational.numerator), self.rational.denominator
            return _log(max(top, 1)), _log(below)
        a = self.parts[0]
        if self.way == "root":
            half = (a.above + a.below) / 2
            return (half, a.below) if a.above >= a.below else (a.above, half)
        b = self.parts[1]
        if self.way == "*":
            return a.above + b.above, a.below + b.below
        if self.way == "/":
            return a.above + b.below, a.below + b.above
        p, q = a.above + b.below, b.above + a.below
        return max(p, q) + log2(1 + 2.0 ** -abs(p - q)), a.below + b.below

    def __add__(self, other: Number | Rational) -> Number:
        return _sum(self, number(other), "+")

    def __sub__(self, other: Number | Rational) -> Number:
        return _sum(self, number(other), "-")

    def __rsub__(self, other: Number | Rational) -> Number:
        return _sum(number(other), self, "-")

    def __neg__(self) -> Number:
        return _sum(number(0), self, "-")

    def __mul__(self, other: Number | Rational) -> Number:
        b = number(other)
        if self.rational is not None and b.rational is not None:
            return number(self.rational * b.rational)
        if self.rational is not None:
            return b * self
        if b.rational == 0:
            return b
        if b.rational == 1:
            return self
        if self is b and self.way == "root":
            return self.parts[0]
        return Number("*", (self, b))

    __radd__, __rmul__ = __add__, __mul__

    def __truediv__(self, other: Number | Rational) -> Number:
        """Divides by a number other than 0."""
        b = number(other)
        if b.rational is not None:
            return self * number(1 / b.rational)
        return self if self.rational == 0 else Number("/", (self, b))

    def __rtruediv__(self, other: Number | Rational) -> Number:
        return number(other) / self

    def bounds(self, bits: int) -> tuple[int, int]:
        """Integers around this number times 2^bits."""
        if self._bits < bits:
            self._low, self._high = self._evaluated(bits)
            self._bits = bits
        shift = self._bits - bits
        return self._low >> shift, -(-self._high >> shift)

    def _evaluated(self, bits: int) -> tuple[int, int]:
        if self.rational is not None:
            low, rest = divmod(self.rational.numerator << bits, self.rational.denominator)
            return low, low + (rest > 0)
        if self.way == "root":
            low, high = self.parts[0].bounds(2 * bits)
            return isqrt(max(low, 0)), _root_above(high)
        a, b = self.parts
        if self.way == "/":
            more = bits
            while True:
                (p, q), (r, s) = a.bounds(more), b.bounds(more)
                if r > 0 or s < 0:
                    break
                more = 2 * more + FIRST_BITS
            if r < 0:
                p, q, r, s = -q, -p, -s, -r
            least, most = (p << bits) // (s if p >= 0 else r), (-q << bits) // (r if q >= 0 else s)
            return least, -most
        (p, q), (r, s) = a.bounds(bits), b.bounds(bits)
        if self.way == "+":
            return p + r, q + s
        if self.way == "-":
            return p - s, q - r
        products = (p * r, p * s, q * r, q * s)
        return min(products) >> bits, -(-max(products) >> bits)

    def sign(self) -> int:
        """Exact. A proof of 0 takes as many bits as the separation bound."""
        if self.rational is not None:
            return (self.rational > 0) - (self.rational < 0)
        bits = FIRST_BITS
        while True:
            low, high = self.bounds(bits)
            if low > 0 or high < 0:
                return 1 if low > 0 else -1
            apart = self.apart
            if bits > apart and max(-low, high).bit_length() < bits - apart:
                self.rational = Fraction(0)
                return 0
            bits = 2 * bits if 4 * bits < apart else max(2 * bits, int(apart) + FIRST_BITS)

    @property
    def apart(self) -> float:
        """This number is 0, or at least 2^-apart."""
        degree: int = 2 ** len(self.roots)
        return (self.above * (degree - 1) + self.below) * (1 + 1e-9) + 2

    def __float__(self) -> float:
        if self.rational is not None:
            return float(self.rational)
        bits = FIRST_BITS
        while True:
            low, high = self.bounds(bits)
            if (high - low) << 60 <= max(abs(low), abs(high)) or bits > 4 * FIRST_BITS:
                return float(Fraction(low + high, 2 << bits))
            bits *= 2

    def __str__(self) -> str:
        if self.rational is not None:
            return str(self.rational)
        told = [f"({part})" if part.way in "+-/" else str(part) for part in self.parts]
        return f"sqrt({self.parts[0]})" if self.way == "root" else f" {self.way} ".join(told)


def _log(value: int) -> float:
    return log2(value) + 1e-9 if value > 1 else 0.0


def _root_above(square: int) -> int:
    root = isqrt(max(square, 0))
    return root + (root * root < square)


def number(value: Number | Rational) -> Number:
    return value if isinstance(value, Number) else Number("", (), Fraction(value))


def _sum(a: Number, b: Number, way: str) -> Number:
    if a.rational is not None and b.rational is not None:
        return number(a.rational + b.rational if way == "+" else a.rational - b.rational)
    if b.rational == 0:
        return a
    if a is b and way == "-":
        return number(0)
    if a.rational == 0 and way == "+":
        return b
    return Number(way, (a, b))


_ROOTS: dict[Fraction, Number] = {}


def root(value: Number | Rational) -> Number:
    """The square root of a number of at least 0, one for equal rationals."""
    x = number(value)
    if x.rational is None and x.sign() == 0:
        return number(0)
    if x.rational is None:
        if x.root is None:
            x.root = _root_of_square(x) or Number("root", (x,))
        return x.root
    if x.rational < 0:
        raise ValueError(f"a square root of {x.rational}")
    rest = x.rational.numerator * x.rational.denominator
    outside = Fraction(1, x.rational.denominator)
    whole = isqrt(rest)
    if whole * whole == rest:
        return number(outside * whole)
    for prime in PRIMES:
        while rest % (prime * prime) == 0:
            rest, outside = rest // (prime * prime), outside * prime
    key = Fraction(rest)
    if key not in _ROOTS:
        _ROOTS[key] = Number("root", (number(key),))
    return _ROOTS[key] * outside


def _root_of_square(x: Number) -> Number | None:
    """The root of a rational times a square, without a new root around the square."""
    if x.way != "*" or x.parts[1].rational is None:
        return None
    inner = x.parts[0]
    if inner.way != "*" or inner.parts[0] is not inner.parts[1]:
        return None
    own = inner.parts[0]
    return (own if own.sign() > 0 else -own) * root(x.parts[1])


def order(a: Number, b: Number) -> int:
    """The sign of a - b."""
    if a is b:
        return 0
    (p, q), (r, s) = a.bounds(FIRST_BITS), b.bounds(FIRST_BITS)
    if q < r or s < p:
        return -1 if q < r else 1
    return (a - b).sign()


def nearer(a: Number, b: Number, close: float) -> int:
    """The sign of a - b, by doubles where these differ by more than `close`."""
    apart = float(a) - float(b)
    if abs(apart) > close and abs(apart) < inf:
        return 1 if apart > 0 else -1
    return order(a, b)
