"""`minkref convolution P Q`: its options, in the plane and in space."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

import typer
from minkref.cli.memory import Memory
from minkref.cli.options import (
    ONE,
    FirstOperand,
    Json,
    Scale,
    ScaleInPlane,
    ScaleInSpace,
    SecondOperand,
    Triangles,
)
from minkref.cli.verb import Verb, command_of
from minkref.plane.convolution_values import COMPATIBLE
from minkref.settings import DISC, PLANE, SPACE
from minkref.space.scaling import UNIT

EXAMPLES = """Examples:

minkref convolution disc1 cells1815

minkref convolution g1 g2 --scale 7/5 -o convolution.svg

minkref convolution g1 g2 --scale 2,1/3

minkref convolution g1 g2 --full -o convolution.geojson

minkref convolution P.wkt Q.geojson --scale 541/186 -o - --format json

minkref convolution g1 o1 --compatible closed --json

minkref convolution g1 disc:7/5 --json

minkref convolution gs3 rod --scale 2,1/3,5 -o facets.ply"""

TOLD = """\
The convolution of P, scaled by S about the origin, and Q: every edge of the one at each
compatible vertex of the other, with its parents. Exact. With a disc: the edges moved outwards by
the radius, and the arcs about convex vertices. Of convex polyhedra: the facets of the sum, with
theirs."""

Full = Annotated[
    bool,
    typer.Option(
        "--full/--reduced",
        help="Full: also the edges at reflex vertices, of the sign -1. Reduced: those at "
        "strictly convex vertices only.",
    ),
]
Compatible = Annotated[
    str,
    typer.Option(
        "--compatible",
        help="Which ends of the turn at a vertex belong to it, for edges of P and Q in one "
        "direction: half-open, which is right; open, which may lose parts of the sum's "
        "boundary; closed, which covers parts twice.",
    ),
]
Limit = Annotated[
    int | None,
    typer.Option(
        "--limit", help="List or draw only the first N edges; all are counted.", metavar="N"
    ),
]
Output = Annotated[
    Path | None,
    typer.Option(
        "-o",
        help="Write the convolution to this file: .json, .geojson (an edge is a LineString) or "
        ".svg; in space .json, .off or .ply. `-`: print it alone on standard output.",
        metavar="FILE",
    ),
]
Format = Annotated[
    str | None,
    typer.Option(
        "--format",
        help="Format to write, whatever the name of the file ends in. Default for `-`: json.",
    ),
]


@dataclass(frozen=True)
class ConvolutionInPlane:
    P: FirstOperand
    Q: SecondOperand
    scale: ScaleInPlane = ONE
    full: Full = False
    compatible: Compatible = COMPATIBLE[0]
    limit: Limit = None
    output: Output = None
    form: Format = None
    memory: Memory = None
    json: Json = False


@dataclass(frozen=True)
class ConvolutionWithDisc:
    P: FirstOperand
    Q: SecondOperand
    scale: Scale = ONE
    limit: Limit = None
    output: Output = None
    form: Format = None
    memory: Memory = None
    json: Json = False


@dataclass(frozen=True)
class ConvolutionInSpace:
    P: FirstOperand
    Q: SecondOperand
    scale: ScaleInSpace = UNIT
    output: Output = None
    form: Format = None
    triangles: Triangles = False
    memory: Memory = None
    json: Json = False


command = command_of(
    "convolution",
    TOLD,
    {
        PLANE: Verb(ConvolutionInPlane, "minkref.plane.commands.convolution:run"),
        DISC: Verb(
            ConvolutionWithDisc,
            "minkref.disc.commands.convolution:run",
            why={
                "--full": "only the reduced convolution is listed",
                "--compatible": "a disc has no edges in a direction of P's",
            },
        ),
        SPACE: Verb(
            ConvolutionInSpace,
            "minkref.space.commands.convolution:run",
            why={
                "--full": "convex polyhedra have no reflex edges",
                "--compatible": "ties are broken in one way only",
                "--limit": "all facets are given",
            },
        ),
    },
)
