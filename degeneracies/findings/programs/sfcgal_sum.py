"""SFCGAL: minkowski_sum of two polygons, exact. pip install pysfcgal

python sfcgal_sum.py "X" TRUTH P Q: X is a point "x y", TRUTH what is right of it: in, out, or any
where the call alone matters. P and Q are WKT.
"""

import re
import sys
from fractions import Fraction
from importlib.metadata import version

from pysfcgal.geometry import Geometry


def rings(wkt):
    """The innermost parentheses, as lists of points in fractions."""
    texts = re.findall(r"\(([^()]+)\)", wkt)
    return [[tuple(map(Fraction, p.split()[:2])) for p in text.split(",")] for text in texts]


def inside(wkt, x, y):
    """Even and odd crossings of a ray to the right."""
    odd = False
    for ring in rings(wkt):
        for (a, b), (c, d) in zip(ring, ring[1:]):
            if (b > y) != (d > y):
                odd ^= a + (c - a) * (y - b) / (d - b) > x
    return odd


point, truth, P, Q = sys.argv[1:]
print(f"pysfcgal {version('pysfcgal')}", flush=True)
result = Geometry.from_wkt(P).minkowski_sum(Geometry.from_wkt(Q))
if result is None:
    sys.exit("no geometry came back")
found = "in" if inside(result.to_wkt(), *map(Fraction, point.split())) else "out"
print(f"sum = {result.to_wkt()}\nx = ({point}) in this sum: {found}, in truth: {truth}")
sys.exit(truth not in ("any", found))
