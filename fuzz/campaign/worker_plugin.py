"""Dask's hook for a campaign's workers; the only module here that imports Dask at once."""

from __future__ import annotations

import multiprocessing
from typing import Any

from distributed.diagnostics.plugin import WorkerPlugin
from minkref.fuzz.campaign.judging import HELD


class Processes(WorkerPlugin):
    """Lets a worker start processes, and ends them with the worker or the campaign."""

    name = "minkref-campaign"

    def setup(self, worker: Any) -> None:
        process = multiprocessing.current_process()
        if process.daemon:  # a nanny's worker is one, and daemons may have no children
            process.daemon = False

    def teardown(self, worker: Any) -> None:
        HELD.close()
