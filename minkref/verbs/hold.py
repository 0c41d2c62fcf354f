"""`minkref hold PART OBSTACLES WAY`: its options, in the plane and in space."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

import typer
from minkref.cli.verb import Verb, command_of
from minkref.settings import PLANE, SPACE
from minkref.verbs.path import PathInPlane, PathInSpace

EXAMPLES = """Examples:

minkref hold pin.wkt assembly.wkt "LINESTRING (2 2, 2 0, 9 0)"

minkref hold pin.wkt assembly.wkt way.csv --contact forbidden --json

minkref hold pin.wkt assembly.wkt way.geojson -o held.svg

minkref hold pin.wkt assembly.wkt way.wkt --certify held.cert.json

minkref hold part.off assembly.off "LINESTRING Z (0 0 0, 0 0 9)" --json"""

TOLD = """\
Find all scales at which obstacles hold a part: the part fits at the way's first vertex, and the
given way out is blocked. In the plane or in space. Exact: the scales that fit, those of the way,
those that are held, and the contacts that cause them. Another way may still be open: `minkref trap`
asks for all ways."""

Holding = Annotated[str, typer.Argument(help="What may hold the part: a file or a model.")]
Way = Annotated[
    str,
    typer.Argument(
        help="The way out, a polyline of the part's origin from its place on: WKT, GeoJSON or CSV, "
        "file or text; in space with three coordinates.",
        metavar="way",
    ),
]
Certify = Annotated[
    Path | None,
    typer.Option(
        "--certify",
        help="Write two proofs, FILE-place.cert.json and FILE-way.cert.json (or .cert.json.gz), "
        "their cases beside them (docs/certificates-paths.md). They are checked before they are "
        "written.",
        metavar="FILE",
    ),
]


@dataclass(frozen=True)
class HoldInPlane(PathInPlane):
    obstacles: Holding
    path: Way
    certify: Certify = None


@dataclass(frozen=True)
class HoldInSpace(PathInSpace):
    obstacles: Holding
    path: Way


command = command_of(
    "hold",
    TOLD,
    {
        PLANE: Verb(HoldInPlane, "minkref.motion.commands.hold:run"),
        SPACE: Verb(
            HoldInSpace,
            "minkref.motion.commands.hold:run_in_space",
            why={"--certify": "there is no certificate in space"},
        ),
    },
)
