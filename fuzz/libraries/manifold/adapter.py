"""Manifold (the Python package manifold3d): Manifold.minkowski_sum, in space, in doubles.

The tolerance: Manifold merges points closer than 1e-12 times the box's size, in each Boolean
operation for a sum of non-convex operands; the tolerance is a thousand times larger.
"""

from __future__ import annotations

import time
from importlib.metadata import version

import numpy as np
from adapter_protocol import Set, serve  # type: ignore[import-not-found,unused-ignore]
from manifold3d import Error, Manifold, Mesh64  # type: ignore[import-not-found,unused-ignore]
from surfaces import triangles_of  # type: ignore[import-not-found,unused-ignore]

HELLO = {
    "name": "manifold3d",
    "version": version("manifold3d"),
    "language": "C++",
    "arithmetic": "float64",
    "numbers": "double",
    "tolerance": {"absolute": "0", "relative": "1e-9"},
    "sum": "region",
    "capabilities": ["space", "non-convex", "holes", "components", "non-uniform"],
}


def solid(mesh: Set) -> Manifold:
    """Returns the mesh as a Manifold; a refusal is an error."""
    vertices = np.array(mesh["vertices"], dtype=np.float64).reshape(-1, 3)
    triangles = np.array(triangles_of(mesh["vertices"], mesh["faces"]), dtype=np.uint64)
    return checked(Manifold(Mesh64(vertices, triangles.reshape(-1, 3))), "an operand")


def checked(manifold: Manifold, what: str) -> Manifold:
    if manifold.status() != Error.NoError:
        raise ValueError(f"{what}: {manifold.status()}")
    return manifold


def sum_of(sP: Set, Q: Set) -> dict[str, object]:
    """Returns the sum, with volume and seconds beside it, which the protocol ignores."""
    first, second = solid(sP), solid(Q)
    start = time.perf_counter()
    found = checked(first.minkowski_sum(second), "the sum")  # the status evaluates it
    seconds = time.perf_counter() - start
    result = found.to_mesh64()
    # A vertex's first three properties are its coordinates.
    vertices = result.vert_properties[:, :3].tolist()
    return {
        "vertices": vertices,
        "faces": result.tri_verts.tolist(),
        "library_volume": found.volume(),
        "library_seconds": seconds,
    }


if __name__ == "__main__":
    serve(HELLO, sum_of)
