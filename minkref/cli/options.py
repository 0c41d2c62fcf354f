"""Options that several commands have in common."""

from __future__ import annotations

import sys
from typing import Annotated

import typer
from minkref.errors import Refusal
from minkref.schemas import schema_text


def _print_schema(context: typer.Context, wanted: bool) -> None:
    if wanted:
        above = context.parent
        group = f"{above.info_name}_" if above is not None and above.parent is not None else ""
        sys.stdout.write(schema_text(f"{group}{context.info_name}"))
        raise typer.Exit


def refuse_triangles(wanted: bool) -> None:
    """For sums in the plane."""
    if wanted:
        raise Refusal("no mesh is written in the plane", "--triangles", "leave it out")


FirstOperand = Annotated[
    str, typer.Argument(help="First operand, which is scaled: a file or a model.")
]
SecondOperand = Annotated[str, typer.Argument(help="Second operand: a file or a model.")]
WindowFrom = Annotated[
    str | None,
    typer.Option(
        "--from", help="Smallest scale, included. Default: every scale above 0.", metavar="A"
    ),
]
WindowTo = Annotated[
    str | None, typer.Option("--to", help="Largest scale, included. Default: no end.", metavar="B")
]
Scale = Annotated[
    str,
    typer.Option(
        "--scale", help="Scale of P, exact: 3, 7/5, 0.25; in space also SX,SY,SZ.", metavar="S"
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
