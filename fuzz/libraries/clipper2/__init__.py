"""Clipper2, by Angus Johnson."""

from minkref.fuzz.libraries.library import Library, Method

LIBRARY = Library(
    title="Clipper2",
    targets="clipper2",
    place=1,
    methods=(
        Method("clipper2", "Clipper2, MinkowskiSum of two rings (their curves)", "boundary"),
        Method("clipper2-region", "Clipper2, the region built on MinkowskiSum and Union", "region"),
        Method("clipper2-double", "Clipper2, MinkowskiSum of doubles, two decimals", "double"),
        Method("clipper2-inflate", "Clipper2, InflatePaths with round joins: offsets", "inflate"),
    ),
    kind="c++",
    program="clipper2/adapter.cpp",
    source="Clipper2 2.0.1, from the source distribution of pyclipr 0.1.8 (PyPI)",
    licence="BSL-1.0",
    home="clipper2",
)
