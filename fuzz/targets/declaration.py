"""A target's declaration, and the promises that follow."""

from __future__ import annotations

import difflib
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from minkref.fuzz.cases.grid import bits_of
from minkref.fuzz.cases.verbs import FEATURES, OFFSET, PATH, RANGES, SHARP_OFFSET, UNION
from minkref.fuzz.geometry.number_text import number_of

# For each capability, the trait of cases needing it.
CAPABILITIES = {
    "plane": "operands in the plane",
    "space": "operands in space",
    "non-convex": "an operand that is not convex",
    "holes": "an operand with holes; in space, with tunnels or cavities",
    "components": "an operand of several polygons or shells",
    "touching": "rings of an operand that touch; in space, a surface that touches itself",
    "empty": "the empty set as an operand",
    "point": "a point as an operand",
    "segment": "a segment as an operand",
    "rational": "numbers that no double holds",
    "non-uniform": "a scale with a factor for each axis",
    "rejects-invalid": "invalid operands in the plane, to be rejected",
    "update": "an update from another scale",
    "events": "the scales of topology events in the plane",
    "pair-events": "the scales at which two edges of the reduced convolution begin or cease to "
    "meet, in the plane",
    "path": "whether a part passes along a path, in the plane, at given scales",
    "path-ranges": "all scales at which a part passes along a path, in the plane",
    "union": "sets to unite, in the plane",
    "offset": "a set to grow by a disc, in the plane",
    "inset": "a set to erode by a disc, by `offset` with a radius below 0",
    "line-offset": "open lines to grow by a disc, in the plane",
    "join-mitre": "an offset with mitred corners",
    "join-bevel": "an offset with bevelled corners",
    "join-square": "an offset with squared corners",
    "join-sharp": "an offset with sharp corners, whether or not it has others",
    "inset-sharp": "the same with a radius below 0",
    "cap-flat": "an offset of lines that end flat",
    "cap-square": "an offset of lines with squared ends",
    "features": "concave features of a set under a growing disc, in the plane",
}
PLANE = frozenset(
    ("plane", "non-convex", "holes", "components", "touching", "empty", "point", "segment")
) | {"rational"}
MOST_TEXT = 200
OF_THE_ANSWER = frozenset(("seq", "status", "protocol"))
MEMBERS = frozenset(
    ("name", "version", "language", "arithmetic", "numbers", "grid", "tolerance", "sum", "sets")
) | {"capabilities"}
OF_TOLERANCE = frozenset(("absolute", "relative", "radius"))
OF_GRID = frozenset(("bits", "unit", "largest"))
NO_SUMS = "none"  # `sum` of a target that is asked for no sums
OTHER_VERBS = frozenset((UNION, OFFSET, SHARP_OFFSET, FEATURES, PATH, RANGES))
FREE = "x-"  # members whose names begin so mean nothing to us


class DeclarationError(ValueError):
    """An invalid declaration."""


@dataclass(frozen=True)
class Declaration:
    """The answer to `hello` (docs/adapter-protocol.md). `regions` and `exact` are the default."""

    name: str
    version: str | None = None
    language: str = ""
    arithmetic: str = "exact"
    numbers: str = "text"
    absolute: Fraction = Fraction(0)
    relative: Fraction = Fraction(0)
    of_radius: Fraction = Fraction(0)  # for offsets: a part of the radius
    sum: str = "region"
    sets: str = "regularised"
    bits: int | None = None  # the target's integer grid
    unit: Fraction | None = None  # the grid's unit
    largest: Fraction | None = None  # absolute value of a coordinate
    capabilities: frozenset[str] = PLANE

    @property
    def exact(self) -> bool:
        return self.arithmetic == "exact"

    @property
    def boundary(self) -> bool:
        return self.sum == "boundary"

    @property
    def makes_sums(self) -> bool:
        return self.sum != NO_SUMS

    def tolerance(self, magnitude: Fraction) -> Fraction:
        """The half side of the square or cube by which a result may differ. `magnitude` adds the
        largest absolute coordinates of sP and of Q; for a union, it is the largest of all sets."""
        return Fraction(0) if self.exact else self.absolute + self.relative * magnitude

    def tolerance_document(self) -> dict[str, str]:
        value = {"absolute": str(self.absolute), "relative": str(self.relative)}
        return {**value, "radius": str(self.of_radius)} if self.of_radius else value

    def offset_tolerance(self, magnitude: Fraction, radius: Fraction) -> Fraction:
        """By how much the radius of an offset may differ, in places. `magnitude`: the largest
        absolute coordinate of the set."""
        return self.tolerance(magnitude + radius) + self.of_radius * radius

    def rounds(self, numbers: Callable[[], list[Fraction]]) -> str | None:
        """Returns the reason for rounding coordinates on the way in; None without rounding."""
        if self.bits is not None:
            bits = bits_of(numbers())
            if bits is None or bits > self.bits:
                return f"coordinates off its grid of {self.bits} bits"
        if self.unit is not None and any((n / self.unit).denominator != 1 for n in numbers()):
            return f"coordinates off its grid of {self.unit}"
        if self.largest is not None and any(abs(n) > self.largest for n in numbers()):
            return f"coordinates beyond {self.largest}"
        return None

    def lacks(self, needs: frozenset[str]) -> list[str]:
        """Returns the case's needs that the target lacks."""
        sums = set() if self.makes_sums or needs & OTHER_VERBS else {"sums"}
        return sorted((needs - self.capabilities) | sums)


def read_declaration(value: Mapping[str, Any], name: str) -> Declaration:
    """Reads a declaration. Raises DeclarationError for anything else, also for an unknown
    member."""
    _refuse_unknown("member", set(value) - OF_THE_ANSWER, MEMBERS)
    capabilities = value.get("capabilities", sorted(PLANE))
    if not isinstance(capabilities, list) or not all(isinstance(c, str) for c in capabilities):
        raise DeclarationError("capabilities is not a list of words")
    _refuse_unknown("capability", set(capabilities), frozenset(CAPABILITIES))
    tolerance = value.get("tolerance", {})
    if not isinstance(tolerance, dict):
        raise DeclarationError("tolerance is not an object with absolute, relative or radius")
    _refuse_unknown("member of tolerance", set(tolerance), OF_TOLERANCE)
    _refuse_unknown("member of grid", set(_grid(value)), OF_GRID)
    declared = Declaration(
        name=_text(value, "name", name),
        version=_text(value, "version", "") or None,
        language=_text(value, "language", ""),
        arithmetic=_text(value, "arithmetic", "exact"),
        numbers=_one_of(value, "numbers", ("text", "double")),
        absolute=_number(tolerance, "absolute"),
        relative=_number(tolerance, "relative"),
        of_radius=_number(tolerance, "radius"),
        sum=_one_of(value, "sum", ("region", "boundary", NO_SUMS)),
        sets=_one_of(value, "sets", ("regularised", "closed")),
        bits=_bits(value),
        unit=_of_grid(value, "unit"),
        largest=_of_grid(value, "largest"),
        capabilities=frozenset(capabilities),
    )
    if not declared.capabilities & {"plane", "space"}:
        raise DeclarationError("capabilities has neither plane nor space")
    if declared.boundary and "space" in declared.capabilities:
        raise DeclarationError("sum: boundary is for the plane, and capabilities has space")
    if not declared.makes_sums and not declared.capabilities & OTHER_VERBS:
        raise DeclarationError(
            "sum: none leaves nothing to ask for without union, offset, features or path"
        )
    if declared.exact and (declared.absolute or declared.relative or declared.of_radius):
        raise DeclarationError("exact arithmetic has no tolerance")
    return declared


def _refuse_unknown(what: str, given: set[str], known: frozenset[str]) -> None:
    """Refuses unknown words, naming the nearest known word."""
    unknown = sorted(word for word in given - known if not word.startswith(FREE))
    if unknown:
        near = difflib.get_close_matches(unknown[0], sorted(known), n=1, cutoff=0.0)
        listed = ", ".join(sorted(known))
        raise DeclarationError(
            f"there is no {what} {unknown[0][:40]!r}; did you mean {near[0]}? There are {listed}"
        )


def _grid(value: Mapping[str, Any]) -> dict[str, Any]:
    grid = value.get("grid", {})
    if not isinstance(grid, dict):
        raise DeclarationError("grid is not an object with bits, unit or largest")
    return grid


def _bits(value: Mapping[str, Any]) -> int | None:
    bits = _grid(value).get("bits")
    if bits is not None and (isinstance(bits, bool) or not isinstance(bits, int) or bits < 1):
        raise DeclarationError("grid: bits is not a positive integer")
    return bits


def _of_grid(value: Mapping[str, Any], field: str) -> Fraction | None:
    grid = _grid(value)
    if grid.get(field) is None:
        return None
    number = _number(grid, field)
    if not number:
        raise DeclarationError(f"grid: {field} is zero")
    return number


def _text(value: Mapping[str, Any], field: str, default: str) -> str:
    text = value.get(field, default)
    if not isinstance(text, str) or len(text) > MOST_TEXT:
        raise DeclarationError(f"{field} is not a text of at most {MOST_TEXT} characters")
    return text


def _one_of(value: Mapping[str, Any], field: str, words: tuple[str, ...]) -> str:
    word = value.get(field, words[0])
    if word not in words:
        raise DeclarationError(f"{field} is not one of {', '.join(words)}")
    return str(word)


def _number(tolerance: Mapping[str, Any], field: str) -> Fraction:
    text = tolerance.get(field, "0")
    if not isinstance(text, str) or len(text) > MOST_TEXT:
        raise DeclarationError(f"{field} is not a decimal or fraction as a text")
    try:
        number = number_of(text)
    except ValueError as error:
        raise DeclarationError(f"{field}: {error}") from error
    if number < 0:
        raise DeclarationError(f"{field} is negative")
    return number
