"""GEOS by Shapely: union_all of sets. pip install shapely

python geos_union.py "X" TRUTH SET...: X is a point "x y" in fractions, TRUTH what is right of it:
in, out, or any where the call alone matters. Each set is WKT.
"""

import sys
from fractions import Fraction

import shapely


def inside(geometry, x, y):
    """Even and odd crossings of a ray to the right, exactly."""
    odd = False
    for part in shapely.get_parts(geometry):
        for ring in (part.exterior, *part.interiors):
            points = [tuple(map(Fraction, p)) for p in ring.coords]
            for (a, b), (c, d) in zip(points, points[1:]):
                if (b > y) != (d > y):
                    odd ^= a + (c - a) * (y - b) / (d - b) > x
    return odd


point, truth, *sets = sys.argv[1:]
result = shapely.union_all(list(map(shapely.from_wkt, sets)))
print(f"GEOS {shapely.geos_version_string}, Shapely {shapely.__version__}")
found = "in" if inside(result, *map(Fraction, point.split())) else "out"
print(f"union = {result.wkt}\nx = ({point}) in this union: {found}, in truth: {truth}")
sys.exit(truth not in ("any", found))
