"""Options of the commands that run targets: the limits of a call, and the walls around it."""

from __future__ import annotations

from typing import Annotated

import typer
from minkref.fuzz.isolation.isolation import KINDS

CallSeconds = Annotated[
    float, typer.Option("--call-seconds", help="Time limit of one call of one target.")
]
CallMemory = Annotated[
    int, typer.Option("--call-memory", help="Memory limit of one call, in MiB.", metavar="MIB")
]
CallProcesses = Annotated[
    int,
    typer.Option(
        "--call-processes",
        help="Limit of the processes of one program or function, with their threads.",
        metavar="N",
    ),
]
IsolationKind = Annotated[
    str,
    typer.Option(
        "--isolation",
        help="How programs and functions under test are isolated: sandbox (bubblewrap), none, or "
        "auto (the sandbox where it works).",
        metavar="|".join(KINDS),
        autocompletion=lambda: list(KINDS),
    ),
]
PassedVariables = Annotated[
    list[str] | None,
    typer.Option(
        "--pass-env",
        help="Pass this environment variable on to them; by default they get only a short list.",
        metavar="NAME",
    ),
]
