"""Tasks in processes: in order, and an end where a process dies."""

from __future__ import annotations

import os
from concurrent.futures.process import BrokenProcessPool

import pytest
from minkref.reports.evidence.framework.in_processes import in_processes


def test_results_come_in_the_order_of_the_tasks(capsys: pytest.CaptureFixture[str]) -> None:
    assert list(in_processes(abs, [-3, 1, -2], 2)) == [3, 1, 2]
    assert capsys.readouterr().out == "2 of 3 tasks\n3 of 3 tasks\n"


def test_a_process_that_dies_ends_the_step() -> None:
    with pytest.raises(BrokenProcessPool):
        list(in_processes(os._exit, [1, 1, 1]))
