"""`minkref features P`: its options."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import Annotated

import typer
from minkref.cli.memory import Memory
from minkref.cli.options import Json
from minkref.cli.verb import Verb, command_anywhere
from minkref.plane.commands.scale_index import IndexFile
from minkref.verbs.decompose import READ_ALPHA, READ_POSITIVE_ALPHA

EXAMPLES = """Examples:

minkref features glyph1204

minkref features glyph1204 --alpha 5

minkref features g1 --from 1/2 --to 3 --json

minkref features glyph1204 --alpha 5 -o bridges.svg

minkref features glyph1204 --alpha 5 -o bridges.dxf

minkref features glyph1204 --alpha 5 --regions --rest -o rest.svg

minkref features g1 --alpha 1 --certify bridges.cert.json"""

TOLD = """\
The concave features of a set under a growing disc: where bays, corridors and holes of a diameter
alpha begin and become one, as a merge tree and a barcode, exact; at one alpha the bridges that
close each feature."""

Operand = Annotated[str, typer.Argument(help="A set in the plane: a file or a model.")]
Alpha = Annotated[
    Fraction | None,
    typer.Option("--alpha", help="Show the features at this diameter, with bridges.", metavar="A"),
    READ_POSITIVE_ALPHA,
]
Regions = Annotated[
    bool, typer.Option("--regions", help="With --alpha: the region of each feature, and its area.")
]
Rest = Annotated[
    bool,
    typer.Option(
        "--rest", help="With --alpha: what a closing with the disc adds to the set, and its area."
    ),
]
FirstAlpha = Annotated[
    Fraction | None,
    typer.Option("--from", help="Only bars that go on beyond this diameter.", metavar="A0"),
    READ_ALPHA,
]
LastAlpha = Annotated[
    Fraction | None,
    typer.Option("--to", help="Only bars that begin before this diameter.", metavar="A1"),
    READ_ALPHA,
]
Output = Annotated[
    Path | None,
    typer.Option(
        "-o",
        help="Write FILE.json (all of it, exact), .svg (the set and the barcode, regions and rest) "
        "or, with --alpha, .dxf (the bridges).",
        metavar="FILE",
    ),
]
Format = Annotated[
    str | None, typer.Option("--format", help="Format of the file: json, svg or dxf.", metavar="F")
]

Certify = Annotated[
    Path | None,
    typer.Option(
        "--certify",
        help="With --alpha: write a proof of the bridges (docs/certificates-features.md) as "
        "FILE.cert.json or FILE.cert.json.gz, and its case beside it.",
        metavar="FILE",
    ),
]


@dataclass(frozen=True)
class FeaturesRequest:
    P: Operand
    alpha: Alpha = None
    regions: Regions = False
    rest: Rest = False
    from_alpha: FirstAlpha = None
    to_alpha: LastAlpha = None
    output: Output = None
    form: Format = None
    index: IndexFile = None
    certify: Certify = None
    memory: Memory = None
    json: Json = False


command = command_anywhere(TOLD, Verb(FeaturesRequest, "minkref.disc.commands.features:run"))
