"""SFCGAL, by pysfcgal."""

from minkref.fuzz.libraries.library import Adapter, Library

SOURCE = "pysfcgal 2.3.0 (PyPI)"
LICENCE = "GPL-3.0-or-later"


def _adapter(name: str, title: str, mode: str) -> Adapter:
    program = "sfcgal/adapter.py"
    return Adapter(name, title, "python", program, SOURCE, LICENCE, (mode,), "pysfcgal")


LIBRARY = Library(
    title="SFCGAL",
    targets="pysfcgal",
    place=4,
    adapters=(
        _adapter("pysfcgal", "SFCGAL, minkowski_sum in the plane", "plane"),
        _adapter("pysfcgal-space", "SFCGAL, minkowski_sum_3d", "space"),
    ),
)
