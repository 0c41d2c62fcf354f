"""A pair of operands in space, with known facts about its sum."""

from __future__ import annotations

from dataclasses import dataclass
from enum import StrEnum
from functools import cached_property

from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import Scale
from minkref.fuzz.space.cells import Cell, CellSum, sum_of_cells
from minkref.fuzz.space.convex_sum import true_sum
from minkref.fuzz.space.exact_sum import EDGES, ExactSum, exact_sum
from minkref.fuzz.space.meeting import Meeting
from minkref.fuzz.space.prism import Prism, sum_of_prisms
from minkref.fuzz.space.thin_meeting import ThinMeeting


class Truth(StrEnum):
    CELLS = "cells"  # both are polycubes: the sum's cells
    HULL = "hull"  # both are convex: the hull of all vertex sums
    PRISM = "prism"  # both are prisms over the same plane: the sum in the plane
    SUM = "sum"  # any shape: the reference's exact sum, unless a limit prevents it
    POINTS = "points"  # single points, each inside or outside the sum


@dataclass(frozen=True)
class SpacePair:
    """sP + Q. Cells or prisms are present if the truth needs them; `route` gives the exact sum."""

    P: Polyhedron
    Q: Polyhedron
    scale: Scale
    family: str
    truth: Truth = Truth.SUM
    P_cells: frozenset[Cell] = frozenset()
    Q_cells: frozenset[Cell] = frozenset()
    P_prism: Prism | None = None
    Q_prism: Prism | None = None
    route: str = EDGES

    @cached_property
    def meeting(self) -> Meeting:
        kind = ThinMeeting if self.P.is_thin or self.Q.is_thin else Meeting
        return kind(self.P, self.Q, self.scale)

    @cached_property
    def cell_sum(self) -> CellSum:
        return sum_of_cells(self.P_cells, self.Q_cells, self.scale)

    @cached_property
    def hull(self) -> Polyhedron:
        return true_sum(self.P, self.Q, self.scale)

    @cached_property
    def prism_sum(self) -> Prism:
        assert self.P_prism is not None and self.Q_prism is not None
        return sum_of_prisms(self.P_prism, self.Q_prism, self.scale)

    @cached_property
    def exact_sum(self) -> ExactSum | str:
        """Returns the exact sum, or the reason for its absence."""
        return exact_sum(self.P, self.Q, self.scale, self.route)

    @property
    def exact(self) -> ExactSum:
        """Returns the exact sum, if `judged_by` says that it exists."""
        assert not isinstance(self.exact_sum, str), self.exact_sum
        return self.exact_sum

    @cached_property
    def judged_by(self) -> Truth:
        """Returns `truth`, or single points without an exact sum."""
        return Truth.POINTS if self.absence else self.truth

    @property
    def absence(self) -> str | None:
        """Returns the reason if an expected exact sum is missing."""
        found = self.exact_sum if self.truth is Truth.SUM else None
        return found if isinstance(found, str) else None

    def sum(self) -> Polyhedron | None:
        """The exact sum, if more is known than single points. The surface may touch itself. The
        rings of the region of a prism must not touch (ValueError)."""
        if self.truth is Truth.CELLS:
            return self.cell_sum.polyhedron()
        if self.truth is Truth.HULL:
            return self.hull
        if self.truth is Truth.PRISM:
            return self.prism_sum.polyhedron()
        return self.exact.polyhedron if self.judged_by is Truth.SUM else None
