"""Work of DuckDB that hears signals: it runs in a thread, and is interrupted."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import ThreadPoolExecutor
from typing import Any, TypeVar

Result = TypeVar("Result")


def heard(con: Any, work: Callable[[], Result]) -> Result:
    """The result of work on a connection. A signal that raises here ends the work, too."""
    with ThreadPoolExecutor(1) as pool:
        future = pool.submit(work)
        try:
            return future.result()
        except BaseException:
            if not future.done():
                con.interrupt()
            raise


def heard_batches(con: Any, batches: Iterable[Any]) -> Iterator[Any]:
    """Record batches, each of which is waited for so."""
    source = iter(batches)
    while (batch := heard(con, lambda: next(source, None))) is not None:
        yield batch


def run(con: Any, sql: str, values: object = None) -> list[tuple[Any, ...]]:
    """Runs a statement; returns its rows."""
    return heard(con, lambda: con.execute(sql, values).fetchall())
