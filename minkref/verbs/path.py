"""`minkref path PART OBSTACLES PATH`: its options, in the plane and in space."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import Annotated

import typer
from minkref.cli.memory import Memory
from minkref.cli.options import GreatestScale, Json, LeastScale
from minkref.cli.request import Read
from minkref.cli.verb import Verb, command_of
from minkref.disc.disc import read_clearance
from minkref.errors import Refusal, choice
from minkref.settings import DISC, PLANE, SPACE

EXAMPLES = """Examples:

minkref path disc1 g2 "LINESTRING (-60 55, 60 55)"

minkref path part.wkt obstacles.wkt way.csv --contact forbidden --json

minkref path part.wkt obstacles.wkt way.geojson --route contacts -o valid.json

minkref path part.wkt obstacles.wkt way.geojson -o valid.svg

minkref path rod gs3 "LINESTRING Z (0 0 9, 0 0 0, 9 1/2 0)"

minkref path part.off obstacles.stl way.csv --contact forbidden --to 2

minkref path part.wkt obstacles.wkt way.csv --certify valid.cert.json

minkref path disc obstacles.wkt way.csv --clearance 1/2"""

TOLD = """\
Find all scales at which a part passes along a polyline without a collision: its origin moves
on the path, and it never turns. In the plane or in space. Exact: intervals with open and closed
ends, single scales, and for each bound the contact that causes it. With `disc` as the part, all
radii at which a disc passes; with --clearance a part that keeps a distance."""

Part = Annotated[str, typer.Argument(help="The part, scaled about its origin: a file or a model.")]
Obstacles = Annotated[str, typer.Argument(help="What it must not meet: a file or a model.")]
Contact = Annotated[
    str,
    typer.Option(
        "--contact", help="allowed: the part may touch; forbidden: it may not.", metavar="RULE"
    ),
]
PathText = Annotated[
    str,
    typer.Argument(
        help="Polyline of the part's origin: WKT, GeoJSON or CSV, file or text; in space with "
        "three coordinates."
    ),
]
Route = Annotated[
    str,
    typer.Option(
        "--route", help="pieces, contacts or index; in space the first two.", metavar="ROUTE"
    ),
]
Output = Annotated[
    Path | None,
    typer.Option(
        "-o",
        help="Write the document to this .json file, or to an .svg the diagram of places and "
        "scales that collide; - is standard output.",
        metavar="FILE",
    ),
]
Certify = Annotated[
    Path | None,
    typer.Option(
        "--certify",
        help="Write a proof of the whole answer: FILE.cert.json or FILE.cert.json.gz, its case "
        "beside it (docs/certificates-paths.md). It is checked before it is written.",
        metavar="FILE",
    ),
]
Clearance = Annotated[
    Fraction | None,
    typer.Option(
        "--clearance",
        help="The distance that the part has to keep: more than 0. In the plane or with a disc.",
        metavar="C",
    ),
    Read(read_clearance),
]


@dataclass(frozen=True)
class PathInPlane:
    part: Part
    obstacles: Obstacles
    path: PathText
    contact: Contact = "allowed"
    clearance: Clearance = None
    from_scale: LeastScale = None
    to_scale: GreatestScale = None
    route: Route = "pieces"
    output: Output = None
    certify: Certify = None
    memory: Memory = None
    json: Json = False


@dataclass(frozen=True)
class PathOfDisc:
    part: Part
    obstacles: Obstacles
    path: PathText
    contact: Contact = "allowed"
    clearance: Clearance = None
    output: Output = None
    memory: Memory = None
    json: Json = False


@dataclass(frozen=True)
class PathInSpace:
    part: Part
    obstacles: Obstacles
    path: PathText
    contact: Contact = "allowed"
    from_scale: LeastScale = None
    to_scale: GreatestScale = None
    route: Route = "pieces"
    output: Output = None
    memory: Memory = None
    json: Json = False


command = command_of(
    "path",
    TOLD,
    {
        DISC: Verb(
            PathOfDisc,
            "minkref.motion.commands.disc_path:run",
            why={"--certify": "there is no certificate of a disc's path"},
        ),
        PLANE: Verb(PathInPlane, "minkref.motion.commands.path:run"),
        SPACE: Verb(
            PathInSpace,
            "minkref.motion.commands.path:run_in_space",
            why={
                "--certify": "there is no certificate in space",
                "--clearance": "there is no clearance in space",
            },
        ),
    },
)


def check_words(**options: tuple[str, tuple[str, ...]]) -> None:
    """Refuses an option whose word is none of those that it knows."""
    for name, (word, known) in options.items():
        if word not in known:
            raise Refusal(
                f"there is no {name} of this name", f"--{name} {word}", choice(word, known)
            )
