"""Clipper2, by Angus Johnson."""

from minkref.fuzz.libraries.library import Adapter, Library

SOURCE = "Clipper2 2.0.1, from the source distribution of pyclipr 0.1.8 (PyPI)"


def _adapter(name: str, title: str, mode: str) -> Adapter:
    program = "clipper2/adapter.cpp"
    return Adapter(name, title, "c++", program, SOURCE, "BSL-1.0", (mode,), "clipper2")


LIBRARY = Library(
    title="Clipper2",
    targets="clipper2",
    place=1,
    adapters=(
        _adapter("clipper2", "Clipper2, MinkowskiSum of two rings (their curves)", "boundary"),
        _adapter(
            "clipper2-region", "Clipper2, the region built on MinkowskiSum and Union", "region"
        ),
        _adapter("clipper2-double", "Clipper2, MinkowskiSum of doubles, two decimals", "double"),
    ),
)
