"""GEOS, by Shapely: unions and offsets, no sums."""

from minkref.fuzz.libraries.library import Library, Method

LIBRARY = Library(
    title="GEOS",
    targets="geos",
    place=9,
    methods=(
        Method("geos", "GEOS (Shapely), union_all in doubles", "floating"),
        Method("geos-grid", "GEOS (Shapely), union_all on a grid of 40 bits", "grid"),
        Method("geos-buffer", "GEOS (Shapely), buffer: offsets", "buffer"),
    ),
    kind="python",
    program="geos/adapter.py",
    source="shapely 2.2.0 (PyPI), with the GEOS in its wheel",
    licence="LGPL-2.1-or-later",
    home="shapely",
    shows_unions=True,
)
