"""Places where offset curves of one radius meet: decimals of many digits, and the exact place as a
certificate writes it (docs/certificates-disc.md)."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from decimal import Decimal
from fractions import Fraction

Exact = tuple[Fraction, Fraction]
Near = tuple[Decimal, Decimal]
Numbers = tuple[Fraction, Fraction, Fraction, Fraction]

NONE = Fraction(0)
ONE = Fraction(1)


def decimal(x: Fraction) -> Decimal:
    return Decimal(x.numerator) / Decimal(x.denominator)


def near(p: Exact) -> Near:
    return decimal(p[0]), decimal(p[1])


@dataclass(frozen=True)
class JointPlace:
    """(x[0] + x[1] a + x[2] b, ...) with a = √root and b = √(more[0] + more[1] a)."""

    root: Fraction
    more: tuple[Fraction, Fraction]
    x: Numbers
    y: Numbers

    def near(self) -> Near:
        a = decimal(self.root).sqrt()
        b = max(Decimal(0), decimal(self.more[0]) + decimal(self.more[1]) * a).sqrt()
        x, y = (
            decimal(p) + decimal(q) * a + decimal(r) * b + decimal(s) * a * b
            for p, q, r, s in (self.x, self.y)
        )
        return x, y

    def entry(self) -> list[object]:
        numbers = [[str(c) for c in each] for each in (self.more, self.x, self.y)]
        return [str(self.root), *numbers]


def rational(p: Exact) -> JointPlace:
    return JointPlace(ONE, (ONE, NONE), (p[0], NONE, NONE, NONE), (p[1], NONE, NONE, NONE))


def circles_meet(v: Exact, w: Exact, square: Fraction) -> Iterator[JointPlace]:
    """The places as far from two points as the radius."""
    dx, dy = w[0] - v[0], w[1] - v[1]
    long = dx * dx + dy * dy
    middle = (v[0] + w[0]) / 2, (v[1] + w[1]) / 2
    if long == 0 or 4 * square < long:
        return
    if 4 * square == long:
        yield rational(middle)
        return
    for side in (1, -1):
        x, y = (middle[0], -side * dy, NONE, NONE), (middle[1], side * dx, NONE, NONE)
        yield JointPlace(square / long - Fraction(1, 4), (ONE, NONE), x, y)


def line_meets_circle(
    a: Exact, u: Exact, w: Exact, square: Fraction, sides: tuple[int, ...] = (1,)
) -> Iterator[JointPlace]:
    """The places on the line through `a` along `u`, moved to its right (1) or left (-1), as
    far from `w` as the radius."""
    long = u[0] * u[0] + u[1] * u[1]
    height = (w[0] - a[0]) * u[1] - (w[1] - a[1]) * u[0]
    r = u[1] / long, -u[0] / long
    root = square * long
    foot = w[0] - height * r[0], w[1] - height * r[1]
    for side in sides:
        if height == 0:
            yield JointPlace(root, (ONE, NONE), (foot[0], side * r[0], NONE, NONE),
                             (foot[1], side * r[1], NONE, NONE))  # fmt: skip
            continue
        if side * height < 0 or height * height > 4 * root:
            continue
        if height * height == 4 * root:
            yield rational((w[0] - height / 2 * r[0], w[1] - height / 2 * r[1]))
            continue
        more = -height * height, 2 * side * height
        for way in (1, -1):
            yield JointPlace(root, more, (foot[0], side * r[0], way * u[0] / long, NONE),
                             (foot[1], side * r[1], way * u[1] / long, NONE))  # fmt: skip


def lines_meet(a: Exact, u: Exact, b: Exact, w: Exact, square: Fraction) -> Iterator[JointPlace]:
    """The places on the first line moved to its right, and on the second, moved to either side."""
    turn = u[0] * w[1] - u[1] * w[0]
    if turn == 0:
        return
    roots = square * (u[0] ** 2 + u[1] ** 2), square * (w[0] ** 2 + w[1] ** 2)
    p, q = a[0] * u[1] - a[1] * u[0], b[0] * w[1] - b[1] * w[0]
    for side in (1, -1):
        x = ((u[0] * q - w[0] * p) / turn, -w[0] / turn, side * u[0] / turn, NONE)
        y = ((u[1] * q - w[1] * p) / turn, -w[1] / turn, side * u[1] / turn, NONE)
        yield JointPlace(roots[0], (roots[1], NONE), x, y)
