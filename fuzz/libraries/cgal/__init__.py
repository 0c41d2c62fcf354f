"""CGAL: polyhedra by an adapter; its methods in the plane are targets of their own."""

from minkref.fuzz.libraries.library import Adapter, Library

PROGRAM = "minkref-cgal-space"
SOURCE = "oracle/cgal, with the CGAL that the project finds"
LICENCE = "GPL-3.0-or-later"


def _adapter(name: str, title: str, mode: str) -> Adapter:
    return Adapter(name, title, "cgal", PROGRAM, SOURCE, LICENCE, (mode,))


LIBRARY = Library(
    title="CGAL",
    targets="cgal-",
    place=6,
    adapters=(
        _adapter("cgal-nef", "CGAL, minkowski_sum_3 of Nef polyhedra", "nef"),
        _adapter("cgal-hull", "CGAL, convex_hull_3 of the sums of vertices (convex only)", "hull"),
    ),
)
