"""SFCGAL, by pysfcgal."""

from minkref.fuzz.libraries.library import Library, Method

LIBRARY = Library(
    title="SFCGAL",
    targets="pysfcgal",
    place=4,
    methods=(
        Method("pysfcgal", "SFCGAL, minkowski_sum in the plane", "plane"),
        Method("pysfcgal-space", "SFCGAL, minkowski_sum_3d", "space"),
    ),
    kind="python",
    program="sfcgal/adapter.py",
    source="pysfcgal 2.3.0 (PyPI)",
    licence="GPL-3.0-or-later",
    home="pysfcgal",
)
