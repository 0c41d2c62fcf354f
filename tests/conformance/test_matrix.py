"""The matrix of libraries and families: its page is as generated from the kept runs, and counts
only what was decided."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from minkref.reports.matrix import kept_run, page
from minkref.reports.matrix.badge import AMBER, GREEN, RED, badge
from minkref.reports.matrix.kept_run import OFFSETS, PATHS, SUMS, UNIONS


def test_page_and_badges_are_those_of_the_kept_runs() -> None:
    """`python -m minkref.reports.matrix.page` writes them again."""
    assert page.PAGE.read_text(encoding="utf-8") == page.page()
    drawn = {path.name: path.read_text(encoding="utf-8") for path in page.BADGES.glob("*.svg")}
    assert drawn == page.badges()


def target(name: str, kind: str, *capabilities: str) -> dict[str, object]:
    return {"name": name, "version": "1", "sum": kind, "capabilities": capabilities}


def cell(name: str, group: str, **verdicts: int) -> dict[str, object]:
    names = {"right": "pass", "pass_within": "pass-within"}
    told = {names.get(each, each): count for each, count in verdicts.items()}
    return {"target": name, "group": group, "verdicts": told}


def document() -> dict[str, object]:
    return {
        "seed": 5,
        "seconds": 61.5,
        "targets": [target("cgal-reduced", "region"), target("geos-buffer", "none", "offset"),
                    target("boost-polygon", "region", "union"), target("jts", "none", "union")],
        "groups": [{"name": "comb", "cases": 9}, {"name": "offsets", "cases": 2}],
        "findings": [{"target": "jts", "reasons": ["missing", "extra"]},
                     {"target": "jts", "reasons": ["extra"]}],
        "shrunk": [{}],
        "matrix": [
            cell("cgal-reduced", "comb", skipped=3, undecided=1), cell("jts", "mutants", wrong=2),
            cell("boost-polygon", "unions", right=1), cell("geos-buffer", "laws", pass_within=1),
            cell("boost-polygon", "comb", right=4, pass_within=1, crashed=1, skipped=9),
        ],
    }  # fmt: skip


def test_a_run_is_kept_without_what_says_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Skipped and undecided cases are no verdicts about a library."""
    (tmp_path / "run.json").write_text(json.dumps(document()), encoding="utf-8")
    monkeypatch.setattr(kept_run, "FILE", tmp_path / "kept.json")
    kept_run.keep(tmp_path / "run.json", tmp_path / "kept.json")
    run = kept_run.kept()
    assert [(one.seed, one.cases, one.shrunk) for one in run.runs] == [(5, 11, 1)]
    assert run.reasons == {"jts": {"missing": 1, "extra": 2}}
    assert [(cell.asked, cell.target, cell.right, cell.judged) for cell in run.cells] == [
        (UNIONS, "jts", 0, 2), (UNIONS, "boost-polygon", 1, 1), (OFFSETS, "geos-buffer", 1, 1),
        (SUMS, "boost-polygon", 5, 6),
    ]  # fmt: skip
    assert list(run.libraries) == ["GEOS", "Boost.Polygon", "JTS"]
    assert "| comb | **5/6** |" in page.page()


def test_a_later_run_takes_the_place_of_its_targets(tmp_path: Path) -> None:
    later = document() | {
        "seed": 6,
        "targets": [target("jts", "none", "union"), target("fcl-collide", "none", "path"),
                    target("cgal-skeleton", "none", "join-sharp")],
        "findings": [],
        "matrix": [cell("jts", "unions", right=3), cell("fcl-collide", "paths", wrong=1),
                   cell("cgal-skeleton", "offsets", pass_within=2)],
    }  # fmt: skip
    for value in (document(), later):
        (tmp_path / "run.json").write_text(json.dumps(value), encoding="utf-8")
        kept_run.keep(tmp_path / "run.json", tmp_path / "kept.json")
    run = kept_run.kept(tmp_path / "kept.json")
    assert [(one.seed, len(one.targets)) for one in run.runs] == [(5, 3), (6, 3)]
    assert run.reasons == {} and list(run.versions)[-3:] == ["jts", "fcl-collide", "cgal-skeleton"]
    assert [(each.asked, each.target, each.judged) for each in run.cells][-3:] == [
        (UNIONS, "jts", 3), (PATHS, "fcl-collide", 1), (OFFSETS, "cgal-skeleton", 2),
    ]  # fmt: skip
    assert len(run.of("jts")) == 1 and len(run.of("boost-polygon")) == 2


def test_a_badge_is_green_only_where_all_are_right() -> None:
    for right, colour in ((100, GREEN), (99, AMBER), (90, AMBER), (89, RED)):
        assert colour in badge("A & B", right, 100)
    assert 'aria-label="A &amp; B: 1 of 2 right"' in badge("A & B", 1, 2)
