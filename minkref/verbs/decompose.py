"""`minkref decompose P`: its options."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import Annotated

import typer
from minkref.cli.memory import Memory
from minkref.cli.options import Json
from minkref.cli.request import Read
from minkref.cli.verb import Verb, command_anywhere
from minkref.disc.disc import read_alpha, read_persistence, read_positive_alpha
from minkref.verbs.set_request import Format

READ_ALPHA = Read(read_alpha)
READ_POSITIVE_ALPHA = Read(read_positive_alpha)
EXAMPLES = """Examples:

minkref decompose g1

minkref decompose glyph1204 --alpha 1/2 --persistence 10 -o pieces.svg

minkref decompose P.wkt --from 1 --to 5 --persistence 2 --json

minkref decompose P.wkt --persistence inf"""

TOLD = """\
Cut a shape into pieces at its notches: the deepest reflex vertex of each feature that a growing
disc of the diameter alpha shows, if the feature lasts longer than the persistence. Each cut goes
to the nearest wall within the directions that leave no reflex corner at its notch. Exact; the
pieces tile the shape, and without options all are convex."""

Shape = Annotated[str, typer.Argument(help="A set in the plane: a file, a model, or its text.")]
Alpha = Annotated[
    Fraction | None,
    typer.Option(
        "--alpha",
        help="The disc's diameter at which features are taken, 0 or more. Default: 0, at which "
        "each reflex vertex is a feature.",
        metavar="A",
    ),
    READ_ALPHA,
]
Persistence = Annotated[
    str,
    typer.Option(
        "--persistence",
        help="Cut only at features whose bars are longer than this difference of diameters; `inf`: "
        "no cuts.",
        metavar="T",
    ),
    Read(read_persistence),
]
FirstAlpha = Annotated[
    Fraction | None,
    typer.Option(
        "--from",
        help="Take features at this diameter; only the part of their bars up to --to counts.",
        metavar="A",
    ),
    READ_ALPHA,
]
LastAlpha = Annotated[
    Fraction | None,
    typer.Option("--to", help="The largest diameter that counts.", metavar="B"),
    READ_ALPHA,
]
Output = Annotated[
    Path | None,
    typer.Option(
        "-o",
        help="Write the pieces to this file, as polygons that share edges: .wkt, .geojson, .json "
        "or .svg. `-`: print them alone on standard output.",
        metavar="FILE",
    ),
]


@dataclass(frozen=True)
class DecomposeRequest:
    P: Shape
    alpha: Alpha = None
    persistence: Persistence = "0"
    first: FirstAlpha = None
    last: LastAlpha = None
    output: Output = None
    form: Format = None
    memory: Memory = None
    json: Json = False


command = command_anywhere(TOLD, Verb(DecomposeRequest, "minkref.disc.commands.decompose:run"))
