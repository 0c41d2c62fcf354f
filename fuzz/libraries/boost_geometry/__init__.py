"""Boost.Geometry: unions and offsets, no sums."""

from minkref.fuzz.libraries.library import Library, Method

LIBRARY = Library(
    title="Boost.Geometry",
    targets="boost-geometry",
    place=3,
    methods=(
        Method("boost-geometry", "Boost.Geometry, union_ of one set after the other", "union"),
        Method("boost-geometry-buffer", "Boost.Geometry, buffer: offsets", "buffer"),
    ),
    kind="c++",
    program="boost_geometry/adapter.cpp",
    source="Boost of the system (Debian: libboost-dev)",
    licence="BSL-1.0",
    home="boost-geometry",
    shows_unions=True,
)
