"""The options of `minkref union`, `intersection` and `difference`."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

import typer
from minkref.cli.memory import Memory
from minkref.cli.options import Json

Operands = Annotated[
    list[str],
    typer.Argument(
        help="Sets in the plane: files, models, the WKT or JSON texts themselves, or `-` for "
        "standard input. Polygons of one file may overlap or share edges: they are united first."
    ),
]
Output = Annotated[
    Path | None,
    typer.Option(
        "-o",
        help="Write the set to this file: .wkt, .geojson, .poly, .json, .svg, .dxf. `-`: print it "
        "alone on standard output.",
        metavar="FILE",
    ),
]
Format = Annotated[
    str | None,
    typer.Option(
        "--format",
        help="Format to write, whatever the name of the file ends in. Default for `-`: WKT.",
    ),
]
Plot = Annotated[
    bool, typer.Option("--plot", help="Draw a small picture of the set below the table.")
]
Proved = Annotated[
    bool,
    typer.Option(
        "--proved",
        help="By the program that is proved right in Coq (`make proofs` builds it). Says what is "
        "proved and what is trusted.",
    ),
]


CertifyUnion = Annotated[
    Path | None,
    typer.Option(
        "--certify",
        metavar="FILE",
        help="Write a proof of the union, and of what meets by chance "
        "(docs/certificates-unions.md), as FILE.cert.json or FILE.cert.json.gz, and its case "
        "beside it. It is checked first.",
    ),
]


@dataclass(frozen=True)
class SetRequest:
    operands: Operands
    output: Output = None
    form: Format = None
    plot: Plot = False
    proved: Proved = False
    memory: Memory = None
    json: Json = False


@dataclass(frozen=True)
class UnionRequest(SetRequest):
    certify: CertifyUnion = None
