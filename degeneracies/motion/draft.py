"""Drafts from a generator of paths and traps, and facts about them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache, cached_property
from typing import ClassVar

import minkref
from minkref import _core
from minkref.degeneracies.family import Family
from minkref.degeneracies.plane.draft import valid_sets
from minkref.fuzz.geometry.plane import Shape
from minkref.fuzz.plane.families.drawing import shape_text
from minkref.motion.path_values import FreeScales, PathBound, ScaleRange, ValidScales

Spot = tuple[Fraction, Fraction]
CONTACTS = ("allowed", "forbidden")


@dataclass(frozen=True)
class PathDraft:
    """A part, obstacles, a path for the part's origin, and the degenerate scale. A trap has a path
    with one place."""

    part: Shape
    obstacles: Shape
    path: tuple[Spot, ...]
    scale: Fraction


@dataclass(frozen=True)
class PathFacts:
    """A draft as the reference sees it. All exact, computed when asked for."""

    part: _core.PolygonSet
    obstacles: _core.PolygonSet
    path: tuple[Spot, ...]
    scale: Fraction

    @classmethod
    def of(cls, draft: PathDraft) -> PathFacts:
        """Raises _core.BadInput if a set is invalid."""
        part, obstacles = valid_sets(
            {"R": shape_text(draft.part), "O": shape_text(draft.obstacles)}
        )
        return cls(part, obstacles, draft.path, draft.scale)

    @cache  # noqa: B019  # as long as its facts
    def valid(self, contact: str) -> ValidScales:
        return minkref.valid_scales(self.part, self.obstacles, self.path, contact)

    @cache  # noqa: B019
    def trapped(self, contact: str) -> FreeScales:
        return minkref.trapped_scales(self.part, self.obstacles, self.path[0], contact)

    def collides_at(self, part: Sequence[Spot], contact: str) -> bool:
        """Whether another path has a place that collides at the scale."""
        s = self.scale
        return not minkref.valid_scales(self.part, self.obstacles, part, contact, s, s).ranges

    @cached_property
    def bound(self) -> PathBound | None:
        """The contact at the scale, if a range of valid scales with allowed contact ends there."""
        bounds = self.valid("allowed").bounds
        return next((one for one in bounds if one.scale == self.scale), None)

    @property
    def is_tight(self) -> bool:
        """Whether the scale is valid with contact allowed, but not with contact forbidden."""
        return self.scale in self.valid("allowed") and self.scale not in self.valid("forbidden")

    def answer(self, is_trap: bool, contact: str) -> tuple[ScaleRange, ...]:
        return (self.trapped if is_trap else self.valid)(contact).ranges


@dataclass(frozen=True)
class PathFamily(Family[PathDraft, PathFacts]):
    """A member's answer: the scales at which the part passes, or is trapped (`is_trap`). `until`:
    the answer is certified up to so many times the degenerate scale; None: everywhere."""

    is_trap: bool = False
    until: int | None = None
    has_sizes: ClassVar[bool] = False

    def look(self, draft: PathDraft) -> PathFacts:
        return PathFacts.of(draft)
