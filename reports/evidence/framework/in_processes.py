"""Runs a function on many tasks, in two processes."""

from __future__ import annotations

import multiprocessing
from collections.abc import Callable, Iterator, Sequence
from typing import TypeVar

PROCESSES = 2
Task = TypeVar("Task")
Result = TypeVar("Result")


def in_processes(
    work: Callable[[Task], Result], tasks: Sequence[Task], each: int = 1, what: str = "tasks"
) -> Iterator[Result]:
    """Results in the tasks' order; after every `each` results the log tells the count."""
    with multiprocessing.get_context("spawn").Pool(PROCESSES) as pool:
        for done, result in enumerate(pool.imap(work, tasks), 1):
            if done % each == 0 or done == len(tasks):
                print(f"{done} of {len(tasks)} {what}", flush=True)
            yield result
