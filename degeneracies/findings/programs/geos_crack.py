"""GEOS by Shapely: union_all of 3 sets in doubles. geos wrong: hole-invented, missing

pip install shapely; python geos_crack.py
"""

import sys
from fractions import Fraction

import shapely

# Each set: polygons, each an outer ring and a list of holes.
SETS = [
    [([(1.0, 5.0), (0.0, 0.0), (3.0, 0.0)], [])],
    [([(3.0, 0.0), (2.0, 3.0), (0.0, 5.0)], [])],
    [([(2.0, 3.0), (1.0, 5.0), (3.0, 0.0)], [])],
]
x, truth = ("511399239614424404621787389472691542621426709358186628653476695473/383548998218195315522190411782134299711045372535379914129408000000", "1598119387600403865507630742332616967108858903946062416022709240949/383548998218195315522190411782134299711045372535379914129408000000"), True  # a point, and whether it is in the union


def rings(geometry):
    """The rings of all polygons, in fractions."""
    for part in getattr(geometry, "geoms", [geometry]):
        if part.geom_type == "Polygon":
            for ring in (part.exterior, *part.interiors):
                yield [(Fraction(a), Fraction(b)) for a, b in ring.coords]


def inside(geometry, point):
    """Even and odd crossings of a ray to the right, exactly."""
    odd = False
    for ring in rings(geometry):
        for a, b in zip(ring, ring[1:]):
            if (a[1] > point[1]) != (b[1] > point[1]):
                at = a[0] + (b[0] - a[0]) * (point[1] - a[1]) / (b[1] - a[1])
                odd ^= at > point[0]
    return odd


result = shapely.union_all([shapely.MultiPolygon(each) for each in SETS], grid_size=None)
print(f"GEOS {shapely.geos_version_string}, Shapely {shapely.__version__}")
print("union =", result.wkt)
if truth is not None:
    point = tuple(map(Fraction, x))
    found = inside(result, point)
    where = ", ".join(f"{float(number):.17g}" for number in point)
    print(f"x = ({where}) in this union: {'in' if found else 'out'}, in truth: {'in' if truth else 'out'}")
    sys.exit(found != truth)
