"""`minkref index P Q -o FILE`: its options, in the plane and with a disc."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

import typer
from minkref.cli.memory import Memory
from minkref.cli.options import Erode, FirstOperand, GreatestScale, Json, LeastScale, SecondOperand
from minkref.cli.verb import Absent, Verb, command_of
from minkref.settings import DISC, PLANE, SPACE

EXAMPLES = """Examples:

minkref index disc1 cells1815 -o cells.index

minkref index glyph1204 glyph275 --from 1/10 --to 10 -o glyphs.index --json

minkref sum disc1 cells1815 --index cells.index --scale 7/5

minkref index glyph1204 disc -o diagram.json

minkref index g1 g2 --erode -o eroded.index"""

TOLD = """\
Find the boundary of the sum as a function of the scale: all its vertices, with the scales at
which they exist, in ring order. `sum`, `sweep`, `events` and `view` then read any sum of the
window off it, exactly, with --index FILE. With `disc` as second operand: the outer Voronoi
diagram of P, with all events, holes and components, as JSON: the same commands read the sum
with a disc of any radius off it."""

CHECKS = 3

Output = Annotated[
    Path,
    typer.Option("-o", help="The file to write, as FILE.index; of a disc .json.", metavar="FILE"),
]
Threads = Annotated[
    int | None,
    typer.Option("--threads", help="Threads of the build. Default: one per core.", metavar="N"),
]
Check = Annotated[
    int,
    typer.Option(
        "--check", help="Compare the sums at N scales with the static route.", metavar="N"
    ),
]


@dataclass(frozen=True)
class IndexInPlane:
    P: FirstOperand
    Q: SecondOperand
    output: Output
    from_scale: LeastScale = None
    to_scale: GreatestScale = None
    threads: Threads = None
    erode: Erode = False
    memory: Memory = None
    check: Check = CHECKS
    json: Json = False


@dataclass(frozen=True)
class IndexWithDisc:
    P: FirstOperand
    Q: SecondOperand
    output: Output
    threads: Threads = None
    erode: Erode = False
    memory: Memory = None
    json: Json = False


command = command_of(
    "index",
    TOLD,
    {
        PLANE: Verb(IndexInPlane, "minkref.plane.commands.index:run"),
        DISC: Verb(IndexWithDisc, "minkref.disc.commands.index:run"),
        SPACE: Absent(
            "there is no index in space",
            "`minkref events P Q --from A --to B` finds what happens at all scales of a window",
        ),
    },
)
