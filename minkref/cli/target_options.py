"""Options of the commands that run targets: the limits of a call, and the walls around it."""

from __future__ import annotations

from typing import Annotated

import typer
from minkref.fuzz.isolation.isolation import KINDS, Isolation, choose
from minkref.fuzz.targets.answer import Limits
from minkref.verbs.verify_limits import check_numbers

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


def walls_and_limits(
    seconds: float, memory: int, processes: int, isolation: str, passed: list[str] | None
) -> tuple[Isolation, Limits]:
    """Walls and limits of a command that asks one target. `memory` in MiB. Refuses numbers out of
    range."""
    check_numbers(
        {"--call-seconds": seconds, "--call-memory": memory, "--call-processes": processes}
    )
    walls = choose(isolation, tuple(passed or ()))
    return walls, Limits(seconds, memory << 20, processes=processes, isolation=walls)
