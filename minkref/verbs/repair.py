"""`minkref repair FILE`: its options."""

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
from minkref.errors import Refusal
from minkref.exact import read_number
from minkref.verbs.set_request import Format

EXAMPLES = """Examples:

minkref repair parcels.geojson -o repaired.geojson

minkref repair drawing.wkt --rule evenodd --weld 1/1000 -o repaired.json

minkref repair part.dxf --tolerance 1/100 --layer CUT -o part.json

minkref repair body.stl --weld 1e-9 -o body.off

minkref repair scan.ply --json"""

TOLD = """\
Make an operand of a file with faults, exactly, and list every change with its place and size.
Nothing else changes; a file without faults stays unchanged, and a repaired file needs no repair.
In the plane: open rings, spikes, repeated points, rings that cross or touch themselves, holes
outside, polygons that overlap; curves of drawings. In space: equal vertices, faces without area, in
no plane or twice, shells inside out, bodies that touch along an edge. Without -o the changes are
only listed. docs/repair.md has the order and what each change does."""


def read_distance(text: str, option: str) -> Fraction:
    """Read a distance above 0, exactly."""
    mend = "give a number above 0, as 1/1000 or 1e-9"
    value = read_number(text.strip(), "distance", f"{option} {text[:40]}", mend)
    if value <= 0:
        raise Refusal("the distance is not above 0", f"{option} {text[:40]}", mend)
    return value


File = Annotated[
    str,
    typer.Argument(help="A set in the plane or a polyhedron: a file, a model, or a set's text."),
]
Output = Annotated[
    Path | None,
    typer.Option(
        "-o",
        help="Write the operand to this file: .wkt, .geojson, .poly or .json; in space .off, .obj, "
        ".stl, .ply or .json. `-`: print it alone on standard output.",
        metavar="FILE",
    ),
]
Weld = Annotated[
    Fraction | None,
    typer.Option(
        "--weld",
        help="Make vertices nearer than this distance one: the first of them in the file. Exact: "
        "1/1000, 1e-9.",
        metavar="T",
    ),
    Read(read_distance),
]
Rule = Annotated[
    str,
    typer.Option(
        "--rule",
        help="Where a ring that crosses itself, or a shell in another one, has material: where it "
        "winds around a point (nonzero), an odd number of times (evenodd), or so that the number "
        "is positive (positive).",
    ),
]


Tolerance = Annotated[
    Fraction | None,
    typer.Option(
        "--tolerance",
        help="For a drawing (.dxf, .svg) with arcs or curves: how far polylines may be off them.",
        metavar="T",
    ),
    Read(read_distance),
]
Layer = Annotated[
    str | None, typer.Option("--layer", help="Of a drawing: read this layer alone.", metavar="NAME")
]


@dataclass(frozen=True)
class RepairRequest:
    file: File
    output: Output = None
    form: Format = None
    weld: Weld = None
    rule: Rule = "nonzero"
    tolerance: Tolerance = None
    layer: Layer = None
    memory: Memory = None
    json: Json = False


command = command_anywhere(TOLD, Verb(RepairRequest, "minkref.verbs.repair_output:run"))
