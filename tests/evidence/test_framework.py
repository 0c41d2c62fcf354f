"""The evidence framework: what is kept, what runs again, what fails a run."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

pytest.importorskip("minkref._core", reason="the extension module is not built")

from minkref.reports.convolution_count import Turns, turns_of
from minkref.reports.evidence.framework import child, store, table
from minkref.reports.evidence.framework.part import Findings, Part, Status, load, names


@pytest.fixture
def folders(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Results, scripts and code in a folder of the test's own."""
    monkeypatch.setattr(store, "FOLDER", tmp_path / "evidence")
    monkeypatch.setattr(store, "SCRIPTS_FOLDER", tmp_path / "scripts")
    monkeypatch.setattr(store, "ROOT", tmp_path)
    (tmp_path / "scripts").mkdir()
    (tmp_path / "code.cpp").write_text("1")
    return tmp_path


def part(findings: Findings | None = None) -> Part:
    def run(quick: bool) -> Findings:
        return findings or Findings()

    return Part("subject", "A subject.", 1.0, 0.1, ("*.cpp",), run)


def met() -> Findings:
    findings = Findings()
    findings.law("one is one", True, 1, 1)
    return findings


def finish(one: Part, quick: bool, error: str = "") -> None:
    store.write(child.document_of(one, quick, one.run(quick), 1.0, error))


def test_status_tells_a_missed_target_from_a_broken_law() -> None:
    findings = met()
    assert findings.status is Status.MET
    findings.target("speed", False, 1, 2)
    assert findings.status is Status.MISSED
    findings.law("two is one", False, 1, 2)
    assert findings.status is Status.FAILED


def test_findings_without_a_check_are_a_failure() -> None:
    assert Findings(figures={"a": 1}).status is Status.FAILED


def test_finished_part_is_kept_until_its_code_changes(folders: Path) -> None:
    one = part(met())
    assert store.kept(one, False) is None
    finish(one, False)
    kept = store.kept(one, False)
    assert kept is not None and kept["status"] == "met"
    (folders / "code.cpp").write_text("2")
    assert store.kept(one, False) is None


def test_part_runs_again_when_its_own_script_changes(folders: Path) -> None:
    one = part(met())
    finish(one, False)
    (folders / "scripts" / "subject.py").write_text("pass")
    assert store.kept(one, False) is None


def test_failed_part_is_not_kept(folders: Path) -> None:
    one = part(met())
    finish(one, False, error="RuntimeError: broke down")
    assert store.read("subject", False) is not None
    assert store.kept(one, False) is None


def test_quick_result_never_stands_for_a_full_one(folders: Path) -> None:
    one = part(met())
    finish(one, True)
    assert store.kept(one, False) is None
    quick = store.kept(one, True)
    assert quick is not None and quick["quick"] is True
    finish(one, False)
    full = store.kept(one, True)
    assert full is not None and full["quick"] is False
    finish(one, True)
    still = store.kept(one, False)
    assert still is not None and still["quick"] is False


def test_result_that_cannot_be_read_is_not_kept(folders: Path) -> None:
    one = part(met())
    finish(one, False)
    store.result_path("subject", False).write_text("{")
    assert store.kept(one, False) is None


def test_crash_of_a_script_is_recorded_as_failed(folders: Path) -> None:
    (folders / "scripts" / "run.py").write_text("import os\nos.abort()\n")
    document = child.run_in_child(part(met()), False, lambda: None)
    assert document["status"] == "failed"
    assert "without a result" in document["error"]
    assert json.loads(store.result_path("subject", False).read_text())["status"] == "failed"


def test_script_that_hangs_is_ended(folders: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(child, "time_limit", lambda *_: 0.5)
    (folders / "scripts" / "run.py").write_text("import time\ntime.sleep(600)\n")
    document = child.run_in_child(part(met()), False, lambda: None)
    assert document["status"] == "failed"
    assert document["error"].startswith("ended after")
    assert document["seconds"] < 60


def test_summary_names_missed_targets_and_absent_parts() -> None:
    findings = met()
    findings.target("ratio | speed", False, "at most 1", 2.5)
    document = child.document_of(part(findings), True, findings, 90.0, "")
    text = table.markdown([document], {"other": "not run"}, quick=True)
    assert "| [subject](#subject) | missed (quick) |" in text
    assert "| ratio \\| speed (target) | at most 1 | 2.5 | missed |" in text
    assert "| other | not run |" in text


def test_every_script_declares_what_the_framework_needs() -> None:
    assert len(names()) >= 13
    for name in names():
        one = load(name)
        assert one.minutes > 0
        assert one.depends
        assert callable(one.run)
        assert len(one.subject) > 20
        unmatched = [g for g in one.depends if not any(store.ROOT.glob(g))]
        assert unmatched == [], f"{name}: globs that name nothing"


def test_quick_run_fits_ten_minutes_on_two_cores() -> None:
    quick = [part for part in map(load, names()) if part.quick_minutes is not None]
    alone = sum(part.quick_minutes or 0 for part in quick if part.alone)
    assert alone + sum(part.quick_minutes or 0 for part in quick if not part.alone) / 2 <= 10


def test_recount_of_the_convolution_on_two_triangles_by_hand() -> None:
    """Two triangles that share the direction of one edge: each edge meets one vertex. A triangle
    and itself: each edge is at the beginning of one turn and at the end of another."""
    P, Q = [[(0, 0), (4, 0), (0, 4)]], [[(0, 0), (0, -4), (4, 1)]]
    assert turns_of(P, Q) == (Turns(inside=2, begin=1, end=1), Turns(), 0)
    assert turns_of(Q, P) == (Turns(inside=2, begin=1, end=1), Turns(), 0)
    assert turns_of(P, P) == (Turns(begin=3, end=3), Turns(), 0)


def test_recount_at_reflex_and_straight_vertices_by_hand() -> None:
    """A dart with one reflex vertex, whose turn holds the direction of one edge; a vertex in the
    middle of an edge is straight."""
    triangle = [[(0, 0), (4, 0), (0, 4)]]
    dart = [[(0, 0), (9, -4), (4, 0), (9, 4)]]
    _, reflex, straight = turns_of([[(0, 0), (0, 5), (-5, 0)]], dart)
    assert (reflex, straight) == (Turns(inside=1), 0)
    _, reflex, straight = turns_of(triangle, [[(0, 0), (2, 0), (4, 0), (0, 4)]])
    assert (reflex, straight) == (Turns(), 1)
