"""`minkref trap PART OBSTACLES --at X,Y`: its options, in the plane and in space."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Annotated

import typer
from minkref.cli.memory import Memory
from minkref.cli.options import GreatestScale, Json, LeastScale
from minkref.cli.request import Read
from minkref.cli.verb import Verb, command_of
from minkref.exact import read_point, read_space_point
from minkref.settings import DISC, PLANE, SPACE
from minkref.verbs.fit import BracketWidth, OneScale, Part, Picture
from minkref.verbs.path import Certify, Clearance, Contact

EXAMPLES = """Examples:

minkref trap ball.wkt cage.wkt --at 2,2

minkref trap ball.wkt cage.wkt --at 2,2 -o trap.svg

minkref trap ball.wkt cage.wkt --at 2,2 --contact forbidden --from 1/2 --to 4 --json

minkref trap ball.wkt cage.wkt --at 2,2 --certify trap.cert.json

minkref trap ball.off cage.off --at 2,2,0

minkref trap disc cage.wkt --at 2,2

minkref trap ball.wkt cage.wkt --at 2,2 --clearance 1/2"""

TOLD = """\
Find all scales at which a part is free at a place, and no translation takes it away from the
obstacles. A rotation may free it all the same: "trapped" is by translations only. Exact, and
found again at, just below and just above each bound by static sums. In space the part has to be
star-shaped about its origin. With `disc` as the part, all radii, with the neck that holds it.
With --clearance a part that keeps a distance: trapped from a scale on that is between two
scales."""

Obstacles = Annotated[str, typer.Argument(help="What may hold the part: a file or a model.")]
AT = typer.Option("--at", help="Where the part's origin is; X,Y,Z in space.", metavar="X,Y[,Z]")
At = Annotated[tuple[str, str], AT, Read(read_point)]
AtInSpace = Annotated[tuple[str, str, str], AT, Read(read_space_point)]


@dataclass(frozen=True)
class Trap:
    part: Part
    obstacles: Obstacles
    at: At
    contact: Contact = "allowed"
    clearance: Clearance = None
    tolerance: BracketWidth = None
    scale: OneScale = None
    from_scale: LeastScale = None
    to_scale: GreatestScale = None
    output: Picture = None
    certify: Certify = None
    memory: Memory = None
    json: Json = False


@dataclass(frozen=True)
class TrapOfDisc:
    part: Part
    obstacles: Obstacles
    at: At
    contact: Contact = "allowed"
    clearance: Clearance = None
    output: Picture = None
    memory: Memory = None
    json: Json = False


@dataclass(frozen=True)
class TrapInSpace:
    part: Part
    obstacles: Obstacles
    at: AtInSpace
    contact: Contact = "allowed"
    from_scale: LeastScale = None
    to_scale: GreatestScale = None
    memory: Memory = None
    json: Json = False


command = command_of(
    "trap",
    TOLD,
    {
        DISC: Verb(
            TrapOfDisc,
            "minkref.motion.commands.disc_trap:run",
            why={"--certify": "there is no certificate of a disc's trap"},
        ),
        PLANE: Verb(Trap, "minkref.motion.commands.trap:run"),
        SPACE: Verb(
            TrapInSpace,
            "minkref.motion.commands.free_in_space:run_trap",
            why={
                "--certify": "there is no certificate in space",
                "--clearance": "there is no clearance in space",
                "-o": "no picture is drawn",
            },
        ),
    },
)
