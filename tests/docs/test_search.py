"""The site's search: explanations come before lists."""

from __future__ import annotations

import importlib
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]


def test_the_guide_comes_first(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.syspath_prepend(str(ROOT / "docs/site"))
    ranks = importlib.import_module("repository_pages")
    guide, reference, lists = (
        [ranks.rank(page) for page in pages]
        for pages in (
            ("README.md", "docs/README.md", "docs/disc.md", "docs/tutorials/cpp.md"),
            ("api/python.md", "api/command-line.md", "docs/audit/README.md"),
            ("api/cpp/plane/sum.md", "api/schemas/sum-json.md", "reference/README.md"),
        )
    )
    assert min(guide) > max(reference) >= min(reference) > max(lists)
    (tmp_path / "docs").mkdir()
    page, source = tmp_path / "docs/disc.md", tmp_path / "sum.cpp.md"
    page.write_text("# Sums with a disc\n", encoding="utf-8")
    source.write_text("---\nsearch:\n  exclude: true\n---\n", encoding="utf-8")
    ranks.rank_all(tmp_path)
    text = page.read_text(encoding="utf-8")
    assert text == "---\nsearch:\n  boost: 4.0\n---\n# Sums with a disc\n"
    assert "exclude" in source.read_text(encoding="utf-8")
