"""Coal: whether a part passes along a path, by `collide` or by `distance` of convex bodies; the
argument says which.

Its GJK has 1e-6 as tolerance, whatever the size; the coordinates of bodies are off by a few units
of a double. Hence ten times both.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from itertools import pairwise
from typing import Any

import coal  # type: ignore[import-not-found,unused-ignore]
import numpy as np
from adapter_protocol import serve  # type: ignore[import-not-found,unused-ignore]
from convex_pieces import Ring, path_of, prism_of  # type: ignore[import-not-found,unused-ignore]

HERE = coal.Transform3s()


def body_of(ring: Ring) -> Any:
    corners, faces = prism_of(ring)
    points, triangles = coal.StdVec_Vec3s(), coal.StdVec_Triangle()
    for corner in corners:
        points.append(np.array(corner))
    for face in faces:
        for a, b in pairwise(face[1:]):
            triangles.append(coal.Triangle(face[0], a, b))
    return coal.Convex(points, triangles)


def collide(one: Any, other: Any) -> bool:
    request, result = coal.CollisionRequest(), coal.CollisionResult()
    return bool(coal.collide(one, HERE, other, HERE, request, result))


def distance(one: Any, other: Any) -> bool:
    request, result = coal.DistanceRequest(), coal.DistanceResult()
    return bool(coal.distance(one, HERE, other, HERE, request, result) <= 0)


MEETS: dict[str, Callable[[Any, Any], bool]] = {"collide": collide, "distance": distance}

if __name__ == "__main__":
    hello = {
        "name": f"coal-{sys.argv[1]}",
        "version": coal.__version__,
        "language": "C++",
        "arithmetic": "float64",
        "numbers": "double",
        "grid": {"largest": "10000"},
        "tolerance": {"absolute": "1e-5", "relative": "1e-9"},
        "sum": "none",
        "capabilities": ["plane", "non-convex", "holes", "components", "path"],
    }
    serve(hello, None, path_of=path_of(body_of, MEETS[sys.argv[1]]))
