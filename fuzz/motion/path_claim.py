"""The claim of a target on the scales at which a part passes along a path."""

from __future__ import annotations

from dataclasses import dataclass

from minkref.motion.scale_ranges import ScaleRange


@dataclass(frozen=True)
class PathClaim:
    """The validity of each requested scale, or all valid scales within the window."""

    valid: tuple[bool, ...] = ()
    ranges: tuple[ScaleRange, ...] | None = None
