"""Progress of a long command: a line on the terminal; without a terminal a new line every half
minute."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import AbstractContextManager, contextmanager
from typing import TYPE_CHECKING

from minkref.cli.progress_lines import progress_lines

if TYPE_CHECKING:
    from rich.progress import Progress


class Steps:
    """Counts what is done of a known number of steps, and shows it on a line if there is one."""

    def __init__(self, line: Progress | None, total: int) -> None:
        self._line = line
        self._task = line.add_task("", total=total) if line else None
        self._total, self._count, self._doing = total, 0, "working"

    def now(self, text: str) -> None:
        """Says what is being done."""
        self._doing = text
        if self._line is not None and self._task is not None:
            self._line.update(self._task, description=text)

    def done(self, count: int = 1) -> None:
        self._count += count
        if self._line is not None and self._task is not None:
            self._line.advance(self._task, count)

    def in_words(self) -> str:
        """Writes the current work and its progress."""
        return f"{self._doing}, {self._count:,} of {self._total:,}"


@contextmanager
def progress(total: int) -> Iterator[Steps]:
    """On standard error, and gone when the work is done."""
    if not sys.stderr.isatty():
        steps = Steps(None, total)
        with progress_lines(steps.in_words):
            yield steps
        return
    from rich.console import Console
    from rich.progress import BarColumn, MofNCompleteColumn, Progress, TextColumn, TimeElapsedColumn

    line = Progress(
        TextColumn("{task.description}", markup=False),
        BarColumn(),
        MofNCompleteColumn(),
        TimeElapsedColumn(),
        console=Console(stderr=True),
        transient=True,
    )
    with line:
        yield Steps(line, total)


Tell = Callable[[int, int], None]


@contextmanager
def told_of(work: str) -> Iterator[Tell]:
    """A line for a call that says itself how many of how many steps are done; it begins anew with
    each part of a work of several."""
    whole = 100
    with progress(whole) as line:
        line.now(work)
        before = 0

        def tell(done: int, total: int) -> None:
            nonlocal before
            now = whole * done // total if total else whole
            line.done(now - before)
            before = now

        yield tell


def told_on(line: Steps) -> Callable[[str], AbstractContextManager[Tell]]:
    """The same on a line that there is: how much of the work of its step is done."""

    @contextmanager
    def told(work: str) -> Iterator[Tell]:
        yield lambda done, total: line.now(f"{work}, {100 * done // max(total, 1)} %")

    return told
