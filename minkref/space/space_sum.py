"""A sum in space, as commands pass it on."""

from __future__ import annotations

from dataclasses import dataclass

from minkref import _core

Face = tuple[list[int], list[int]]


@dataclass(frozen=True)
class SpaceSum:
    """A sum in canonical form; `facet_parents` names faces of P and Q by their vertices."""

    surface: _core.Polyhedron
    vertex_parents: list[tuple[int, int]]
    facet_parents: list[Face]
    seconds: float
