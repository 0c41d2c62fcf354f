"""`minkref scene SCENE`: its options."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

import typer
from minkref.cli.memory import Memory
from minkref.cli.options import Json
from minkref.cli.request import Read
from minkref.cli.verb import Verb, command_anywhere
from minkref.exact import read_point
from minkref.verbs.set_request import Format, Output, Plot

EXAMPLES = """Examples:

minkref scene office.json --plot

minkref scene office.json -o c-obstacle.wkt

minkref scene office.json --copies moved.csv --passages

minkref scene office.json --contact allowed

minkref scene office.json --at 3,1/2

minkref scene office.json --way "LINESTRING (0 -3, 9 -3)" --contact forbidden

minkref scene office.json --owners --json"""

TOLD = """\
The places at which a robot meets obstacles, many placed and scaled copies of shapes: the exact
union of the sums of all copies with the robot turned by 180 degrees, in canonical form."""

SceneArgument = Annotated[
    str,
    typer.Argument(
        help="The scene: a JSON file with robot, shapes and copies (scene-v1), its text, or `-` "
        "for standard input.",
        metavar="scene",
    ),
]
Copies = Annotated[
    Path | None,
    typer.Option(
        "--copies",
        help="Take the copies of this CSV file in place of the scene's own; columns shape, scale, "
        "x and y.",
        metavar="FILE",
    ),
]
Passages = Annotated[
    bool,
    typer.Option(
        "--passages",
        help="Find the tight passages too: places inside the set at which the robot touches "
        "obstacles and collides with none.",
    ),
]
Owners = Annotated[
    bool,
    typer.Option(
        "--owners", help="With --json: the copies behind each boundary edge, with its parents."
    ),
]
Rule = Annotated[
    str | None,
    typer.Option(
        "--contact",
        help="Count the free components by this rule: allowed, the robot may touch, or forbidden. "
        "Also the rule of --at and --way; there by default allowed.",
        metavar="RULE",
    ),
]
At = Annotated[
    tuple[str, str] | None,
    typer.Option(
        "--at",
        help="Ask about this place of the robot's origin: is it free, which copies meet the robot, "
        "and by what factor may all copies grow.",
        metavar="X,Y",
    ),
    Read(read_point),
]
WayOption = Annotated[
    str | None,
    typer.Option(
        "--way",
        help="Ask likewise about a way: WKT or GeoJSON of a polyline, a file with one, or CSV.",
        metavar="WAY",
    ),
]
Threads = Annotated[
    int | None, typer.Option("--threads", help="Threads. Default: one per core.", metavar="N")
]


@dataclass(frozen=True)
class SceneRequest:
    scene: SceneArgument
    copies: Copies = None
    output: Output = None
    form: Format = None
    passages: Passages = False
    owners: Owners = False
    contact: Rule = None
    at: At = None
    way: WayOption = None
    threads: Threads = None
    plot: Plot = False
    memory: Memory = None
    json: Json = False


command = command_anywhere(TOLD, Verb(SceneRequest, "minkref.scene.commands.scene:run"))
