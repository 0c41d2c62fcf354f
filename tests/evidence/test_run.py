"""`make evidence` itself: exit codes, what is run, and which summary is written."""

from __future__ import annotations

import shutil
import sys
import threading
import time
from collections.abc import Callable
from pathlib import Path

import pytest

pytest.importorskip("minkref._core", reason="the extension module is not built")

from minkref.reports.evidence import run
from minkref.reports.evidence.framework import child, store
from minkref.reports.evidence.framework.part import Findings, Part


def findings(quick: bool) -> Findings:
    found = Findings()
    found.law("one is one", True, 1, 1)
    return found


class Stage:
    """Two parts, the second without a quick form, and what their runs give."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.ran: list[str] = []
        self.outcome: dict[str, str] = {}
        self.parts = {
            "first": Part("first", "The first subject.", 1.0, 0.1, (), findings),
            "second": Part("second", "The second subject.", 1.0, None, (), findings),
        }

    def run_in_child(self, part: Part, quick: bool, tick: object) -> dict[str, object]:
        self.ran.append(part.name)
        found = part.run(quick)
        outcome = self.outcome.get(part.name, "met")
        if outcome == "missed":
            found.target("speed", False, 1, 2)
        error = "RuntimeError: broke down" if outcome == "error" else ""
        document = child.document_of(part, quick, found, 1.0, error)
        store.write(document)
        return document


@pytest.fixture
def stage(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Stage:
    made = Stage(tmp_path)
    monkeypatch.setattr(store, "FOLDER", tmp_path / "evidence")
    monkeypatch.setattr(store, "SCRIPTS_FOLDER", tmp_path)
    monkeypatch.setattr(run, "names", lambda: sorted(made.parts))
    monkeypatch.setattr(run, "load", made.parts.__getitem__)
    monkeypatch.setattr(child, "run_in_child", made.run_in_child)
    monkeypatch.delenv("QUICK", raising=False)
    return made


def call(monkeypatch: pytest.MonkeyPatch, *arguments: str) -> int:
    monkeypatch.setattr(sys, "argv", ["run.py", *arguments])
    return run.main()


def test_missed_target_does_not_fail_the_run(stage: Stage, monkeypatch: pytest.MonkeyPatch) -> None:
    stage.outcome["first"] = "missed"
    assert call(monkeypatch) == 0
    assert "| [first](#first) | missed |" in (stage.folder / "SUMMARY.md").read_text()


def test_error_fails_the_run_and_the_other_parts_run(
    stage: Stage, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    stage.outcome["first"] = "error"
    assert call(monkeypatch) == 1
    last = capsys.readouterr().out.splitlines()[-1]
    assert last == "failed: first: RuntimeError: broke down"
    assert stage.ran == ["first", "second"]
    assert "Broke down: `RuntimeError: broke down`" in (stage.folder / "SUMMARY.md").read_text()


def test_finished_parts_are_not_run_again_but_failed_ones_are(
    stage: Stage, monkeypatch: pytest.MonkeyPatch
) -> None:
    stage.outcome["first"] = "error"
    assert call(monkeypatch) == 1
    stage.outcome.clear()
    assert call(monkeypatch) == 0
    assert stage.ran == ["first", "second", "first"]


def test_quick_run_writes_no_committed_summary(
    stage: Stage, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("QUICK", "1")
    assert call(monkeypatch) == 0
    assert stage.ran == ["first"]
    assert not (stage.folder / "SUMMARY.md").exists()
    text = (stage.folder / "evidence" / "summary-quick.md").read_text()
    assert "met (quick)" in text
    assert "| second | full run only |" in text


def test_only_named_parts_are_run_and_the_summary_keeps_the_others(
    stage: Stage, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert call(monkeypatch, "second") == 0
    assert call(monkeypatch, "first") == 0
    assert stage.ran == ["second", "first"]
    text = (stage.folder / "SUMMARY.md").read_text()
    assert "| [first](#first) | met |" in text and "| [second](#second) | met |" in text


def test_in_a_fresh_clone_the_summary_keeps_what_others_have_reached(
    stage: Stage, monkeypatch: pytest.MonkeyPatch
) -> None:
    stage.outcome["second"] = "missed"
    assert call(monkeypatch, "second") == 0
    for _ in range(2):  # and in the clone of the clone
        shutil.rmtree(stage.folder / "evidence")
        assert call(monkeypatch, "first") == 0
        text = (stage.folder / "SUMMARY.md").read_text()
        assert "| [first](#first) | met |" in text
        assert "| [second](#second) | missed, of an earlier run |" in text
        assert text.count("\n## second\n\nThe second subject.\n") == 1
        assert "| speed (target) | 1 | 2 | missed |" in text
    assert call(monkeypatch, "second") == 0
    text = (stage.folder / "SUMMARY.md").read_text()
    assert "| [second](#second) | missed |" in text and text.count("\n## second\n") == 1


def test_unknown_part_is_wrong_usage(stage: Stage, monkeypatch: pytest.MonkeyPatch) -> None:
    assert call(monkeypatch, "third") == 2
    assert stage.ran == []


def test_parts_that_run_alone_have_nothing_beside_them(
    stage: Stage, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Two others are under way at once: each waits for the other."""
    meeting = threading.Barrier(2, timeout=60)
    under_way: set[str] = set()
    beside: dict[str, set[str]] = {}

    def run_in_child(part: Part, quick: bool, tick: object) -> dict[str, object]:
        under_way.add(part.name)
        if not part.alone:
            meeting.wait()
        beside[part.name] = under_way - {part.name}
        if not part.alone:
            meeting.wait()
        under_way.remove(part.name)
        return Stage.run_in_child(stage, part, quick, tick)

    stage.parts |= {
        name: Part(name, "A subject.", 1.0, 0.1, (), findings, alone=name == "timed")
        for name in ("timed", "third")
    }
    monkeypatch.setattr(child, "run_in_child", run_in_child)
    assert call(monkeypatch, "--quick", "--jobs", "2") == 0
    assert beside == {"first": {"third"}, "third": {"first"}, "timed": set()}


def test_of_parts_at_once_the_longest_begin_first(
    stage: Stage, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Else a core waits at the end for one that began last; one at a time they go by name."""
    stage.parts |= {
        name: Part(name, "A subject.", 3.0 - quick, quick, (), findings)
        for name, quick in (("longest", 1.5), ("middle", 0.7), ("zero", 0.1))
    }
    lines: list[list[str]] = []

    def at_once(parts: list[Part], *_: object) -> dict[str, object]:
        lines.append([part.name for part in parts])
        return {part.name: stage.run_in_child(part, True, None) for part in parts}

    monkeypatch.setattr(run, "at_once", at_once)
    by_name = ["first", "longest", "middle", "zero"]
    for jobs, order in (("2", ["longest", "middle", "first", "zero"]), ("1", by_name)):
        lines.clear()
        assert call(monkeypatch, "--quick", "--jobs", jobs) == 0
        assert lines == [order, []]


def test_an_interrupt_ends_all_parts(stage: Stage, monkeypatch: pytest.MonkeyPatch) -> None:
    ended = []
    began = threading.Event()

    def run_in_child(part: Part, quick: bool, tick: Callable[[], None]) -> dict[str, object]:
        if part.name == "first":
            began.wait(60)
            raise KeyboardInterrupt
        try:
            began.set()
            while True:
                tick()
                time.sleep(0.01)
        finally:
            ended.append(part.name)

    monkeypatch.setattr(child, "run_in_child", run_in_child)
    monkeypatch.setattr(run, "interrupted", threading.Event())
    with pytest.raises(KeyboardInterrupt):
        call(monkeypatch, "--jobs", "2")
    assert ended == ["second"]
