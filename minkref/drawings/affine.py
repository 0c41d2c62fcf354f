"""Affine maps of the plane with exact numbers, and the transforms of SVG."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass
from fractions import Fraction

from minkref.drawings.curves import Point, above_root, tangent, turned

ZERO, ONE = Fraction(0), Fraction(1)
_CALL = re.compile(r"\s*,?\s*([a-zA-Z]+)\s*\(([^)]*)\)")
COUNTS = {
    "matrix": (6,), "translate": (1, 2), "scale": (1, 2), "rotate": (1, 3), "skewX": (1,),
    "skewY": (1,),
}  # fmt: skip


@dataclass(frozen=True)
class Affine:
    """(x, y) to (a x + c y + e, b x + d y + f), as in SVG."""

    a: Fraction = ONE
    b: Fraction = ZERO
    c: Fraction = ZERO
    d: Fraction = ONE
    e: Fraction = ZERO
    f: Fraction = ZERO

    def __call__(self, point: Point) -> Point:
        x, y = point
        return self.a * x + self.c * y + self.e, self.b * x + self.d * y + self.f

    def __matmul__(self, first: Affine) -> Affine:
        """Return this map after `first`."""
        e, f = self((first.e, first.f))
        return Affine(
            self.a * first.a + self.c * first.b, self.b * first.a + self.d * first.b,
            self.a * first.c + self.c * first.d, self.b * first.c + self.d * first.d, e, f,
        )  # fmt: skip

    @property
    def stretch(self) -> Fraction:
        """An upper bound for growth of lengths."""
        return above_root(self.a**2 + self.b**2 + self.c**2 + self.d**2)


def rotation(degrees: Fraction) -> Affine:
    c, s = turned(degrees)
    return Affine(c, s, -s, c)


def transform(text: str, number: Callable[[str], Fraction], warn: Callable[[str], None]) -> Affine:
    """Read a list of transforms. Raises ValueError for other text. Rounds skews, and
    rotations by other angles than multiples of 90 degrees, to 40 bits, and warns."""
    found = Affine()
    at = 0
    while at < len(text.rstrip()):
        call = _CALL.match(text, at)
        if call is None or call[1] not in COUNTS:
            raise ValueError(f"this is no transform: {text[at : at + 40]}")
        numbers = [number(word) for word in re.split(r"[\s,]+", call[2].strip()) if word]
        if len(numbers) not in COUNTS[call[1]]:
            raise ValueError(f"{call[1]} does not take {len(numbers)} numbers")
        found = found @ _called(call[1], numbers, warn)
        at = call.end()
    return found


def _called(name: str, numbers: list[Fraction], warn: Callable[[str], None]) -> Affine:
    if name == "matrix":
        return Affine(*numbers)
    if name == "translate":
        return Affine(e=numbers[0], f=numbers[1] if len(numbers) > 1 else ZERO)
    if name == "scale":
        return Affine(a=numbers[0], d=numbers[-1])
    angle = numbers[0]
    if angle % 90:
        warn("angles of rotations and skews are rounded to 40 bits")
    if name == "rotate":
        x, y = numbers[1:] or (ZERO, ZERO)
        return Affine(e=x, f=y) @ rotation(angle) @ Affine(e=-x, f=-y)
    if abs(angle) > 45:
        raise ValueError(f"a skew by {angle} degrees is not read")
    slope = tangent(angle)
    return Affine(c=slope) if name == "skewX" else Affine(b=slope)
