"""Drafts that a generator of paths and traps draws, and the facts about them."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cache, cached_property
from random import Random

import minkref
from minkref import _core
from minkref.degeneracies.plane.draft import Subject
from minkref.fuzz.geometry.plane import Shape
from minkref.fuzz.plane.families.drawing import shape_text
from minkref.motion.path_values import FreeScales, PathBound, ScaleRange, ValidScales

Spot = tuple[Fraction, Fraction]
CONTACTS = ("allowed", "forbidden")


@dataclass(frozen=True)
class PathDraft:
    """A part, obstacles, a path of the part's origin, and the scale at which they are degenerate. A
    trap is about a path of one place."""

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
        """Raises _core.BadInput where a set is none."""
        sets = []
        for name, shape in (("R", draft.part), ("O", draft.obstacles)):
            made = _core.PolygonSet.from_json(shape_text(shape))
            made.validate(name)
            sets.append(made)
        return cls(sets[0], sets[1], draft.path, draft.scale)

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
        """The contact at the scale, if a range of scales of parts that may touch ends there."""
        bounds = self.valid("allowed").bounds
        return next((one for one in bounds if one.scale == self.scale), None)

    @property
    def is_tight(self) -> bool:
        """The scale is valid for a part that may touch, and not for one that may not."""
        return self.scale in self.valid("allowed") and self.scale not in self.valid("forbidden")

    def answer(self, is_trap: bool, contact: str) -> tuple[ScaleRange, ...]:
        return (self.trapped if is_trap else self.valid)(contact).ranges


@dataclass(frozen=True)
class PathFamily(Subject):
    """`draw` draws a candidate; it belongs to the family if `belongs` says so of its facts. The
    answer for a member: the scales at which the part passes, or is trapped (`is_trap`). `until`: up
    to how many times the degenerate scale the answer is certified; None: at all scales."""

    draw: Callable[[Random], PathDraft]
    belongs: Callable[[PathFacts], bool]
    is_trap: bool = False
    until: int | None = None
