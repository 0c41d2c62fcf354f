"""Runs a function on many tasks, in two processes."""

from __future__ import annotations

import multiprocessing
from collections.abc import Callable, Iterator, Sequence
from concurrent.futures import ProcessPoolExecutor
from typing import TypeVar

PROCESSES = 2
Task = TypeVar("Task")
Result = TypeVar("Result")


def in_processes(
    work: Callable[[Task], Result], tasks: Sequence[Task], each: int = 1, what: str = "tasks"
) -> Iterator[Result]:
    """Results in the tasks' order; after every `each` results the log tells the count. Raises
    BrokenProcessPool where a process dies: a pool of multiprocessing would wait for ever."""
    context = multiprocessing.get_context("spawn")
    with ProcessPoolExecutor(PROCESSES, context) as pool:
        try:
            for done, result in enumerate(pool.map(work, tasks), 1):
                if done % each == 0 or done == len(tasks):
                    print(f"{done} of {len(tasks)} {what}", flush=True)
                yield result
        finally:
            pool.shutdown(wait=False, cancel_futures=True)
