"""GEOS by Shapely: buffer of a frame whose octagonal hole is narrower than the distance.

pip install shapely; python geos_octagon.py
"""

import sys

import shapely

OUTER = [(-9, -9), (9, -9), (9, 9), (-9, 9)]
HOLE = [(2, 2), (3, 0), (2, -2), (0, -3), (-2, -2), (-3, 0), (-2, 2), (0, 3)]
DISTANCE = 2.9  # the middle of the hole, (0, 0), is 6 / sqrt(5) = 2.683 from its sides

frame = shapely.Polygon(OUTER, [HOLE])
grown = frame.buffer(DISTANCE)
inside = grown.contains(shapely.Point(0, 0))
print(f"GEOS {shapely.geos_version_string}, Shapely {shapely.__version__}; valid: {frame.is_valid}")
print("holes of the buffer:", [hole.wkt for hole in grown.interiors])
print(f"x = (0, 0) in the buffer: {'in' if inside else 'out'}, in truth: in")
sys.exit(not inside)
