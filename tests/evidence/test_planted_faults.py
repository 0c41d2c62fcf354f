"""The faults that a test build can put into the reference: the reference has all listed faults, and
no user's build has any."""

from __future__ import annotations

import os
import re
import subprocess
import sys
from pathlib import Path

import pytest
from minkref.reports.evidence.planted_faults import faults as planted_faults

ROOT = Path(__file__).resolve().parents[2]


def test_every_fault_is_planted_in_the_reference_and_described() -> None:
    faults = planted_faults.listed()
    found: dict[str, str] = {}
    for where, fewest in planted_faults.FEWEST_OF_LIST.items():
        some = planted_faults.listed(where)
        assert len(some) >= fewest
        found |= some
    assert found == faults
    sources = [p for p in (ROOT / "reference").rglob("*.?pp") if p.stem != "fault"]
    planted = re.findall(r"Fault::(\w+)", "".join(p.read_text("utf-8") for p in sources))
    assert set(planted) == set(faults)
    assert len(set(faults.values())) == len(faults)


def test_the_table_of_who_caught_what_has_them_all() -> None:
    table = planted_faults.TABLE.read_text("utf-8")
    rows = re.findall(r"^\| `(\w+)` \|", table, re.MULTILINE)
    assert rows == list(planted_faults.listed())


@pytest.mark.parametrize("fault", ["turn_ends_alike", "collision_skipped", "no such fault"])
def test_no_fault_can_be_switched_on_in_what_users_have(fault: str) -> None:
    command = [sys.executable, "-m", "minkref", "sum", "g1", "g2", "--json"]
    digests = set()
    for name in ("", fault):
        done = subprocess.run(
            command, env={**os.environ, "MINKREF_FAULT": name}, capture_output=True, text=True,
            check=True,
        )  # fmt: skip
        digests |= set(re.findall(r'"digest": "(\w+)"', done.stdout))
    assert len(digests) == 1
