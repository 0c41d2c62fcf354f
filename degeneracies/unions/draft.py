"""Drafts from a generator of unions, and facts about them."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from functools import cached_property
from typing import ClassVar

from minkref import _core
from minkref.certify.plane.union_degeneracies import Edge, Edges, Meeting, Spot
from minkref.degeneracies.family import Family
from minkref.degeneracies.plane.draft import valid_sets
from minkref.fuzz.geometry.plane import Shape
from minkref.fuzz.plane.families.drawing import shape_text


@dataclass(frozen=True)
class UnionFacts:
    """Sets as the reference sees them. All exact, computed when asked for."""

    sets: tuple[_core.PolygonSet, ...]

    @classmethod
    def of(cls, shapes: Sequence[Shape]) -> UnionFacts:
        """Raises _core.BadInput if a set is invalid."""
        texts = {f"set {k}": shape_text(shape) for k, shape in enumerate(shapes)}
        return cls(tuple(valid_sets(texts)))

    @cached_property
    def union(self) -> tuple[_core.PolygonSet, int, int]:
        """The union, its components and its holes."""
        region, components, holes = _core.combined("union", list(self.sets))
        return region, components, holes

    @cached_property
    def edges(self) -> Edges:
        return Edges(self.sets)

    @cached_property
    def meetings(self) -> dict[Spot, Meeting]:
        return self.edges.meetings()

    @cached_property
    def overlaps(self) -> list[tuple[Edge, Edge, int]]:
        return list(self.edges.overlaps())

    @cached_property
    def holes_of_sets(self) -> int:
        return sum(len(rings) - 1 for one in self.sets for rings in one.rings())


@dataclass(frozen=True)
class UnionFamily(Family[list[Shape], UnionFacts]):
    """A family of sets to unite."""

    has_sizes: ClassVar[bool] = False

    def look(self, draft: list[Shape]) -> UnionFacts:
        return UnionFacts.of(draft)
