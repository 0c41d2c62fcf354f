"""Concave features by others: along CGAL's and Boost's Voronoi diagrams, and by all triples."""

from minkref.fuzz.libraries.library import Library, Method

LIBRARY = Library(
    title="features by diagrams",
    targets="features-",
    place=9,
    methods=(
        Method("features-cgal", "features along CGAL's segment Delaunay graph: bars", "CGAL"),
        Method("features-boost", "features along Boost's Voronoi diagram: bars", "Boost"),
        Method(
            "features-triples",
            "features by all triples of sites: bars, bridges; slow",
            program="features/triples_adapter.py",
        ),
    ),
    kind="own",
    program="features/diagram_adapter.py",
    source="this package",
    licence="Apache-2.0",
    has_program=False,
    in_all=False,
)
