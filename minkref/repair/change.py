"""A change made by a repair: kind, place, exact size."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

Vector = tuple[Fraction, ...]

#: Each kind in words; braces name fields of a change.
TOLD = {
    "closed": "was open: an edge from its last point to the first closes it",
    "repeated-point": "point {point} repeated, dropped",
    "spike": "spike without area at {point} cut off",
    "no-area": "encloses nothing, dropped",
    "turned": "runs the other way round now",
    "self-touching": "touched itself at {point}: split there",
    "self-crossing": "crossed itself at {point}: filled by the rule",
    "hole-outside": "hole reached out of its polygon: the part there dropped",
    "holes-overlap": "hole overlapped another one: united",
    "shared-edge": "hole shared an edge with another ring: joined",
    "polygons-overlap": "polygon overlapped another one: united",
    "polygons-abut": "polygon shared an edge with another one: united",
    "welded": "{point} moved to {to}",
    "joined": "vertex {vertex} at {point} is vertex {other_vertex} now",
    "repeated-vertex": "vertex {vertex} repeated, dropped",
    "zero-area": "face without area, dropped",
    "edge-split": "vertex {vertex} inserted on an edge, for a face without area beside it",
    "duplicate-face": "the same as face {other_face}, dropped",
    "opposite-face": "covered face {other_face} from the other side, both dropped",
    "triangulated": "vertices in no plane: cut into triangles",
    "turned-face": "turned, to agree with its neighbours",
    "turned-shell": "shell of {faces} faces was inside out: turned",
    "dropped-shell": "shell of {faces} faces in material bounds nothing: dropped",
    "split-vertex": "vertex {vertex} was of several sheets: one has {other_vertex} now",
    "unused-vertex": "vertex {vertex} of no face, dropped",
}
KINDS = tuple(TOLD)


@dataclass(frozen=True)
class Change:
    """Rings and faces, and the vertices of a ring or of the polyhedron, are counted from 0 as in
    the file; None for parts made by the repair. `squared_distance`: of the move, gap
    or spike; `area`, or in space `squared_area`: of the part concerned."""

    kind: str
    ring: int | None = None
    other_ring: int | None = None
    face: int | None = None
    other_face: int | None = None
    faces: int | None = None
    vertex: int | None = None
    other_vertex: int | None = None
    line: int | None = None
    point: Vector | None = None
    to: Vector | None = None
    squared_distance: Fraction | None = None
    area: Fraction | None = None
    squared_area: Fraction | None = None
    volume: Fraction | None = None

    def document(self) -> dict[str, Any]:
        """Return the fields that the change has, numbers as texts."""
        found: dict[str, Any] = {}
        for name, value in vars(self).items():
            if isinstance(value, tuple):
                found[name] = [str(number) for number in value]
            elif isinstance(value, Fraction):
                found[name] = str(value)
            elif value is not None:
                found[name] = value
        return found


def told(change: dict[str, Any]) -> str:
    """Write a change document as a line."""
    where = [
        f"{word} {change[name]}"
        for name, word in (("line", "line"), ("ring", "ring"), ("face", "face"))
        if name in change
    ]
    if "ring" in change and "vertex" in change:
        where.append(f"vertex {change['vertex']}")
    if "other_ring" in change:
        where.append(f"and ring {change['other_ring']}")
    words = {
        name: _point(value) if name in ("point", "to") else value for name, value in change.items()
    }
    sizes = [
        f"{word} {change[name]}"
        for name, word in (
            ("squared_distance", "squared distance"),
            ("area", "area"),
            ("squared_area", "squared area"),
            ("volume", "volume"),
        )
        if name in change
    ]
    text = f"{', '.join(where)}: " if where else ""
    return text + ", ".join([TOLD[change["kind"]].format_map(words), *sizes])


def _point(numbers: Sequence[str]) -> str:
    return f"({', '.join(numbers)})"
