"""The wall around the memory of a command: work that needs more ends with a refusal."""

from __future__ import annotations

import resource
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Annotated

import typer
from minkref import _core
from minkref.errors import Refusal

MEBIBYTE = 1 << 20
MOST = 1 << 24  # MiB
ROOM = 1 << 30  # for what is allocated between two looks at the limit

SIMPLER = "take simpler operands"
SMALLER = "take a smaller window of scales, or simpler operands"

Memory = Annotated[
    int | None,
    typer.Option(
        "--memory",
        help="The most memory that the work may use, in MiB. Default: nine tenths of what is free.",
        metavar="MIB",
    ),
]


@contextmanager
def memory_wall(limit: int | None, work: str, where: str, instead: str) -> Iterator[None]:
    """Within it the process may have `limit` MiB (None: nine tenths of what is free). Raises
    Refusal where more is needed: it names `work` and says what to do `instead`."""
    if limit is not None and not 0 <= limit <= MOST:
        range_of = f"it has to be 0 (the default) to {MOST:,}"
        raise Refusal(range_of, f"--memory {limit}", "choose another number")
    _core.set_memory_limit((limit or 0) * MEBIBYTE)
    before = resource.getrlimit(resource.RLIMIT_DATA)
    most = _core.memory_limit() + ROOM
    if before[0] == resource.RLIM_INFINITY or most < before[0]:
        resource.setrlimit(resource.RLIMIT_DATA, (most, before[1]))
    try:
        yield
    except MemoryError:
        what = f"it needs more than the {most // MEBIBYTE:,} MiB that it may have"
        raise _refusal(what, work, where, instead) from None
    except _core.LimitExceeded as error:
        if error.code != "memory-limit":
            raise
        raise _refusal(error.problem, work, where, instead) from error
    except Refusal as refusal:
        if refusal.code != "memory-limit":
            raise
        raise _refusal(refusal.what, work, where, instead) from refusal
    finally:
        resource.setrlimit(resource.RLIMIT_DATA, before)
        _core.set_memory_limit(0)


def _refusal(what: str, work: str, where: str, instead: str) -> Refusal:
    return Refusal(
        f"{work}: {what}", where, f"give it more memory with --memory, or {instead}", "memory-limit"
    )
