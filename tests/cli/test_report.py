"""`minkref report degeneracies`: a page for each family, with drawings of finite coordinates."""

from __future__ import annotations

import re
from pathlib import Path
from typing import Any

from minkref.degeneracies import lint
from minkref.degeneracies.catalogue import FAMILIES
from minkref.degeneracies.invalid.catalogue import INVALID_FAMILIES


def test_a_page_for_each_family(minkref: Any, tmp_path: Path) -> None:
    ran = minkref("report", "degeneracies", "-o", str(tmp_path / "pages"), "--json")
    assert ran.code == 0
    front = Path(ran.json["front"]).read_text(encoding="utf-8")
    assert f"{len(lint.case_paths(lint.CORPUS))} cases" in front
    for name in (*FAMILIES, "found"):
        page = (tmp_path / "pages" / f"{name}.html").read_text(encoding="utf-8")
        assert f'href="{name}.html"' in front and page.count("<svg") >= 10
        numbers = re.findall(
            r"(?<=[ML ])[^ MLZ\"]+(?=[ LZ])", "".join(re.findall(r' d="[^"]*"', page))
        )
        assert numbers and all(-1e4 < float(number) < 1e4 for number in numbers)
    for name in INVALID_FAMILIES:
        assert f'id="{name}"' in front


def test_what_cannot_be_reported_is_refused(minkref: Any, tmp_path: Path) -> None:
    out = str(tmp_path / "pages")
    assert minkref("report", "weather", "-o", out).code == 2
    ran = minkref("report", "degeneracies", "--corpus", str(tmp_path), "-o", out)
    assert (ran.code, "no case" in ran.err) == (2, True)
    assert not (tmp_path / "pages").exists()
