"""`minkref fit PART CONTAINER`: its options, in the plane and in space."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import Annotated

import typer
from minkref.cli.memory import Memory
from minkref.cli.options import Json
from minkref.cli.request import Read
from minkref.cli.verb import Verb, command_of
from minkref.disc.disc import read_tolerance
from minkref.exact import exact_scale, read_point, read_points, read_space_point
from minkref.settings import DISC, PLANE, SPACE
from minkref.verbs.path import Clearance, Contact

EXAMPLES = """Examples:

minkref fit disc1 g1 --anywhere

minkref fit bolt.wkt slot.wkt --at 3,1/2

minkref fit cutter.wkt pocket.wkt --anywhere -o fit.svg

minkref fit cutter.wkt pocket.wkt --between 2,2 7,2 --contact forbidden --json

minkref fit part.off housing.off --at 3,1/2,0

minkref fit part.off housing.off --anywhere

minkref fit disc pocket.wkt --between 2,2 7,2

minkref fit disc pocket.wkt --anywhere -o largest.svg

minkref fit cutter.wkt pocket.wkt --anywhere --clearance 1/2"""

TOLD = """\
Find all scales at which a part lies in a container: at a place, somewhere, or all along a
way between two places, by translations only; in space at a place, or somewhere. Exact, and found
again at, just below and just above each bound by static sums, in space by what the part's pieces
cover. With `disc` as the part, all radii, with the features that bound the largest disc. With
--clearance a part that keeps a distance: --at is exact, the others lie between two scales."""

Point = tuple[str, str]
Part = Annotated[str, typer.Argument(help="The part, scaled about its origin: a file or a model.")]
Container = Annotated[str, typer.Argument(help="What the part is to lie in: a file or a model.")]
AT = typer.Option("--at", help="With its origin at this place; X,Y,Z in space.", metavar="X,Y[,Z]")
At = Annotated[tuple[str, str] | None, AT, Read(read_point)]
AtInSpace = Annotated[tuple[str, str, str] | None, AT, Read(read_space_point)]
Anywhere = Annotated[bool, typer.Option("--anywhere", help="At some place.")]
Between = Annotated[
    tuple[Point, Point] | None,
    typer.Option(
        "--between", help="At both places and along a way between them.", metavar="X,Y X,Y"
    ),
    Read(read_points, tuple[str, str]),
]


Picture = Annotated[
    Path | None,
    typer.Option(
        "-o",
        help="Write the document to this .json file, or to an .svg a picture of the part at the "
        "greatest scale; - is standard output. In the plane.",
        metavar="FILE",
    ),
]


BracketWidth = Annotated[
    Fraction | None,
    typer.Option(
        "--tolerance",
        help="With --clearance: how far the two scales of the answer may be apart, as a share of "
        "them. Default: a billionth.",
        metavar="T",
    ),
    Read(read_tolerance),
]
OneScale = Annotated[
    Fraction | None,
    typer.Option(
        "--scale",
        help="With --clearance: answer for this scale only, for any part, with the clearances "
        "that it can keep.",
        metavar="S",
    ),
    Read(exact_scale),
]


@dataclass(frozen=True)
class FitInPlane:
    part: Part
    container: Container
    at: At = None
    anywhere: Anywhere = False
    between: Between = None
    contact: Contact = "allowed"
    clearance: Clearance = None
    tolerance: BracketWidth = None
    scale: OneScale = None
    output: Picture = None
    memory: Memory = None
    json: Json = False


@dataclass(frozen=True)
class FitOfDisc:
    part: Part
    container: Container
    at: At = None
    anywhere: Anywhere = False
    between: Between = None
    contact: Contact = "allowed"
    clearance: Clearance = None
    output: Picture = None
    memory: Memory = None
    json: Json = False


@dataclass(frozen=True)
class FitInSpace:
    part: Part
    container: Container
    at: AtInSpace = None
    anywhere: Anywhere = False
    contact: Contact = "allowed"
    memory: Memory = None
    json: Json = False


PLACE = "give --at X,Y,Z or --anywhere"
command = command_of(
    "fit",
    TOLD,
    {
        DISC: Verb(FitOfDisc, "minkref.motion.commands.disc_fit:run"),
        PLANE: Verb(FitInPlane, "minkref.motion.commands.fit:run"),
        SPACE: Verb(
            FitInSpace,
            "minkref.motion.commands.free_in_space:run_fit",
            why={"-o": "no picture is drawn", "--clearance": "there is no clearance in space"},
            instead={"--between": PLACE},
            code="not-in-space",
        ),
    },
)
