"""Options that several commands have in common."""

from __future__ import annotations

import sys
from fractions import Fraction
from typing import Annotated

import typer
from minkref.cli.request import Read
from minkref.exact import exact_scale
from minkref.scaling import PlaneScale, Scaling, read_plane_scale, read_scaling
from minkref.schemas import schema_text


def _print_schema(context: typer.Context, wanted: bool) -> None:
    if wanted:
        above = context.parent
        group = f"{above.info_name}_" if above is not None and above.parent is not None else ""
        sys.stdout.write(schema_text(f"{group}{context.info_name}"))
        raise typer.Exit


FirstOperand = Annotated[
    str, typer.Argument(help="First operand, which is scaled: a file or a model.")
]
SecondOperand = Annotated[str, typer.Argument(help="Second operand: a file or a model.")]
FROM = typer.Option(
    "--from", help="Smallest scale, included. Default: every scale above 0.", metavar="A"
)
TO = typer.Option("--to", help="Largest scale, included. Default: no end.", metavar="B")
SCALE = typer.Option(
    "--scale",
    help="Scale of P, exact: 3, 7/5, 0.25. Or a factor for each axis: SX,SY in the plane, SX,SY,SZ "
    "in space.",
    metavar="S",
)
READ_SCALE = Read(exact_scale)
LeastScale = Annotated[Fraction | None, FROM, READ_SCALE]
GreatestScale = Annotated[Fraction | None, TO, READ_SCALE]
Scale = Annotated[Fraction, SCALE, READ_SCALE]
ScaleInPlane = Annotated[PlaneScale, SCALE, Read(read_plane_scale)]
ScaleInSpace = Annotated[Scaling, SCALE, Read(read_scaling)]
ONE = Fraction(1)
Erode = Annotated[
    bool,
    typer.Option(
        "--erode",
        help="The erosion of the scaled P by Q instead of the sum: what `minkref erode` leaves at "
        "each scale. Not in space.",
    ),
]
Triangles = Annotated[
    bool,
    typer.Option(
        "--triangles",
        help="In space: write meshes of triangles that every reader takes: each edge has two, by "
        "the numbers of its vertices.",
    ),
]
Json = Annotated[
    bool,
    typer.Option("--json", help="Print one JSON document, and nothing else, on standard output."),
]
Schema = Annotated[
    bool,
    typer.Option(
        "--schema",
        callback=_print_schema,
        is_eager=True,
        help="Print the JSON schema of what --json prints.",
    ),
]
