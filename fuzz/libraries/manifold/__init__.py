"""Manifold."""

from minkref.fuzz.libraries.library import Adapter, Library

LIBRARY = Library(
    title="Manifold",
    targets="manifold3d",
    place=3,
    adapters=(
        Adapter(
            name="manifold3d",
            title="Manifold, minkowski_sum in space",
            kind="python",
            program="manifold/adapter.py",
            home="manifold3d",
            source="manifold3d 3.5.4 (PyPI)",
            licence="Apache-2.0",
        ),
    ),
)
