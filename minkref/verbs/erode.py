"""`minkref erode P Q`: its options."""

from __future__ import annotations

from minkref.cli.verb import Verb, command_of
from minkref.settings import BALL, DISC, PLANE, SPACE
from minkref.verbs.erode_request import ErodeInPlane, ErodeInSpace, ErodeWithBall, ErodeWithDisc

EXAMPLES = """Examples:

minkref erode glyph1204 g1 --scale 30

minkref erode plate.wkt tool.wkt -o inset.svg

minkref erode "POLYGON ((0 0, 9 0, 9 9, 0 9, 0 0))" "POLYGON ((0 0, 9 0, 9 2, 0 2, 0 0))" --json

minkref erode P.wkt Q.wkt --scale 7/5 --route winding -o -

minkref index P.wkt Q.wkt --erode -o eroded.index

minkref erode P.wkt Q.wkt --index eroded.index --scale 7/5

minkref events P.wkt Q.wkt --erode --kind topology

minkref erode glyph1204 disc:7/5 -o inset.svg

minkref erode glyph1204 disc:7/5 -o inset.dxf

minkref erode glyph1204 disc:7/5 -o inset.wkt --tolerance 1/1000

minkref events glyph1204 disc --erode

minkref erode housing.off part.off --passages -o places.off

minkref erode housing.off ball:1/2 --tolerance 1/20 -o inset.off"""

TOLD = """\
The erosion of P, scaled by S about the origin, by Q: all places x at which x + Q lies within
    the scaled P (Minkowski difference). Exact, in canonical form, with its remnants: points and
    polylines at which Q fits exactly. Q may be a disc about the origin, as disc:7/5: the inset, or
    inward offset, a buffer with a negative distance. In space it may be a ball, as ball:7/5: two
    polyhedral sets then enclose the erosion."""

command = command_of(
    "erode",
    TOLD,
    {
        PLANE: Verb(ErodeInPlane, "minkref.plane.commands.erode:run_erode"),
        DISC: Verb(ErodeWithDisc, "minkref.disc.commands.erode:run"),
        BALL: Verb(ErodeWithBall, "minkref.space.commands.ball:run_erode"),
        SPACE: Verb(
            ErodeInSpace,
            "minkref.space.commands.erode:run",
            why=dict.fromkeys(("--plot", "--only-region"), "no picture is drawn"),
        ),
    },
)
