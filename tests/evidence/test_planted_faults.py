"""The table of planted faults has all faults."""

from __future__ import annotations

import re

from minkref.reports.evidence.planted_faults import faults as planted_faults


def test_the_table_of_who_caught_what_has_them_all() -> None:
    table = planted_faults.TABLE.read_text("utf-8")
    rows = re.findall(r"^\| `(\w+)` \|", table, re.MULTILINE)
    assert rows == list(planted_faults.listed())
