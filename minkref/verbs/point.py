"""`minkref point P Q --at X,Y`: its options."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

import typer
from minkref.cli.memory import Memory
from minkref.cli.options import ONE, FirstOperand, Json, ScaleInPlane, SecondOperand
from minkref.cli.request import Read
from minkref.cli.verb import Absent, Verb, command_of
from minkref.exact import read_points
from minkref.settings import PLANE, SPACE

EXAMPLES = """Examples:

minkref point g1 g2 --at 3,1/2

minkref point P.wkt Q.geojson --scale 7/5 --at 1/3,5 --at 0,0 --json

minkref point disc1 cells1815 --scale 541/186 --points places.txt

minkref point P.wkt "POINT (1 1)" --scale 2,1/3 --at 3,1/2 --proved"""

TOLD = """\
Whether points are in the sum of P, scaled by S about the origin, and Q: exact, from the
definition, without the sum. Of each point in it: whether the interiors meet or the sets only
touch there, and a p of P and a q of Q with S p + q the point. With --proved a program decides
that is proved right in Coq, both ways; one operand, or both, may be a point or a segment."""

At = Annotated[
    list[tuple[str, str]] | None,
    typer.Option("--at", metavar="X,Y", help="A point, exact; may be repeated."),
    Read(read_points, list[str]),
]
Points = Annotated[
    Path | None,
    typer.Option(
        "--points",
        metavar="FILE",
        help="Also all points of this file, X,Y in each line; - is standard input.",
    ),
]
Proved = Annotated[
    bool,
    typer.Option(
        "--proved",
        help="By the program that is proved right in Coq (`make proofs` builds it): whether, and "
        "nothing of p, q and contact. Says what is proved and what is trusted.",
    ),
]


@dataclass(frozen=True)
class PointsInPlane:
    P: FirstOperand
    Q: SecondOperand
    scale: ScaleInPlane = ONE
    at: At = None
    points: Points = None
    proved: Proved = False
    memory: Memory = None
    json: Json = False


command = command_of(
    "point",
    TOLD,
    {
        PLANE: Verb(PointsInPlane, "minkref.plane.commands.point:run"),
        SPACE: Absent(
            "`minkref point` decides in the plane only",
            "`minkref sum P Q --at X,Y,Z` says where a point lies in a sum of polyhedra",
        ),
    },
)
