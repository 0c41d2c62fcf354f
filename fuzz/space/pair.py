"""A pair of operands in space, and what is known of its sum."""

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
    CELLS = "cells"  # both are polycubes: the cells of the sum
    HULL = "hull"  # both are convex: the hull of all sums of two vertices
    PRISM = "prism"  # both are prisms over the same plane: the sum in the plane
    SUM = "sum"  # any shape: the exact sum by the reference, where no limit is in its way
    POINTS = "points"  # of each single point, whether it lies in the sum


@dataclass(frozen=True)
class SpacePair:
    """sP + Q. The cells or prisms are there where the truth needs them; `route` gives the exact
    sum."""

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
        """Or why there is none."""
        return exact_sum(self.P, self.Q, self.scale, self.route)

    @property
    def exact(self) -> ExactSum:
        """Where `judged_by` says that it is there."""
        assert not isinstance(self.exact_sum, str), self.exact_sum
        return self.exact_sum

    @cached_property
    def judged_by(self) -> Truth:
        """`truth`, or single points where there is no exact sum."""
        return Truth.POINTS if self.absence else self.truth

    @property
    def absence(self) -> str | None:
        """Why there is no exact sum where there should be one."""
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
