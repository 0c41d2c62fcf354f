"""SFCGAL: minkowski_sum of two polygons, exact. pysfcgal crashed: crashed, SIGSEGV

pip install pysfcgal; python sfcgal_crash.py
"""

import re
import sys
from fractions import Fraction
from importlib.metadata import version

from pysfcgal.geometry import Geometry

P = "POLYGON ((3 2,0 4,0 0,3 2),(2 2,1 1,1 3,2 2))"
Q = "POLYGON ((1 1,1 2,0 1,0 0,2 0,1 1))"
x, truth = tuple(map(Fraction, ("0", "0"))), None  # a point, and whether it is in the sum


def rings(wkt):
    """The innermost parentheses, as lists of points in fractions."""
    texts = re.findall(r"\(([^()]+)\)", wkt)
    return [[tuple(map(Fraction, p.split()[:2])) for p in text.split(",")] for text in texts]


def inside(wkt, point):
    """Even and odd crossings of a ray to the right."""
    odd = False
    for ring in rings(wkt):
        for a, b in zip(ring, ring[1:]):
            if (a[1] > point[1]) != (b[1] > point[1]):
                at = a[0] + (b[0] - a[0]) * (point[1] - a[1]) / (b[1] - a[1])
                odd ^= at > point[0]
    return odd


result = Geometry.from_wkt(P).minkowski_sum(Geometry.from_wkt(Q))
print(f"pysfcgal {version('pysfcgal')}")
print("P =", P)
print("Q =", Q)
if result is None:
    sys.exit("no geometry came back")
print("sum =", result.to_wkt())
if truth is not None:
    found = inside(result.to_wkt(), x)
    where = ", ".join(map(str, x))
    print(f"x = ({where}) in this sum: {'in' if found else 'out'}, in truth: {'in' if truth else 'out'}")
    sys.exit(found != truth)
