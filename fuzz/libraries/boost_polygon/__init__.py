"""Boost.Polygon."""

from minkref.fuzz.libraries.library import Adapter, Library

LIBRARY = Library(
    title="Boost.Polygon",
    targets="boost-polygon",
    place=2,
    adapters=(
        Adapter(
            name="boost-polygon",
            title="Boost.Polygon, the sum of its tutorial (convolve_two_polygon_sets)",
            kind="c++",
            program="boost_polygon/adapter.cpp",
            home="boost-polygon",
            source="Boost of the system (Debian: libboost-dev)",
            licence="BSL-1.0",
        ),
    ),
)
