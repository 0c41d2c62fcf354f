"""Scalings with a factor for each axis: texts and lists, exact."""

from __future__ import annotations

from pathlib import Path

from minkref.errors import Refusal
from minkref.exact import read_scale, scientific
from minkref.plane.scales import lines_of_scales

Scaling = tuple[str, str, str]
UNIT: Scaling = ("1", "1", "1")


def read_scaling(text: str, option: str = "--scale") -> Scaling:
    """Read `S`, the same for all axes, or `SX,SY,SZ`, in lowest terms. Refuses factors that are not
    positive."""
    parts = text.split(",")
    if len(parts) == 1:
        factor = read_scale(text, option)
        return (factor, factor, factor)
    if len(parts) != 3:
        where = f"{option} {text[:40]}{'...' if len(text) > 40 else ''}"
        raise Refusal(
            f"these are {len(parts)} factors",
            where,
            "give one positive number, or three: SX,SY,SZ",
            "scale-not-three",
        )
    x, y, z = (
        read_scale(part, f"{option} {axis}") for part, axis in zip(parts, "xyz", strict=True)
    )
    return (x, y, z)


def read_scalings(path: Path) -> list[Scaling]:
    """Read the scalings in a file, one per line. Refusals name file and line."""
    return lines_of_scales(path, read_scaling)


def text_of(scaling: Scaling) -> str:
    """Write `S` or `SX,SY,SZ` for people, with long numbers rounded."""
    x, y, z = (factor if len(factor) <= 20 else scientific(factor) for factor in scaling)
    return x if len(set(scaling)) == 1 else f"{x},{y},{z}"
