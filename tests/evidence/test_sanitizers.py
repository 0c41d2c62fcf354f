"""Reads results of tests that ran under the sanitizers, as the evidence does."""

from __future__ import annotations

from pathlib import Path

import pytest

pytest.importorskip("minkref._core", reason="the extension module is not built")

from minkref.reports.evidence.memory_and_flags.sanitizers import read

RESULTS = """<?xml version="1.0"?><testsuite name="x">
<testcase name="a.Passes" status="run"><system-out>all well</system-out></testcase>
<testcase name="a.IsAbsent" status="notrun"/>
<testcase name="a.Races" status="fail"><system-out>before
WARNING: ThreadSanitizer: data race (pid=1)
  Write of size 8</system-out></testcase>
<testcase name="a.Shifts" status="fail"><system-out>x.cpp:48:56: runtime error: shift exponent 36
==1==ERROR: AddressSanitizer: heap-use-after-free</system-out></testcase>
</testsuite>"""


def test_failures_and_reports_are_found_and_what_did_not_run_is_named(tmp_path: Path) -> None:
    (tmp_path / "results.xml").write_text(RESULTS, encoding="utf-8")
    tests = read(tmp_path / "results.xml", 1.5)
    assert (tests.ran, tests.failed, tests.skipped) == (3, ["a.Races", "a.Shifts"], ["a.IsAbsent"])
    assert [report.split(":")[0] for report in tests.reports] == ["a.Races", "a.Shifts", "a.Shifts"]
