"""FCL in Python: whether a part passes along a path, by `collide` or by `distance` of convex
bodies; the argument says which.

FCL's solver (libccd) has 1e-6 as tolerance of collisions and distances, whatever the size; the
coordinates of bodies are off by a few units of a double. Hence ten times both.
"""

from __future__ import annotations

import sys
from collections.abc import Callable
from importlib.metadata import version
from typing import Any

import fcl  # type: ignore[import-not-found,unused-ignore]
import numpy as np
from adapter_protocol import serve  # type: ignore[import-not-found,unused-ignore]
from convex_pieces import Ring, path_of, prism_of  # type: ignore[import-not-found,unused-ignore]


def body_of(ring: Ring) -> Any:
    vertices, faces = prism_of(ring)
    flat = [number for face in faces for number in (len(face), *face)]
    return fcl.CollisionObject(fcl.Convex(np.array(vertices), len(faces), np.array(flat)))


def collide(one: Any, other: Any) -> bool:
    return bool(fcl.collide(one, other, fcl.CollisionRequest(), fcl.CollisionResult()))


def distance(one: Any, other: Any) -> bool:
    return bool(fcl.distance(one, other, fcl.DistanceRequest(), fcl.DistanceResult()) <= 0)


MEETS: dict[str, Callable[[Any, Any], bool]] = {"collide": collide, "distance": distance}

if __name__ == "__main__":
    hello = {
        "name": f"fcl-{sys.argv[1]}",
        "version": version("python-fcl"),
        "language": "C++",
        "arithmetic": "float64",
        "numbers": "double",
        "grid": {"largest": "10000"},
        "tolerance": {"absolute": "1e-5", "relative": "1e-9"},
        "sum": "none",
        "capabilities": ["plane", "non-convex", "holes", "components", "path"],
    }
    serve(hello, None, path_of=path_of(body_of, MEETS[sys.argv[1]]))
