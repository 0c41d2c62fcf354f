"""What a target says of itself, and the promises that follow from it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from minkref.fuzz.cases.grid import bits_of

PLANE = frozenset(
    ("plane", "non-convex", "holes", "components", "touching", "empty", "point", "segment")
) | {"rational"}
CAPABILITIES = PLANE | {"space", "non-uniform", "rejects-invalid", "update", "events"}
MOST_TEXT = 200


class DeclarationError(ValueError):
    """A declaration that is none."""


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
    sum: str = "region"
    sets: str = "regularised"
    bits: int | None = None  # of the integer grid on which it computes
    unit: Fraction | None = None  # of the grid
    largest: Fraction | None = None  # absolute value of a coordinate
    capabilities: frozenset[str] = PLANE

    @property
    def exact(self) -> bool:
        return self.arithmetic == "exact"

    @property
    def boundary(self) -> bool:
        return self.sum == "boundary"

    def tolerance(self, magnitude: Fraction) -> Fraction:
        """The half side of the square or cube by which a result may differ. `magnitude` is the
        largest absolute value of a coordinate of sP plus that of Q."""
        return Fraction(0) if self.exact else self.absolute + self.relative * magnitude

    def rounds(self, numbers: Callable[[], list[Fraction]]) -> str | None:
        """Why the coordinates would be rounded on the way in; None if they would not."""
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
        """What a case needs and the target does not take."""
        return sorted(needs - self.capabilities)


def read_declaration(value: Mapping[str, Any], name: str) -> Declaration:
    """Raises DeclarationError for what is none."""
    capabilities = value.get("capabilities", sorted(PLANE))
    if not isinstance(capabilities, list) or not all(isinstance(c, str) for c in capabilities):
        raise DeclarationError("capabilities is not a list of words")
    unknown = sorted(set(capabilities) - CAPABILITIES)
    if unknown:
        known = ", ".join(sorted(CAPABILITIES))
        raise DeclarationError(f"there is no capability {unknown[0][:40]!r}; there are {known}")
    tolerance = value.get("tolerance", {})
    if not isinstance(tolerance, dict):
        raise DeclarationError("tolerance is not an object with absolute and relative")
    declared = Declaration(
        name=_text(value, "name", name),
        version=_text(value, "version", "") or None,
        language=_text(value, "language", ""),
        arithmetic=_text(value, "arithmetic", "exact"),
        numbers=_one_of(value, "numbers", ("text", "double")),
        absolute=_number(tolerance, "absolute"),
        relative=_number(tolerance, "relative"),
        sum=_one_of(value, "sum", ("region", "boundary")),
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
    if declared.exact and (declared.absolute or declared.relative):
        raise DeclarationError("exact arithmetic has no tolerance")
    return declared


def _grid(value: Mapping[str, Any]) -> dict[str, Any]:
    grid = value.get("grid", {})
    if not isinstance(grid, dict):
        raise DeclarationError("grid is not an object with bits, unit or largest")
    return grid


def _bits(value: Mapping[str, Any]) -> int | None:
    bits = _grid(value).get("bits")
    if bits is not None and (isinstance(bits, bool) or not isinstance(bits, int) or bits < 1):
        raise DeclarationError("grid: bits is no positive integer")
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
        number = Fraction(text if len(text.lower().partition("e")[2]) < 6 else "")
    except (ValueError, ZeroDivisionError) as error:
        what = f"{field} is not a decimal or fraction as a text"
        raise DeclarationError(what) from error
    if number < 0:
        raise DeclarationError(f"{field} is negative")
    return number
