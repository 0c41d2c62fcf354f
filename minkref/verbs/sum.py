"""`minkref sum P Q`: its options, in the plane, with a disc and in space."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import Annotated

import typer
from minkref import _core
from minkref.cli.memory import Memory
from minkref.cli.options import ONE, READ_SCALE, Json, Scale, ScaleInPlane, ScaleInSpace, Triangles
from minkref.cli.readings import ROUTE as PAPER_UPDATE
from minkref.cli.readings import Form, Reading
from minkref.cli.request import Read
from minkref.cli.verb import Verb, command_of
from minkref.disc.disc import read_tolerance
from minkref.exact import read_point, read_points, read_space_point
from minkref.plane.commands.scale_index import IndexFile
from minkref.plane.proved_sum import ROUTE as PROVED
from minkref.settings import BALL, DISC, PLANE, SPACE
from minkref.space.general_sum import GENERAL_ROUTES
from minkref.space.scaling import UNIT
from minkref.space.sums import ROUTES as SPACE_ROUTES

EXAMPLES = """Examples:

minkref sum glyph1204 glyph275

minkref sum disc1 cells1815 --scale 541/186 --json

minkref sum P.wkt Q.geojson --scale 7/5 -o sum.svg

minkref sum g1 g2 --scale 2,1/3

minkref sum g1 o1 --plot

minkref sum "POLYGON ((0 0, 2 0, 0 2, 0 0))" g1 -o -

cat P.wkt | minkref sum - Q.wkt --scale 7/5 -o - --format geojson

minkref sum g1 g2 --scale 7/5 --route winding --from 1

minkref sum g1 g2 --scale 7/5 --route proved

minkref sum g1 g2 --arithmetic mpfr:53

minkref sum g1 g2 --route paper-update --arithmetic mpfr:200 --reading observation=corrected

minkref sum cup.off plate.off --route paper-update --arithmetic double

minkref sum disc1 cells1815 --index cells.index --scale 7/5

minkref sum gs3 rod --scale 2,1/3,5 -o sum.off

minkref sum cup.stl plate.stl --at 1,2/3,0

minkref sum cup.stl plate.stl --scale 3/2 -o sum.stl

minkref sum cup.stl plate.stl -o sum.ply --triangles

minkref sum cup.stl ball:1/2 --tolerance 1/20 -o grown.stl

minkref sum g1 disc:7/5 -o offset.svg

minkref sum g1 disc:7/5 --route paper

minkref sum g1 disc:7/5 --route paper-update --arithmetic double --reading line=corrected

minkref sum g1 disc:7/5 --measures --json

minkref sum g1 disc:7/5 --certify grown.cert.json

minkref sum P.wkt disc:sqrt:2 --scale 3/2 -o offset.wkt --tolerance 1/1000"""

TOLD = """\
The Minkowski sum of P, scaled by S about the origin, and Q: exact, in canonical form, and
    its tight passages. One of the two may be a disc about the origin, as disc:7/5 or disc:sqrt:2:
    the sum has arcs then. In space P and Q are polyhedra of any shape (.off, .obj, .stl, .ply,
    .json); one may be a plane polygon, a segment or a point, or a ball about the origin, as
    ball:7/5: two polyhedral sets then enclose the sum. In another arithmetic, or by the
    paper's own program (--route paper-update), what these answer, with the exact sum beside it."""

ROUTES = (*_core.ROUTES, "dynamic", "index", PROVED, PAPER_UPDATE)
DEFAULT = "paper"
UPDATING = ("dynamic", "winding")  # follow a convolution from --from to --scale

First = Annotated[
    str,
    typer.Argument(
        help="First operand, which is scaled: a file, a model, the WKT or JSON text itself, "
        "or `-` for standard input."
    ),
]
Second = Annotated[str, typer.Argument(help="Second operand: given in the same ways.")]
Route = Annotated[
    str | None,
    typer.Option(
        "--route",
        help=f"How it is computed: {', '.join(ROUTES)}. Default: {DEFAULT}, or index with "
        f"--index. In space: {', '.join(GENERAL_ROUTES)}, and of convex polyhedra also "
        f"{', '.join(SPACE_ROUTES)}. Default: {SPACE_ROUTES[0]} for these, else "
        f"{GENERAL_ROUTES[0]}; of solids also {PAPER_UPDATE}. With a disc: definition (the "
        f"default), paper, index or {PAPER_UPDATE}.",
    ),
]
Start = Annotated[
    Fraction | None,
    typer.Option(
        "--from",
        help="Begin with the sum at this scale, and follow all events up or down to --scale "
        f"(--route {' or '.join(UPDATING)}).",
        metavar="A",
    ),
    READ_SCALE,
]
Arithmetic = Annotated[
    str,
    typer.Option(
        "--arithmetic",
        help="rational (exact), interval, double or mpfr:BITS. All but the first report "
        "their own result next to the true one.",
    ),
]
Output = Annotated[
    Path | None,
    typer.Option(
        "-o",
        help="Write the sum to this file: .wkt, .geojson, .poly, .json, .svg or .dxf; "
        "in space .off, .obj, .stl, .ply or .json. `-`: print the sum alone on "
        "standard output.",
        metavar="FILE",
    ),
]
Format = Annotated[
    str | None,
    typer.Option(
        "--format",
        help="Format to write, whatever the name of the file ends in. Default for `-`: WKT, "
        "in space OFF.",
    ),
]
OnlySum = Annotated[
    bool, typer.Option("--only-sum", help="In an SVG, draw the sum alone, without P and Q.")
]
Plot = Annotated[
    bool, typer.Option("--plot", help="Draw a small picture of the sum below the table.")
]
Passages = Annotated[
    bool,
    typer.Option(
        "--passages",
        help="In space: find the tight passages too, for operands of few convex pieces. In the "
        "plane they are always found.",
    ),
]
Tolerance = Annotated[
    Fraction | None,
    typer.Option(
        "--tolerance",
        help="With a disc, in formats without arcs: write a polygon inside of the answer, all "
        "points of which are within this of it; of an erosion those where a disc larger by this "
        "has room. With a ball: how far the polyhedra inside it and around it may be off.",
        metavar="T",
    ),
    Read(read_tolerance),
]
Outside = Annotated[
    bool,
    typer.Option(
        "--outside", help="The polygon or polyhedron that --tolerance asks for contains the answer."
    ),
]
Measures = Annotated[
    bool,
    typer.Option(
        "--measures", help="With a disc and --json: length and area exact, as sums of terms."
    ),
]

Certify = Annotated[
    Path | None,
    typer.Option(
        "--certify",
        metavar="FILE",
        help="With a disc: write a proof of the sum (docs/certificates-disc.md) as FILE.cert.json "
        "or FILE.cert.json.gz, and its case beside it. It is checked first.",
    ),
]
Points = Annotated[
    list[tuple[str, str]] | None,
    typer.Option(
        "--point",
        metavar="X,Y",
        help="With --certify: prove too whether this point is in the sum; may be repeated.",
    ),
    Read(read_points, list[str]),
]

AT = typer.Option(
    "--at", help="Say where this point lies: inside, on the boundary or outside.", metavar="X,Y[,Z]"
)
At = Annotated[tuple[str, str] | None, AT, Read(read_point)]
AtInSpace = Annotated[tuple[str, str, str] | None, AT, Read(read_space_point)]


@dataclass(frozen=True)
class SumInPlane:
    P: First
    Q: Second
    scale: ScaleInPlane = ONE
    route: Route = None
    start: Start = None
    index: IndexFile = None
    arithmetic: Arithmetic = "rational"
    as_read: Form = None
    reading: Reading = None
    output: Output = None
    form: Format = None
    only_sum: OnlySum = False
    plot: Plot = False
    passages: Passages = False  # they are found in any case
    at: At = None
    memory: Memory = None
    json: Json = False


@dataclass(frozen=True)
class SumInSpace:
    P: First
    Q: Second
    scale: ScaleInSpace = UNIT
    route: Route = None
    arithmetic: Arithmetic = "rational"
    as_read: Form = None
    reading: Reading = None
    output: Output = None
    form: Format = None
    passages: Passages = False
    triangles: Triangles = False
    at: AtInSpace = None
    memory: Memory = None
    json: Json = False


@dataclass(frozen=True)
class SumWithDisc:
    P: First
    Q: Second
    scale: Scale = ONE
    route: Route = None
    index: IndexFile = None
    arithmetic: Arithmetic = "rational"
    as_read: Form = None
    reading: Reading = None
    output: Output = None
    form: Format = None
    only_sum: OnlySum = False
    tolerance: Tolerance = None
    outside: Outside = False
    measures: Measures = False
    certify: Certify = None
    points: Points = None
    memory: Memory = None
    json: Json = False


@dataclass(frozen=True)
class SumWithBall:
    P: First
    Q: Second
    scale: ScaleInSpace = UNIT
    output: Output = None
    form: Format = None
    tolerance: Tolerance = None
    outside: Outside = False
    triangles: Triangles = False
    at: AtInSpace = None
    memory: Memory = None
    json: Json = False


command = command_of(
    "sum",
    TOLD,
    {
        PLANE: Verb(SumInPlane, "minkref.plane.commands.sum:run"),
        SPACE: Verb(
            SumInSpace,
            "minkref.space.commands.sum:run",
            why=dict.fromkeys(("--plot", "--only-sum"), "no picture is drawn"),
            instead=dict.fromkeys(("--plot", "--only-sum"), "see `minkref view P Q`"),
        ),
        DISC: Verb(SumWithDisc, "minkref.disc.commands.sum:run"),
        BALL: Verb(SumWithBall, "minkref.space.commands.ball:run_sum"),
    },
)
