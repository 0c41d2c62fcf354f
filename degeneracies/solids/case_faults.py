"""Checks a case with polyhedra of any shape; the lint makes its text again from its source."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

from minkref import _core
from minkref.degeneracies.case_faults import of_place, of_scales
from minkref.degeneracies.solids.case_document import DegenerateSolids
from minkref.degeneracies.solids.mesh import Mesh
from minkref.degeneracies.space.case_document import content_in_space
from minkref.fuzz.geometry.polyhedron import Polyhedron


def case_faults(path: Path, value: dict[str, Any], seen: dict[str, Path]) -> Iterator[str]:
    """Yields a line for each fault."""
    try:
        P, Q = (Polyhedron.from_document(value[name]) for name in "PQ")
        for name, solid in (("P", P), ("Q", Q)):
            Mesh(solid).certify(name)
    except (ValueError, _core.BadInput) as error:
        yield f"{path}: {error}"
        return
    scales = DegenerateSolids.scales_in(value)
    yield from of_place(path, value, content_in_space(P, Q), scales, seen)
    yield from of_scales(path, value)
    if "certificate" in value:
        yield f"{path}: sums of polyhedra of any shape have no certificates"
