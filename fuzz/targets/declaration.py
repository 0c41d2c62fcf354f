"""What a target says of itself, and the promises that follow from it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

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
        capabilities=frozenset(capabilities),
    )
    if not declared.capabilities & {"plane", "space"}:
        raise DeclarationError("capabilities has neither plane nor space")
    if declared.exact and (declared.absolute or declared.relative):
        raise DeclarationError("exact arithmetic has no tolerance")
    return declared


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
        raise DeclarationError(f"tolerance: {field} is not a decimal or fraction as a text")
    try:
        number = Fraction(text)
    except (ValueError, ZeroDivisionError) as error:
        what = f"tolerance: {field} is not a decimal or fraction as a text"
        raise DeclarationError(what) from error
    if number < 0:
        raise DeclarationError(f"tolerance: {field} is negative")
    return number
