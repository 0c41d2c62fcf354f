"""Manifold."""

from minkref.fuzz.libraries.library import Library, Method

LIBRARY = Library(
    title="Manifold",
    targets="manifold3d",
    place=3,
    methods=(
        Method("manifold3d", "Manifold, minkowski_sum in space"),
        Method(
            "manifold3d-offset",
            "Manifold, CrossSection.offset in the plane: offsets",
            program="manifold/offset_adapter.py",
        ),
    ),
    kind="python",
    program="manifold/adapter.py",
    source="manifold3d 3.5.4 (PyPI)",
    licence="Apache-2.0",
    home="manifold3d",
)
