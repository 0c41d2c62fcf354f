"""Pairs of sets as text: several components, islands, or touching parts."""

TRIANGLE = "POLYGON((0 0,1 0,0 1,0 0))"
# Four squares that touch at corners, around a hole.
RING_OF_SQUARES = "MULTIPOLYGON({})".format(
    ",".join(
        f"(({x} {y},{x + 1} {y},{x + 1} {y + 1},{x} {y + 1},{x} {y}))"
        for x, y in ((1, 0), (0, 1), (2, 1), (1, 2))
    )
)
# The second set: a frame, an island with a hole, and a part beside them.
ISLANDS = (
    "POLYGON((0 0,3 0,1 2,0 0))",
    "MULTIPOLYGON(((0 0,60 0,60 60,0 60,0 0),(5 5,5 55,55 55,55 5,5 5)),"
    "((20 20,40 20,40 40,20 40,20 20),(24 24,24 36,36 36,36 24,24 24)),"
    "((70 0,80 0,70 9,70 0)))",
)
SEVERAL_COMPONENTS = (
    "MULTIPOLYGON(((0 0,2 0,0 2,0 0)),((5 5,6 5,6 6,5 5)))",
    "MULTIPOLYGON(((0 0,7 0,7 7,0 7,0 0),(2 2,2 5,5 5,5 2,2 2)),((9 0,11 0,11 7,9 0)))",
)
