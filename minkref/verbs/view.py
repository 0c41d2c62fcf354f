"""`minkref view P Q`: its options, in the plane, with a disc, with a path, in space, for a scene
and for features."""

from __future__ import annotations

from dataclasses import dataclass
from fractions import Fraction
from pathlib import Path
from typing import Annotated

import typer
from minkref.cli.memory import Memory
from minkref.cli.options import READ_SCALE, Erode, FirstOperand, Json, SecondOperand
from minkref.cli.readings import ROUTE as PAPER_UPDATE
from minkref.cli.readings import Form, Reading
from minkref.cli.request import Read
from minkref.cli.verb import Verb, command_of
from minkref.output.output_target import Target, target_of
from minkref.plane.commands.scale_index import IndexFile
from minkref.settings import DISC, FEATURES, MOTION, PLANE, SCENE, SPACE
from minkref.space.scaling import Scaling, read_scaling
from minkref.verbs.paper_options import MOST_STEPS, STEPS
from minkref.verbs.scene import Copies

EXAMPLES = """Examples:

minkref view disc1 cells1815

minkref view g1 g2 --from 1/2 --to 2 -o g1-g2.html

minkref view g1 g2 --route paper-update --arithmetic double -o paper.html

minkref view glyph1204 disc -o grown.html

minkref view g1 g2 --erode --to 20 -o eroded.html

minkref view glyph1204 --features -o features.html

minkref view disc1 g2 --path "LINESTRING (-60 55, 60 55)" -o way.html

minkref view gs3 rod --scale 2,1/3,5 -o gs3-rod.html

minkref view gs3 rod --scales scales.txt -o gs3-rod.html

minkref view office.json -o office.html"""

TOLD = """\
Write one self-contained HTML page with a slider over the scale: the sum, its convolution,
and the holes from birth to death. In space P and Q are polyhedra: the page shows the sum at
each scale, lets you turn it and cut it open, and names the parents of its facets and
vertices. With `disc` as second operand the slider is the radius of a disc. With --features P
stands alone, and the page shows its concave features at any diameter of a disc. With --path the
page shows a part on a path: the scales at which it passes, and why at no others. A scene alone
has a page on which its copies are dragged and scaled, with the robot's free places."""

FROM, TO = "1/10", "10"
ENDINGS = ("html", "htm")

FirstOrScene = Annotated[
    str,
    typer.Argument(
        help="First operand, which is scaled: a file or a model. Alone, a scene: its JSON file "
        "(scene-v1), text, or `-`; with --features any operand."
    ),
]

First = Annotated[
    Fraction | None,
    typer.Option(
        "--from",
        help=f"Smallest scale, included. Default: {FROM}. In space "
        "a window, --from A --to B, has an axis of the events of facets.",
        metavar="A",
    ),
    READ_SCALE,
]
Last = Annotated[
    Fraction | None,
    typer.Option("--to", help=f"Largest scale, included. Default: {TO}.", metavar="B"),
    READ_SCALE,
]
Scale = Annotated[
    Scaling | None,
    typer.Option("--scale", help="In space: the only scale. Default: 1.", metavar="SX,SY,SZ"),
    Read(read_scaling),
]
Scales = Annotated[
    Path | None,
    typer.Option(
        "--scales",
        help="In space: a file with SX,SY,SZ (or S) in each line, for a slider.",
        metavar="FILE",
    ),
]
Route = Annotated[
    str | None,
    typer.Option(
        "--route",
        help="How the sums are computed: read off an index of all scales (index, the "
        "default), or by the paper's dynamic update (dynamic). paper-update: read off, and "
        "beside them what the paper's own program answers, formula by formula.",
    ),
]
Arithmetic = Annotated[
    str | None,
    typer.Option(
        "--arithmetic",
        help=f"With --route {PAPER_UPDATE}: rational (the default), interval, double or mpfr:BITS.",
        metavar="A",
    ),
]
Steps = Annotated[
    int | None,
    typer.Option(
        "--steps",
        help=f"With --route {PAPER_UPDATE}: how many scales of the slider the program goes "
        f"through, at most {MOST_STEPS}. Default: {STEPS}.",
        metavar="N",
    ),
]
PathText = Annotated[
    str | None,
    typer.Option(
        "--path",
        help="Show P, the part, on this polyline of its origin among the obstacles Q, and the "
        "places and scales at which it collides: WKT, GeoJSON or CSV, file or text.",
        metavar="PATH",
    ),
]
Contact = Annotated[
    str | None,
    typer.Option(
        "--contact",
        help="With --path: allowed (the default), the part may touch, or forbidden.",
        metavar="RULE",
    ),
]
OfFeatures = Annotated[
    bool,
    typer.Option(
        "--features",
        help="Show the concave features of P, which stands alone: sliders over the diameter, whose "
        "window --from and --to set, and over the persistence; bridges, regions, the barcode.",
    ),
]
Output = Annotated[
    Path, typer.Option("-o", help="The .html page to write; - is standard output.", metavar="FILE")
]
PAGE = Path("view.html")


@dataclass(frozen=True)
class ViewOfScene:
    P: FirstOrScene
    output: Output = PAGE
    copies: Copies = None
    memory: Memory = None
    json: Json = False


@dataclass(frozen=True)
class ViewOfFeatures:
    P: FirstOrScene
    from_scale: First = None
    to_scale: Last = None
    features: OfFeatures = False
    index: IndexFile = None
    output: Output = PAGE
    memory: Memory = None
    json: Json = False


@dataclass(frozen=True)
class ViewInSpace:
    P: FirstOperand
    Q: SecondOperand
    from_scale: First = None
    to_scale: Last = None
    scale: Scale = None
    scales: Scales = None
    output: Output = PAGE
    memory: Memory = None
    json: Json = False


@dataclass(frozen=True)
class ViewInPlane:
    P: FirstOperand
    Q: SecondOperand
    from_scale: First = None
    to_scale: Last = None
    route: Route = None
    arithmetic: Arithmetic = None
    as_read: Form = None
    reading: Reading = None
    steps: Steps = None
    index: IndexFile = None
    output: Output = PAGE
    erode: Erode = False
    memory: Memory = None
    json: Json = False


@dataclass(frozen=True)
class ViewWithPath:
    P: FirstOperand
    Q: SecondOperand
    from_scale: First = None
    to_scale: Last = None
    path: PathText = None
    contact: Contact = None
    output: Output = PAGE
    memory: Memory = None
    json: Json = False


@dataclass(frozen=True)
class ViewWithDisc:
    P: FirstOperand
    Q: SecondOperand
    from_scale: First = None
    to_scale: Last = None
    route: Route = None
    index: IndexFile = None
    output: Output = PAGE
    erode: Erode = False
    memory: Memory = None
    json: Json = False


ALONE = {"--features": "give P alone"}
WINDOW = "give a window, --from A --to B, or polyhedra"
command = command_of(
    "view",
    TOLD,
    {
        SCENE: Verb(
            ViewOfScene,
            "minkref.scene.commands.view:run",
            instead=dict.fromkeys(("--from", "--to"), "give copies other scales in the scene"),
        ),
        FEATURES: Verb(ViewOfFeatures, "minkref.disc.commands.feature_view:run"),
        SPACE: Verb(ViewInSpace, "minkref.space.commands.view:run", instead=ALONE),
        PLANE: Verb(
            ViewInPlane,
            "minkref.plane.commands.view:run",
            instead={
                "--contact": "add --path PATH",
                "--scale": WINDOW,
                "--scales": WINDOW,
                **ALONE,
            },
        ),
        MOTION: Verb(ViewWithPath, "minkref.motion.commands.path_view:run", instead=ALONE),
        DISC: Verb(ViewWithDisc, "minkref.disc.commands.view:run", instead=ALONE),
    },
)


def page_target(output: Path, json: bool) -> Target:
    """Where the page is written. Refuses what is no page."""
    target = target_of(output, None, ENDINGS, ENDINGS[0], json, has_format=False)
    assert target is not None
    return target
