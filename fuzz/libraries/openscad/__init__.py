"""OpenSCAD."""

from minkref.fuzz.libraries.library import Library, Method

LIBRARY = Library(
    title="OpenSCAD",
    targets="openscad",
    place=5,
    methods=(
        Method("openscad", "OpenSCAD, minkowski() in the plane and in space", "sum"),
        Method("openscad-offset", "OpenSCAD, offset(r) in the plane: offsets", "offset"),
    ),
    kind="debian",
    program="openscad/adapter.py",
    source="OpenSCAD of the system (Debian: openscad 2021.01)",
    licence="GPL-2.0-or-later",
)
