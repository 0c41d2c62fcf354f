"""Scalings with a factor for each axis: texts and lists, exact."""

from __future__ import annotations

from pathlib import Path

from minkref.exact import scientific
from minkref.plane.scales import lines_of_scales
from minkref.scaling import Scaling as Scaling
from minkref.scaling import joined
from minkref.scaling import read_scaling as read_scaling

UNIT: Scaling = ("1", "1", "1")


def read_scalings(path: Path) -> list[Scaling]:
    """Read the scalings in a file, one per line. Refusals name file and line."""
    return lines_of_scales(path, read_scaling)


def text_of(scaling: Scaling) -> str:
    """Write `S` or `SX,SY,SZ` for people, with long numbers rounded."""
    return joined([factor if len(factor) <= 20 else scientific(factor) for factor in scaling])
