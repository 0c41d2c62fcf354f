"""`minkref scene SCENE`: its options."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import Annotated

import typer
from minkref.cli.memory import Memory
from minkref.cli.options import Json
from minkref.cli.verb import Verb, command_anywhere
from minkref.verbs.set_request import Format, Output, Plot

EXAMPLES = """Examples:

minkref scene office.json --plot

minkref scene office.json -o c-obstacle.wkt

minkref scene office.json --copies moved.csv --passages

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
    threads: Threads = None
    plot: Plot = False
    memory: Memory = None
    json: Json = False


command = command_anywhere(TOLD, Verb(SceneRequest, "minkref.scene.commands.scene:run"))
