"""The options of `minkref erode`, `opening`, `closing`, `nofit` and `innerfit`."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

import typer
from minkref import _core
from minkref.cli.memory import Memory
from minkref.cli.options import ONE, Json, Scale, ScaleInPlane, ScaleInSpace, Triangles
from minkref.cli.verb import Absent, Verb
from minkref.plane.commands.scale_index import IndexFile
from minkref.scaling import Scaling
from minkref.settings import DISC, PLANE, SPACE, Setting
from minkref.verbs.sum import Outside, Tolerance

ROUTES = (*_core.ROUTES, "dynamic", "index")
DEFAULT = "paper"
SPACE_ROUTES = ("edges", "definition")
UNIT: Scaling = ("1", "1", "1")
DISC_ROUTES = ("definition", "paper")

Eroded = Annotated[
    str,
    typer.Argument(
        help="What is eroded, which is scaled: a file, a model, the WKT or JSON text itself, or "
        "`-` for standard input."
    ),
]
Eroding = Annotated[str, typer.Argument(help="What has to fit: given in the same ways.")]
Fixed = Annotated[
    str,
    typer.Argument(
        help="The fixed shape, which is scaled: a file, a model, the WKT or JSON text itself, or "
        "`-` for standard input."
    ),
]
Moving = Annotated[
    str, typer.Argument(help="The shape that is moved, never turned: given in the same ways.")
]
Container = Annotated[
    str,
    typer.Argument(
        help="What the part lies in, which is scaled: a file, a model, the WKT or JSON text "
        "itself, or `-` for standard input."
    ),
]
Part = Annotated[str, typer.Argument(help="The part, never turned: given in the same ways.")]
Output = Annotated[
    Path | None,
    typer.Option(
        "-o",
        help="Write the region to this file: .wkt, .geojson, .poly, .json, .svg, .dxf; with a disc "
        ".json, .svg and .dxf, and others with --tolerance; in space .off, .obj, .stl, .ply or "
        ".json. `-`: print it alone on standard output. Remnants and exact fits are in the .svg "
        "and in --json.",
        metavar="FILE",
    ),
]
Format = Annotated[
    str | None,
    typer.Option(
        "--format",
        help="Format to write, whatever the name of the file ends in. Default for `-`: WKT, "
        "with a disc JSON, in space OFF.",
    ),
]
OnlyRegion = Annotated[
    bool, typer.Option("--only-region", help="In an SVG, draw the region alone, without operands.")
]
Plot = Annotated[
    bool, typer.Option("--plot", help="Draw a small picture of the region below the table.")
]


Passages = Annotated[
    bool,
    typer.Option(
        "--passages",
        help="In space: find the remnants too, for operands of few convex pieces. In the plane "
        "they are always found.",
    ),
]
Route = Annotated[
    str | None,
    typer.Option(
        "--route",
        help=f"How the sum of the outside of P and -Q is computed: {', '.join(ROUTES)}. Default: "
        f"{DEFAULT}, or index with --index. With a disc: {' or '.join(DISC_ROUTES)}; in space "
        f"{' or '.join(SPACE_ROUTES)}. Default: {DISC_ROUTES[0]}, and {SPACE_ROUTES[0]}.",
    ),
]


@dataclass(frozen=True)
class ErodeInPlane:
    P: Eroded
    Q: Eroding
    scale: ScaleInPlane = ONE
    route: Route = None
    index: IndexFile = None
    output: Output = None
    form: Format = None
    only_region: OnlyRegion = False
    plot: Plot = False
    memory: Memory = None
    json: Json = False


@dataclass(frozen=True)
class ErodeWithDisc:
    P: Eroded
    Q: Eroding
    scale: Scale = ONE
    route: Route = None
    output: Output = None
    form: Format = None
    only_region: OnlyRegion = False
    tolerance: Tolerance = None
    outside: Outside = False
    memory: Memory = None
    json: Json = False


@dataclass(frozen=True)
class ErodeInSpace:
    P: Eroded
    Q: Eroding
    scale: ScaleInSpace = UNIT
    route: Route = None
    output: Output = None
    form: Format = None
    passages: Passages = False
    triangles: Triangles = False
    memory: Memory = None
    json: Json = False


@dataclass(frozen=True)
class ErodeWithBall:
    P: Eroded
    Q: Eroding
    scale: ScaleInSpace = UNIT
    output: Output = None
    form: Format = None
    tolerance: Tolerance = None
    outside: Outside = False
    triangles: Triangles = False
    memory: Memory = None
    json: Json = False


@dataclass(frozen=True)
class NoFitInSpace:
    A: Fixed
    B: Moving
    scale: ScaleInSpace = UNIT
    route: Route = None
    output: Output = None
    form: Format = None
    passages: Passages = False
    triangles: Triangles = False
    memory: Memory = None
    json: Json = False


@dataclass(frozen=True)
class InnerFitInSpace:
    container: Container
    part: Part
    scale: ScaleInSpace = UNIT
    route: Route = None
    output: Output = None
    form: Format = None
    passages: Passages = False
    triangles: Triangles = False
    memory: Memory = None
    json: Json = False


@dataclass(frozen=True)
class MorphologyRequest:
    """Openings and closings."""

    P: Eroded
    Q: Eroding
    scale: ScaleInPlane = ONE
    output: Output = None
    form: Format = None
    only_region: OnlyRegion = False
    plot: Plot = False
    memory: Memory = None
    json: Json = False


@dataclass(frozen=True)
class MorphologyWithDisc:
    P: Eroded
    Q: Eroding
    scale: Scale = ONE
    output: Output = None
    form: Format = None
    only_region: OnlyRegion = False
    tolerance: Tolerance = None
    outside: Outside = False
    memory: Memory = None
    json: Json = False


@dataclass(frozen=True)
class NoFitRequest:
    A: Fixed
    B: Moving
    scale: ScaleInPlane = ONE
    output: Output = None
    form: Format = None
    only_region: OnlyRegion = False
    plot: Plot = False
    memory: Memory = None
    json: Json = False


@dataclass(frozen=True)
class InnerFitRequest:
    container: Container
    part: Part
    scale: ScaleInPlane = ONE
    output: Output = None
    form: Format = None
    only_region: OnlyRegion = False
    plot: Plot = False
    memory: Memory = None
    json: Json = False


def morphology(command: str) -> dict[Setting, Verb | Absent]:
    """Make the table for an opening or a closing."""
    return {
        PLANE: Verb(MorphologyRequest, f"minkref.plane.commands.erode:run_{command}"),
        DISC: Verb(MorphologyWithDisc, f"minkref.disc.commands.closing:run_{command}"),
        SPACE: Verb(
            ErodeInSpace,
            f"minkref.space.commands.erode:run_{command}",
            why=dict.fromkeys(("--plot", "--only-region"), "no picture is drawn"),
        ),
    }


def without_disc(command: str, in_plane: type, in_space: type) -> dict[Setting, Verb | Absent]:
    """Make the table for a fit."""
    mend = "give two sets in the plane or in space; `minkref erode` and `minkref sum` take discs"
    return {
        PLANE: Verb(in_plane, f"minkref.plane.commands.erode:run_{command}"),
        DISC: Absent(f"`minkref {command}` takes polygons, no disc", mend),
        SPACE: Verb(
            in_space,
            f"minkref.space.commands.erode:run_{command}",
            why=dict.fromkeys(("--plot", "--only-region"), "no picture is drawn"),
        ),
    }
