"""A disc about the origin as an operand: `disc:R`, `disc:sqrt:N`."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from math import isqrt

from minkref.errors import Refusal
from minkref.exact import LONGEST_SCALE, read_number

PREFIX = "disc:"
ANY = "disc"
ROOT = "sqrt:"
MEND = "give a positive number, as disc:7/5, disc:0.25 or disc:sqrt:2"


@dataclass(frozen=True)
class Disc:
    """The points within a radius around the origin; the radius's square is rational."""

    name: str
    squared_radius: Fraction

    @property
    def radius(self) -> str:
        """The radius as `n`, `n/d`, or `sqrt:` and the square."""
        top, bottom = self.squared_radius.as_integer_ratio()
        if isqrt(top) ** 2 == top and isqrt(bottom) ** 2 == bottom:
            return str(Fraction(isqrt(top), isqrt(bottom)))
        return ROOT + str(self.squared_radius)

    def scaled(self, factor: Fraction) -> Disc:
        return Disc(self.name, self.squared_radius * factor**2)

    def bounds(self, bits: int) -> tuple[Fraction, Fraction]:
        """Return two numbers around the radius, or equal to it, that differ by about 2^-bits of the
        radius; uses only integer square roots."""
        top, bottom = self.squared_radius.as_integer_ratio()
        root = Fraction(isqrt(top), isqrt(bottom))
        if root**2 == self.squared_radius:
            return root, root
        size = (top.bit_length() - bottom.bit_length()) // 2
        shift = max(bits - size, 0)
        low = isqrt((top << 2 * shift) // bottom)
        return Fraction(low, 1 << shift), Fraction(low + 1, 1 << shift)


def is_disc(name: str) -> bool:
    """Tell whether a name means a disc; `disc` alone means any radius, where radii are wanted."""
    return name.startswith(PREFIX) or name == ANY


def read_disc(name: str) -> Disc:
    """Read a disc. Refuses anything but a positive finite number after the prefix."""
    if name == ANY:
        raise Refusal("the disc has no radius", name, MEND, "bad-radius")
    return Disc(name, read_squared_radius(name, PREFIX, MEND))


def read_squared_radius(name: str, prefix: str, mend: str) -> Fraction:
    """Read the square of the radius in `PREFIX R` or `PREFIX sqrt:N`. Refuses anything but a
    positive finite number."""
    text = name.removeprefix(prefix)
    where = name[:40] + ("..." if len(name) > 40 else "")
    if len(text) > LONGEST_SCALE:
        raise Refusal(f"the radius has more than {LONGEST_SCALE} characters", where, mend, "limit")
    is_root = text.startswith(ROOT)
    value = read_number(text.removeprefix(ROOT).strip(), "radius", where, mend)
    if value <= 0:
        what = "zero" if value == 0 else "negative"
        raise Refusal(f"the radius is {what}", where, mend, "bad-radius")
    return value if is_root else value**2


def read_tolerance(text: str, option: str) -> Fraction:
    """How far a polygon may be off. Refuses what is not above 0."""
    return _above_zero(text, option, "tolerance", "0.001")


def read_clearance(text: str, option: str) -> Fraction:
    """Read a distance to keep. Refuses what is not above 0."""
    return _above_zero(text, option, "clearance", "1/2", "bad-clearance")


def read_positive_alpha(text: str, option: str) -> Fraction:
    """Read a disc's diameter. Refuses anything but a number above 0."""
    return _above_zero(text, option, "diameter", "7/5", "bad-alpha")


def _above_zero(text: str, option: str, noun: str, example: str, code: str = "usage") -> Fraction:
    where = f"{option} {text[:40]}"
    mend = f"give a positive number, as {example}"
    value = read_number(text.strip(), noun, where, mend)
    if value <= 0:
        raise Refusal(f"the {noun} is not above 0", where, mend, code)
    return value


def read_alpha(text: str, option: str) -> Fraction:
    """Read a disc's diameter. Refuses anything but a number of 0 or more."""
    where = f"{option} {text[:40]}"
    mend = "give 0 or a positive number, as 7/5"
    value = read_number(text.strip(), "diameter", where, mend)
    if value < 0:
        raise Refusal("the diameter is negative", where, mend, "bad-alpha")
    return value


def read_persistence(text: str, option: str) -> str:
    """Read a length of bars in lowest terms, or `inf`. Refuses negative numbers."""
    if text.strip() == "inf":
        return "inf"
    where = f"{option} {text[:40]}"
    mend = "give 0 or a positive number, as 7/5, or inf"
    value = read_number(text.strip(), "persistence", where, mend)
    if value < 0:
        raise Refusal("the persistence is negative", where, mend, "bad-persistence")
    return str(value)


def check_radii(first: Fraction | None, last: Fraction | None) -> None:
    """Refuses a window without a radius in it."""
    if first is not None and last is not None and first > last:
        where = f"--from {first} --to {last}"
        raise Refusal("no radius is in the window", where, "exchange the bounds")


def squares_of(*radii: Fraction | None) -> list[str | None]:
    """The squares of the radii, as the extension module takes them; None where there is none."""
    return [None if radius is None else str(radius**2) for radius in radii]
