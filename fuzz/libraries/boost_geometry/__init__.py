"""Boost.Geometry: unions alone, no sums."""

from minkref.fuzz.libraries.library import Library, Method

LIBRARY = Library(
    title="Boost.Geometry",
    targets="boost-geometry",
    place=3,
    methods=(Method("boost-geometry", "Boost.Geometry, union_ of one set after the other"),),
    kind="c++",
    program="boost_geometry/adapter.cpp",
    source="Boost of the system (Debian: libboost-dev)",
    licence="BSL-1.0",
    home="boost-geometry",
    shows_unions=True,
)
