"""Manifold: minkowski_sum of two solids. pip install manifold3d numpy

python manifold_sum.py "X" TRUTH P Q: X is a point "x y z", TRUTH what is right of it: in, out, or
any where the call alone matters. P and Q are JSON: {"vertices": ..., "faces": ...}, triangles.
"""

import json
import sys
from fractions import Fraction
from importlib.metadata import version
from math import pi

import numpy as np
from manifold3d import Manifold, Mesh64


def solid(text):
    value = json.loads(text)
    points = np.array(value["vertices"], np.float64)
    return Manifold(Mesh64(points, np.array(value["faces"], np.uint64)))


def winding(mesh, point):
    """How often the surface runs around the point: its solid angles over those of a sphere."""
    a, b, c = (mesh.vert_properties[mesh.tri_verts[:, k], :3] - point for k in range(3))
    la, lb, lc = (np.linalg.norm(v, axis=1) for v in (a, b, c))
    top = np.einsum("ij,ij->i", a, np.cross(b, c))
    dots = [np.einsum("ij,ij->i", u, v) for u, v in ((a, b), (b, c), (c, a))]
    bottom = la * lb * lc + dots[0] * lc + dots[1] * la + dots[2] * lb
    return 2 * np.arctan2(top, bottom).sum() / (4 * pi)


point, truth = sys.argv[1:3]
p, q = map(solid, sys.argv[3:])
sum_ = p.minkowski_sum(q)
print(f"manifold3d {version('manifold3d')}: {p.status()}, {q.status()}, {sum_.status()}")
print(f"volumes: P {p.volume():.9g}, Q {q.volume():.9g}, sum {sum_.volume():.9g}")
x = np.array([float(Fraction(each)) for each in point.split()])
found = "in" if winding(sum_.to_mesh64(), x) > 0.5 else "out"
print(f"x = ({point}) in this sum: {found}, in truth: {truth}")
sys.exit(truth not in ("any", found))
