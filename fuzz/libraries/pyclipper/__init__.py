"""Clipper 1, by Angus Johnson, in the Python package pyclipper."""

from minkref.fuzz.libraries.library import Library, Method

LIBRARY = Library(
    title="Clipper 1",
    targets="pyclipper",
    place=10,
    methods=(
        Method(
            "pyclipper",
            "Clipper 1 (pyclipper), MinkowskiSum of two rings (their curves)",
            "boundary",
        ),
        Method("pyclipper-union", "Clipper 1 (pyclipper), Execute: unions", "union"),
        Method(
            "pyclipper-inflate",
            "Clipper 1 (pyclipper), PyclipperOffset with round joins: offsets",
            "inflate",
        ),
    ),
    kind="python",
    program="pyclipper/adapter.py",
    source="pyclipper 1.4.0 (PyPI), with the Clipper 6.4.2 in its wheel",
    licence="MIT (wrapper), BSL-1.0 (Clipper)",
    home="pyclipper",
    has_program=False,
)
