"""Boost.Polygon."""

from minkref.fuzz.libraries.library import Library, Method

LIBRARY = Library(
    title="Boost.Polygon",
    targets="boost-polygon",
    place=2,
    methods=(
        Method(
            "boost-polygon", "Boost.Polygon, the sum of its tutorial (convolve_two_polygon_sets)"
        ),
    ),
    kind="c++",
    program="boost_polygon/adapter.cpp",
    source="Boost of the system (Debian: libboost-dev)",
    licence="BSL-1.0",
    home="boost-polygon",
)
