"""The evidence framework: kept results, repeated steps, and the summary's words."""

from __future__ import annotations

import json
import sys
from pathlib import Path

import pytest

pytest.importorskip("minkref._core", reason="the extension module is not built")

from minkref.reports.convolution_count import Turns, turns_of
from minkref.reports.evidence.framework import child, places, recorded, store, table
from minkref.reports.evidence.framework.part import Findings, Minutes, Size, Status
from minkref.reports.evidence.framework.steps import Step, claim, module, steps

ONE = Step("part/subject", Minutes(0.1, 0.5, 1.0))


@pytest.fixture
def folder(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """Results and code, kept inside the test's own folder."""
    monkeypatch.setattr(places, "FOLDER", tmp_path / "build" / "evidence")
    monkeypatch.setattr(places, "ROOT", tmp_path)
    write(tmp_path, "code.cpp", "1")
    write(tmp_path, "unread.cpp", "1")
    return tmp_path


def write(folder: Path, name: str, text: str) -> None:
    (folder / name).parent.mkdir(exist_ok=True)
    (folder / name).write_text(text)
    for cache in (recorded.known, store.hash_of, store.files_below):
        cache.cache_clear()


def met() -> Findings:
    findings = Findings()
    findings.law("one is one", True, 1, 1)
    return findings


def finish(size: Size, *files: str, error: str = "") -> None:
    document = child.document_of(ONE, size, met(), 1.0, error)
    store.write(document | {"files": store.hashes(files or ["code.cpp"])})


def test_status_tells_a_missed_target_from_a_broken_law() -> None:
    findings = met()
    assert findings.status is Status.MET
    findings.target("speed", False, 1, 2)
    assert findings.status is Status.MISSED
    findings.law("two is one", False, 1, 2)
    assert findings.status is Status.FAILED


def test_findings_without_a_check_are_a_failure() -> None:
    assert Findings(figures={"a": 1}).status is Status.FAILED


def test_finished_step_is_kept_until_a_file_changes_that_it_rests_on(folder: Path) -> None:
    assert store.kept(ONE.name, Size.WHOLE) is None
    finish(Size.WHOLE)
    kept = store.kept(ONE.name, Size.WHOLE)
    assert kept is not None and kept["status"] == "met"
    write(folder, "unread.cpp", "2")
    assert store.kept(ONE.name, Size.WHOLE)
    write(folder, "code.cpp", "2")
    assert store.kept(ONE.name, Size.WHOLE) is None


@pytest.mark.parametrize(
    ("name", "text", "kept"), [("a.hpp", "2", 0), ("c.hpp", "1", 0), ("A.md", "1", 1)]
)
def test_step_that_rests_on_a_folder_runs_again_for_each_file_of_it(
    folder: Path, name: str, text: str, kept: bool
) -> None:
    for file in ("room/a.hpp", "room/b.hpp"):
        write(folder, file, "1")
    finish(Size.FULL, "room/a.hpp", "room/b.hpp", "code.cpp")
    document = store.read(ONE.name, Size.FULL)
    assert document is not None and set(document["files"]) == {"room/", "code.cpp"}
    write(folder, f"room/{name}", text)
    assert bool(store.kept(ONE.name, Size.FULL)) == kept


def test_failed_step_is_not_kept(folder: Path) -> None:
    finish(Size.WHOLE, error="RuntimeError: broke down")
    assert store.read(ONE.name, Size.WHOLE) is not None
    assert store.kept(ONE.name, Size.WHOLE) is None


def test_result_of_a_larger_size_serves_a_smaller_one(folder: Path) -> None:
    for size in Size:
        assert store.kept(ONE.name, size) is None
        finish(size)
        for smaller in Size:
            kept = store.kept(ONE.name, smaller)
            assert (kept and kept["size"]) == (str(size) if smaller <= size else None)


@pytest.mark.parametrize("text", ["{", '{"step": "part/other"}'])
def test_result_that_cannot_be_read_is_not_kept(folder: Path, text: str) -> None:
    finish(Size.WHOLE)
    store.result_path(ONE.name, Size.WHOLE).write_text(text)
    assert store.kept(ONE.name, Size.WHOLE) is None


def test_result_whose_run_ended_before_its_files_were_known_is_not_kept(folder: Path) -> None:
    store.write(child.document_of(ONE, Size.WHOLE, met(), 1.0, ""))
    assert store.kept(ONE.name, Size.WHOLE) is None


@pytest.mark.parametrize(
    ("code", "error"),
    [("import os; os.abort()", "no result"), ("import time; time.sleep(600)", "ended after")],
)
def test_script_that_crashes_or_hangs_is_recorded_as_failed(
    folder: Path, monkeypatch: pytest.MonkeyPatch, code: str, error: str
) -> None:
    monkeypatch.setattr(child, "command", lambda *_: [sys.executable, "-c", code])
    monkeypatch.setattr(child, "time_limit", lambda *_: 2.0 if "sleep" in code else 60.0)
    document = child.run_in_child(ONE, Size.QUICK, lambda: None)
    assert document["status"] == "failed" and error in document["error"]
    assert document["seconds"] < 60
    assert json.loads(store.result_path(ONE.name, Size.QUICK).read_text())["status"] == "failed"


def test_a_step_does_not_rest_on_what_keeps_and_tells_its_result(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Otherwise a step that reads the summary, like the site's builder, would be stale for ever,
    and a word in the summary would make all steps stale."""
    monkeypatch.setattr(places, "FOLDER", tmp_path)
    names = ["docs/disc.md", *store.bookkeeping()]
    code = "".join(f"open({str(places.ROOT / name)!r}).close()\n" for name in names)
    monkeypatch.setattr(child, "command", lambda *_: [sys.executable, "-c", code])
    assert all((places.ROOT / name).is_file() for name in names)
    assert list(child.run_in_child(ONE, Size.QUICK, lambda: None)["files"]) == ["docs/disc.md"]


def test_summary_has_a_row_for_each_part_and_can_be_read_again(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    monkeypatch.delenv("MINKREF_MODELS", raising=False)
    findings = met()
    findings.target("ratio | speed", False, "at most 1", 2.5)
    findings.note("a note")
    documents = [
        child.document_of(Step(name, ONE.minutes), size, found, 90.0, "") | more
        for name, size, found, more in (
            ("part/a", Size.FULL, met(), {"date": "2026-01-02 03:04 UTC", "commit": "1234567890"}),
            ("part/b", Size.WHOLE, findings, {"seed": 12, "commit": "1234567890+"}),
            ("whole/a", Size.FULL, met(), {"commit": "1234567890+"}),
            ("part/hours", Size.FULL, findings, {"commit": "abcdef0123"}),
        )
    ]
    entries = {one["step"]: table.entry_of(one) for one in documents}
    names = ["part/a", "part/b", "part/c", "whole/a", "absent/a"]
    every = [Step(name, ONE.minutes) for name in names]
    every += [Step(f"part/{name}", Minutes(None, None, 60)) for name in ("hours", "never")]
    text = table.markdown(every, entries, lambda part: f"The claim of {part}.", False)
    row = (
        "| [part](#part) | missed, 2 of 3 steps | whole | several | 2026-01-02 | 3.0 | look-alike |"
    )
    assert row in text
    assert "| [whole](#whole) | met | full | 12345678+ |" in text
    assert "| absent | not run |" in text
    assert "| [part/hours](#parthours) | missed | full | abcdef01 |" in text
    assert "| part/never | not run |" in text
    assert "\n## part\n\nThe claim of part.\n\n### part/a\n\nmet; full size; 1.5 minutes; " in text
    assert "commit 12345678+; seed 12; look-alike models\n" in text
    assert "| ratio \\| speed (target) | at most 1 | 2.5 | missed |" in text
    assert table.entries_of(text) == entries
    again = table.markdown(every, table.entries_of(text), lambda p: f"The claim of {p}.", False)
    assert again == text


def test_every_step_declares_sizes_and_every_part_a_claim() -> None:
    every = steps()
    assert len(every) > 70 and 30 <= len({step.part for step in every}) <= 44
    for step in every:
        quick, whole, full = step.minutes
        assert 0 < (quick or 0.01) <= (whole or full) <= full, step.name
        assert quick is None or whole is not None, step.name
        assert 40 < len(claim(step.part)) < 320, step.part


@pytest.mark.parametrize("name", ["plane_sums/scalar_types", "packages/fresh_clone"])
def test_a_step_is_a_module_that_runs(name: str) -> None:
    step = next(step for step in steps() if step.name == name)
    assert step.minutes == module(name).MINUTES
    assert step.alone == hasattr(module(name), "ALONE")
    assert callable(module(name).run)


@pytest.mark.parametrize(("size", "most"), [(Size.QUICK, 5.5 * 2), (Size.WHOLE, 165)])
def test_all_of_a_size_fits_into_its_time(size: Size, most: float) -> None:
    """The quick size takes minutes on two cores."""
    declared = [step.minutes[size] or 0 for step in steps()]
    assert sum(declared) <= most


def test_recount_of_the_convolution_on_two_triangles_by_hand() -> None:
    """Two triangles that share one edge direction: each edge meets one vertex. A triangle and
    itself: each edge begins one turn and ends another."""
    P, Q = [[(0, 0), (4, 0), (0, 4)]], [[(0, 0), (0, -4), (4, 1)]]
    assert turns_of(P, Q) == (Turns(inside=2, begin=1, end=1), Turns(), 0)
    assert turns_of(Q, P) == (Turns(inside=2, begin=1, end=1), Turns(), 0)
    assert turns_of(P, P) == (Turns(begin=3, end=3), Turns(), 0)


def test_recount_at_reflex_and_straight_vertices_by_hand() -> None:
    """A dart with one reflex vertex, whose turn contains an edge direction; a vertex amid an edge
    is straight."""
    triangle = [[(0, 0), (4, 0), (0, 4)]]
    dart = [[(0, 0), (9, -4), (4, 0), (9, 4)]]
    _, reflex, straight = turns_of([[(0, 0), (0, 5), (-5, 0)]], dart)
    assert (reflex, straight) == (Turns(inside=1), 0)
    _, reflex, straight = turns_of(triangle, [[(0, 0), (2, 0), (4, 0), (0, 4)]])
    assert (reflex, straight) == (Turns(), 1)
