"""The mesh of a sum as a program sees it that reads its decimals as doubles."""

from __future__ import annotations

import math
from collections import Counter
from itertools import chain, pairwise
from typing import Any

from minkref import _core
from minkref.exact import scientific


def rounding_of(mesh: _core.Polyhedron, is_text_exact: bool = False) -> dict[str, Any] | None:
    """The core's report on the mesh with each coordinate the nearest double; whether this mesh is
    closed; and the first rule of a polyhedron that the mesh breaks, its faces cut into triangles.
    Exact. None where the text is exact and all its numbers are doubles, and where the doubles
    cannot be looked at: a coordinate is beyond their range, or writing all doubles over one
    denominator takes too many bits. O(n log n) where few triangles are close to each other."""
    try:
        rounded, report = _core.rounded_mesh(mesh)
        if is_text_exact and not report["moved_vertices"]:
            return None
        return {**report, "closed": is_closed(rounded.rings()), "fault": _fault(rounded, mesh)}
    except _core.LimitExceeded as error:
        if error.code == "memory-limit":
            raise
        return None


def beyond_doubles(mesh: _core.Polyhedron) -> list[str]:
    """A warning where a program that reads doubles has an infinite coordinate."""
    if all(map(math.isfinite, chain.from_iterable(mesh.approximate_points()))):
        return []
    return ["a coordinate is beyond the range of doubles: most programs read it as infinite"]


def is_closed(rings: list[list[int]]) -> bool:
    """Faces run along each edge as often one way as the other. So they do where vertices of the
    same place are taken for one."""
    runs: Counter[tuple[int, int]] = Counter()
    for ring in rings:
        for a, b in pairwise((*ring, ring[0])):
            runs[min(a, b), max(a, b)] += 1 if a < b else -1
    return not any(runs.values())


def _fault(rounded: _core.Polyhedron, exact: _core.Polyhedron) -> str | None:
    """The code of the refusal. Faces are cut as they are before they bend."""
    if any(len(ring) > 3 for ring in rounded.rings()):
        triangles = [triangle for face in exact.triangles() for triangle in face]
        rounded = _core.Polyhedron(rounded.points(), triangles)
    try:
        rounded.validate()
    except _core.LimitExceeded:
        raise
    except _core.BadInput as error:
        return str(error.code)
    return None


def rounding_rows(value: dict[str, Any]) -> list[tuple[str, str]]:
    """The line for people below that of the file; none where nothing was rounded."""
    told = value["rounding"]
    if told is None:
        return []
    moved = f"{told['moved_vertices']:,} vertices moved"
    if told["moved_vertices"]:
        moved += f" by at most {scientific(told['largest_displacement'])} along an axis"
    if told["merged_vertices"]:
        moved += f"; {told['merged_vertices']:,} of them become equal to others"
    names = ("degenerate_faces", "turned_faces", "bent_faces")
    counts = [f"{told[name]:,} {name.replace('_', ' ')}" for name in names if told[name]]
    state = "closed" if told["closed"] else "not closed"
    fault = "no face crosses another" if told["fault"] is None else told["fault"]
    return [("as doubles", "; ".join([moved, *counts, state, fault]))]
