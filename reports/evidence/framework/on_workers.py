"""Steps as tasks of Dask: on a scheduler's workers, each of which has this checkout, built."""

from __future__ import annotations

import threading
import time
from collections.abc import Callable, Sequence
from typing import Any

from minkref.fuzz.campaign.campaign_file import ClusterTable
from minkref.fuzz.campaign.clusters import dask, joined, started
from minkref.reports.evidence.framework import child, store
from minkref.reports.evidence.framework.part import Size
from minkref.reports.evidence.framework.steps import Step

LOCAL = "local:"
OVER = threading.Event()  # ends local steps, with what they started
GRACE = 1.0  # seconds for that


def on_workers(
    place: str, chosen: Sequence[Step], size: Size, tell: Callable[[store.Document], None]
) -> dict[str, store.Document]:
    """Returns documents by name, after writing them. `place`: a scheduler's address, or
    `local:N`. After a worker's death another worker repeats the step."""
    if place.startswith(LOCAL):
        with started(ClusterTable(), int(place.removeprefix(LOCAL))) as cluster:
            try:
                return _documents(cluster, chosen, size, tell)
            except BaseException:
                OVER.set()
                time.sleep(GRACE)
                raise
    return _documents(place, chosen, size, tell)


def _documents(
    place: Any, chosen: Sequence[Step], size: Size, tell: Callable[[store.Document], None]
) -> dict[str, store.Document]:
    with joined(place) as client:
        found = {}
        futures = [client.submit(run_step, step, size, pure=False) for step in chosen]
        for future in dask().as_completed(futures):
            document: store.Document = future.result()
            store.write(document)
            tell(document)
            found[document["step"]] = document
        return found


def run_step(step: Step, size: Size) -> store.Document:
    """The work of a task."""
    return child.run_in_child(step, size, _end_if_over)


def _end_if_over() -> None:
    if OVER.is_set():
        raise KeyboardInterrupt
