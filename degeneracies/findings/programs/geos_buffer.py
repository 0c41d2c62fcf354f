"""GEOS by Shapely: buffer. pip install shapely

python geos_buffer.py "X" TRUTH SET DISTANCE: X is a point "x y", TRUTH what is right of it: in,
out, or any where the call alone matters. The set is WKT.
"""

import sys
from fractions import Fraction

import shapely

point, truth, text, distance = sys.argv[1:]
given = shapely.from_wkt(text)
grown = given.buffer(float(distance))
found = "in" if grown.contains(shapely.Point([float(Fraction(x)) for x in point.split()])) else "out"
print(f"GEOS {shapely.geos_version_string}, Shapely {shapely.__version__}; valid: {given.is_valid}")
print("holes of the buffer:", [hole.wkt for p in shapely.get_parts(grown) for hole in p.interiors])
print(f"x = ({point}) in the buffer: {found}, in truth: {truth}")
sys.exit(truth not in ("any", found))
