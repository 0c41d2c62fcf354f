"""The audit's checks: each runs once per test run, inside the process that asks first."""

from __future__ import annotations

import fcntl
import os
import pickle

import pytest
from minkref.reports.audit.entry import Entry, Shown

RUN = Entry.run  # a test may put `once` in its place


def once(factory: pytest.TempPathFactory, entry: Entry) -> Shown:
    """The result of the entry's check. A check that fails runs again, and fails again."""
    folder = factory.getbasetemp()
    if "PYTEST_XDIST_WORKER" in os.environ:
        folder = folder.parent  # of all workers
    kept = folder / f"audit-{entry.name}.pickle"
    with open(kept.with_suffix(".lock"), "w", encoding="utf-8") as lock:
        fcntl.flock(lock, fcntl.LOCK_EX)
        if kept.exists():
            shown: Shown = pickle.loads(kept.read_bytes())
            return shown
        shown = RUN(entry)
        kept.write_bytes(pickle.dumps(shown))
        return shown
