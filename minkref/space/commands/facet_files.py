"""Meshes of the facets of a sum whose files say which parents each facet has."""

from __future__ import annotations

from collections.abc import Callable

from minkref import _core
from minkref.space.facets import KINDS, Facet

COLOURS = {  # red, green, blue of 0 to 255
    "fv": (31, 95, 153),
    "vf": (154, 84, 16),
    "ee": (42, 110, 48),
    "fe": (156, 195, 230),
    "ef": (242, 193, 141),
    "ff": (185, 185, 185),
}
_END = "end_header\n"


def ply_text(surface: _core.Polyhedron, facets: list[Facet]) -> str:
    """PLY with three properties of each face: its kind, by number, and the vertices of its parents
    in P and Q. Raises BadInput where a coordinate rounds to no double."""
    head, _, body = _core.write_mesh(surface, "ply").partition(_END)
    start, _, elements = head.partition("element ")
    comments = [f"kind {number}, {kind}: {KINDS[kind]}" for number, kind in enumerate(KINDS)]
    comments.append("p, q: vertices of the parents, as operands in canonical form number them")
    told = "".join(f"comment {comment}\n" for comment in comments)
    size = "uchar" if all(len(f.P) < 256 and len(f.Q) < 256 for f in facets) else "uint"
    properties = "property uchar kind\n" + "".join(
        f"property list {size} uint {name}\n" for name in ("p", "q")
    )
    lines = body.splitlines()
    first = len(lines) - len(facets)
    numbers = {kind: number for number, kind in enumerate(KINDS)}
    for place, facet in enumerate(facets, first):
        words = [numbers[facet.kind], len(facet.P), *facet.P, len(facet.Q), *facet.Q]
        lines[place] += "".join(f" {word}" for word in words)
    rows = "".join(f"{line}\n" for line in lines)
    return f"{start}{told}element {elements}{properties}{_END}{rows}"


def off_text(surface: _core.Polyhedron, facets: list[Facet]) -> str:
    """OFF with a colour for each kind of facet, which comments explain. It has no place for
    parents. Raises BadInput where a coordinate rounds to no double."""
    lines = _core.write_mesh(surface, "off").splitlines()
    first = len(lines) - len(facets)
    for place, facet in enumerate(facets, first):
        lines[place] += "".join(f" {part}" for part in COLOURS[facet.kind])
    used = {facet.kind for facet in facets}
    told = [
        f"# {' '.join(map(str, COLOURS[kind]))}: {kind}, {KINDS[kind]}"
        for kind in KINDS
        if kind in used
    ]
    return "".join(f"{line}\n" for line in [lines[0], *told, *lines[1:]])


WRITERS: dict[str, Callable[[_core.Polyhedron, list[Facet]], str]] = {
    "off": off_text,
    "ply": ply_text,
}
