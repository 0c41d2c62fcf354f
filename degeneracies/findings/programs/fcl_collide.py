"""FCL by python-fcl: collide and distance of two convex prisms. pip install python-fcl

python fcl_collide.py "X" TRUTH A B: both are WKT polygons, convex, each made a prism between the
heights -1 and 1, and A is moved to the point "x y". TRUTH: in if the two meet, out if not.
"""

import sys
from fractions import Fraction

import fcl
import numpy as np


def ring_of(text: str) -> list[list[float]]:
    words = text[text.rindex("(") + 1 : text.index(")")].split(",")
    return [[float(Fraction(x)) for x in word.split()] for word in words[:-1]]


def prism(ring: list[list[float]], to: list[float]) -> fcl.CollisionObject:
    n = len(ring)
    corners = np.array([[x + to[0], y + to[1], z] for z in (-1, 1) for x, y in ring])
    faces = [list(range(n))[::-1], list(range(n, 2 * n))]
    faces += [[k, (k + 1) % n, n + (k + 1) % n, n + k] for k in range(n)]
    flat = np.array([number for face in faces for number in (len(face), *face)])
    return fcl.CollisionObject(fcl.Convex(corners, len(faces), flat))


point, truth, first, second = sys.argv[1:]
place = [float(Fraction(x)) for x in point.split()]
A, B = prism(ring_of(first), place), prism(ring_of(second), [0, 0])
meet = fcl.collide(A, B, fcl.CollisionRequest(), fcl.CollisionResult())
apart = fcl.distance(A, B, fcl.DistanceRequest(), fcl.DistanceResult())
print(f"python-fcl {fcl.__version__}; collide: {bool(meet)}; distance: {apart}")
print(f"A and B meet in truth: {truth == 'in'}")
sys.exit(truth != "any" and bool(meet) != (truth == "in"))
