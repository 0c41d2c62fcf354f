"""Scales in the plane: a number for both axes, or a factor for each (docs/definitions.md)."""

from __future__ import annotations

from dataclasses import replace
from fractions import Fraction

from minkref.errors import Refusal
from minkref.plane.operand import Operand
from minkref.scaling import PlaneScale as PlaneScale
from minkref.scaling import joined
from minkref.scaling import read_plane_scale as read_plane_scale


def text_of(scale: PlaneScale) -> str:
    """Write `S` or `SX,SY`, as the extension module and people read it."""
    return joined([str(factor) for factor in factors_of(scale)])


def document_of(scale: PlaneScale) -> str | list[str]:
    """Write the scale for a document: a number, or a list of two."""
    return [str(factor) for factor in scale] if isinstance(scale, tuple) else str(scale)


def shown_scale(document: str | list[str]) -> str:
    """Write a document's scale for people."""
    return document if isinstance(document, str) else joined(document)


def factors_of(scale: PlaneScale) -> tuple[Fraction, Fraction]:
    return scale if isinstance(scale, tuple) else (scale, scale)


def static_pair(P: Operand, scale: PlaneScale) -> tuple[Operand, Fraction]:
    """The operand and the uniform scale whose sum with Q is the same: `S P` at 1 for a factor for
    each axis."""
    if not isinstance(scale, tuple):
        return P, scale
    return replace(P, set=P.set.scaled(text_of(scale))), Fraction(1)


def refuse_axes(scale: PlaneScale, what: str, where: str, mend: str) -> None:
    """Refuses a scale that is not uniform."""
    if isinstance(scale, tuple):
        raise Refusal(what, f"{where} --scale {text_of(scale)[:40]}", mend, "scale-not-uniform")
