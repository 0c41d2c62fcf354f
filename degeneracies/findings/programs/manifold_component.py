"""Manifold: minkowski_sum of two solids. manifold3d wrong: missing

pip install manifold3d numpy; python manifold_component.py
"""

import sys
from importlib.metadata import version
from math import pi

import numpy as np
from manifold3d import Manifold, Mesh64

P = (
    [[0.0, 0.0, 0.0], [0.0, 0.0, 24.0], [0.0, 24.0, 0.0], [24.0, 0.0, 0.0], [6.0, 6.0, 6.0]],
    [[0, 1, 2], [0, 2, 3], [0, 3, 1], [1, 3, 4], [3, 2, 4], [2, 1, 4]],
)
Q = (
    [[0.0, 0.0, 0.0], [2.0, 1.0, 1.0], [1.0, 2.0, 1.0], [1.0, 1.0, 2.0], [40.0, 0.0, 0.0], [42.0, 1.0, 1.0],
    [41.0, 2.0, 1.0], [41.0, 1.0, 2.0]],
    [[0, 2, 1], [0, 3, 2], [0, 1, 3], [1, 2, 3], [4, 6, 5], [4, 7, 6],
    [4, 5, 7], [5, 6, 7]],
)
x, truth = [46.0, 3.5, 3.5], True  # a point, and whether it is in the sum


def solid(vertices, triangles):
    return Manifold(Mesh64(np.array(vertices, np.float64), np.array(triangles, np.uint64)))


def winding(mesh, point):
    """How often the surface runs around the point: its solid angles over those of a sphere."""
    a, b, c = (mesh.vert_properties[mesh.tri_verts[:, k], :3] - point for k in range(3))
    la, lb, lc = (np.linalg.norm(v, axis=1) for v in (a, b, c))
    top = np.einsum("ij,ij->i", a, np.cross(b, c))
    dots = [np.einsum("ij,ij->i", u, v) for u, v in ((a, b), (b, c), (c, a))]
    bottom = la * lb * lc + dots[0] * lc + dots[1] * la + dots[2] * lb
    return 2 * np.arctan2(top, bottom).sum() / (4 * pi)


p, q = solid(*P), solid(*Q)
sum_ = p.minkowski_sum(q)
print(f"manifold3d {version('manifold3d')}: {p.status()}, {q.status()}, {sum_.status()}")
print(f"volumes: P {p.volume():.9g}, Q {q.volume():.9g}, sum {sum_.volume():.9g}")
print(f"box of the sum: {sum_.bounding_box()}")
if truth is not None:
    inside = bool(winding(sum_.to_mesh64(), np.array(x)) > 0.5)
    print(f"x = {x} in this sum: {'in' if inside else 'out'}, in truth: {'in' if truth else 'out'}")
    sys.exit(inside != truth)
