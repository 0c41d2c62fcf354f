"""CGAL: polyhedra and unions by adapters; for methods in the plane see the targets `cgal-...`."""

from minkref.fuzz.libraries.library import Library, Method

LIBRARY = Library(
    title="CGAL",
    targets="cgal-",
    place=6,
    methods=(
        Method("cgal-nef", "CGAL, minkowski_sum_3 of Nef polyhedra", "nef"),
        Method("cgal-join", "CGAL, join of polygon sets: unions", "join", "minkref-cgal-join"),
        Method(
            "cgal-offset",
            "CGAL, approximated_offset_2: offsets",
            "approximated",
            "minkref-cgal-offset",
        ),
        Method(
            "cgal-skeleton",
            "CGAL, offsets along the straight skeleton: sharp corners",
            "skeleton",
            "minkref-cgal-skeleton",
        ),
        Method("cgal-hull", "CGAL, convex_hull_3 of the sums of vertices (convex only)", "hull"),
    ),
    kind="cgal",
    program="minkref-cgal-space",
    source="oracle/cgal, with the CGAL that the project finds",
    licence="GPL-3.0-or-later",
)
