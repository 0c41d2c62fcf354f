"""Progress of a long command: a line on the terminal, nothing in a pipe."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager

from rich.console import Console
from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn


class Steps:
    """Counts what is done of a known number of steps."""

    def __init__(self, progress: Progress, total: int) -> None:
        self._progress = progress
        self._task = progress.add_task("", total=total)

    def now(self, text: str) -> None:
        """Says what is being done."""
        self._progress.update(self._task, description=text)

    def done(self, count: int = 1) -> None:
        self._progress.advance(self._task, count)


@contextmanager
def progress(total: int) -> Iterator[Steps]:
    """On standard error, and gone when the work is done."""
    line = Progress(
        TextColumn("{task.description}", markup=False),
        BarColumn(),
        MofNCompleteColumn(),
        TimeElapsedColumn(),
        console=Console(stderr=True),
        transient=True,
        disable=not sys.stderr.isatty(),
    )
    with line:
        yield Steps(line, total)
