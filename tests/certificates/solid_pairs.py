"""Pairs of solids of any shape whose sums are certified, and what the slow engine says of them."""

from __future__ import annotations

import json
from fractions import Fraction
from itertools import product
from pathlib import Path
from typing import Any

from minkref import _core
from minkref.certify.space.solid_certificate import SolidCertificate
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.space.cells import surface_of
from minkref.fuzz.space.generators import machined
from minkref.fuzz.space.generators.convex import box

Scaling = tuple[str, str, str]
ONE: Scaling = ("1", "1", "1")
UNEQUAL: Scaling = ("1/2", "3", "7/5")


def brick(a: int, b: int, c: int) -> Polyhedron:
    return box((Fraction(0),) * 3, (Fraction(a), Fraction(b), Fraction(c)))


def prism(*ring: tuple[int, int], high: int = 1) -> Polyhedron:
    return machined.prism_over(list(ring), [], 0, high)


def tetrahedron() -> Polyhedron:
    rows = [["0", "0", "0"], ["2", "0", "0"], ["0", "1", "0"], ["1", "1", "3"]]
    faces = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]
    return Polyhedron.from_document({"vertices": rows, "faces": faces})


def bottle() -> Polyhedron:
    """Room for 3 x 3 x 2 cells in a shell of cells, with a mouth of one cell."""
    inside = set(product((1, 2, 3), (1, 2, 3), (1, 2))) | {(2, 2, 3)}
    return surface_of(set(product(range(5), range(5), range(4))) - inside)


def apart(*corners: tuple[int, int, int]) -> Polyhedron:
    """Unit cells, each a shell of its own: they may touch along edges and at points."""
    (first, *others) = (surface_of({corner}) for corner in corners)
    for other in others:
        first = first.with_faces_of(other)
    return first


L = prism((0, 0), (2, 0), (2, 1), (1, 1), (1, 2), (0, 2))
STAR = prism((0, 0), (4, 1), (5, 5), (3, 2), (1, 6), (2, 2), high=3)
WALLS = (1, 2, 1, 1)
HOLLOW = set(product(range(3), repeat=3)) - {(1, 1, 1)}
PAIRS: dict[str, tuple[Polyhedron, Polyhedron, list[Scaling]]] = {
    "convex": (tetrahedron(), brick(1, 2, 1), [ONE, UNEQUAL]),
    "L and cube": (L, brick(1, 1, 1), [ONE, UNEQUAL]),
    "ring and what fills its hole": (machined.square_ring(2, 2, WALLS, 1), brick(2, 2, 1), [ONE]),
    "ring and less": (machined.square_ring(2, 2, WALLS, 1), brick(1, 1, 2), [ONE]),
    "cup and less": (machined.cup(2, 3, 2, WALLS, 1), brick(1, 1, 3), [ONE, UNEQUAL]),
    "bottle, closed": (bottle(), brick(1, 1, 1), [ONE, ("1", "1/2", "1")]),
    "cavity, to a point": (surface_of(HOLLOW), brick(1, 1, 1), [ONE, ("5/4", "4/3", "3/2")]),
    "coplanar faces": (STAR, prism((0, 0), (3, 0), (0, 3), (1, 1), high=3), [ONE, UNEQUAL]),
    "polycubes": (surface_of({(0, 0, 0), (1, 0, 0), (1, 1, 0), (1, 1, 1)}), bottle(), [ONE]),
    "edges parallel": (L, L, [ONE, UNEQUAL]),
    "not convex, nor parallel": (STAR, tetrahedron(), [ONE, UNEQUAL]),
    "touching along an edge": (apart((0, 0, 0), (1, 1, 0)), brick(1, 1, 1), [("2", "2", "1")]),
    "faces touch at a point": (apart((0, 0, 0), (2, 2, 0)), brick(1, 1, 1), [ONE, UNEQUAL]),
    "bridged": (apart((0, 0, 0), (3, 0, 1)), brick(2, 1, 1), [ONE]),
}  # fmt: skip


def given(body: Polyhedron) -> _core.Polyhedron:
    value = body.document()
    return _core.Polyhedron([tuple(vertex) for vertex in value["vertices"]], value["faces"])


def certified(P: Polyhedron, Q: Polyhedron, scalings: list[Scaling]) -> SolidCertificate:
    certificate = SolidCertificate(given(P), given(Q))
    for scaling in scalings:
        certificate.sum(scaling)
    return certificate


def values(P: Polyhedron, Q: Polyhedron, scalings: list[Scaling]) -> tuple[Any, Any]:
    """Certificate and case as JSON values."""
    made = certified(P, Q, scalings)
    return json.loads(made.text("case.json")), json.loads(made.case())


def written(certificate: SolidCertificate, folder: Path) -> Path:
    (folder / "case.json").write_text(certificate.case(), encoding="utf-8")
    path = folder / "it.cert.json"
    path.write_text(certificate.text("case.json", "a test"), encoding="utf-8")
    return path
