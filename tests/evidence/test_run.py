"""`make evidence` itself: exit codes, the steps that run, and the summary that is written."""

from __future__ import annotations

import json
import shutil
import sys
import threading
import time
from collections.abc import Callable
from pathlib import Path

import pytest

pytest.importorskip("minkref._core", reason="the extension module is not built")

from minkref.reports.evidence import run
from minkref.reports.evidence.framework import child, places, recorded, store
from minkref.reports.evidence.framework.part import Findings, Minutes, Size
from minkref.reports.evidence.framework.steps import Step


class Stage:
    """Three steps of two parts, the last without a quick form, and what their runs give."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.ran: list[str] = []
        self.outcome: dict[str, str] = {}
        self.steps = [
            Step("first/a", Minutes(0.1, 0.5, 1.0)),
            Step("first/b", Minutes(0.1, 0.5, 1.0)),
            Step("second/a", Minutes(None, 0.5, 1.0)),
        ]

    def run_in_child(self, step: Step, size: Size, tick: object) -> store.Document:
        self.ran.append(step.name)
        found = Findings()
        found.law("one is one", True, 1, 1)
        outcome = self.outcome.get(step.name, "met")
        if outcome == "missed":
            found.target("speed", False, 1, 2)
        error = "RuntimeError: broke down" if outcome == "error" else ""
        document = child.document_of(step, size, found, 62.0, error)
        document |= {"files": store.hashes([f"{step.name}.cpp"]), "commit": "0123456789"}
        store.write(document)
        return document

    def change(self, step: str, text: str) -> None:
        path = self.folder / f"{step}.cpp"
        path.parent.mkdir(exist_ok=True)
        path.write_text(text)
        for cache in (recorded.known, store.hash_of, store.files_below):
            cache.cache_clear()

    @property
    def summary(self) -> str:
        return (self.folder / "SUMMARY.md").read_text()


@pytest.fixture
def stage(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Stage:
    made = Stage(tmp_path)
    monkeypatch.setattr(places, "FOLDER", tmp_path / "build")
    monkeypatch.setattr(places, "ROOM", tmp_path)
    monkeypatch.setattr(places, "ROOT", tmp_path)
    monkeypatch.setattr(run, "steps", lambda: made.steps)
    monkeypatch.setattr(run, "claim", lambda part: f"The claim of {part}.")
    monkeypatch.setattr(child, "run_in_child", made.run_in_child)
    for name in ("QUICK", "FULL"):
        monkeypatch.delenv(name, raising=False)
    monkeypatch.setenv(recorded.MODELS, str(tmp_path))
    (tmp_path / "build").mkdir()
    for step in made.steps:
        made.change(step.name, "1")
    return made


def call(monkeypatch: pytest.MonkeyPatch, *arguments: str) -> int:
    monkeypatch.setattr(sys, "argv", ["run.py", *arguments])
    return run.main()


def test_missed_target_does_not_fail_the_run(stage: Stage, monkeypatch: pytest.MonkeyPatch) -> None:
    stage.outcome["first/b"] = "missed"
    assert call(monkeypatch) == 0
    assert "| [first](#first) | missed | whole | 01234567 |" in stage.summary


def test_error_fails_the_run_and_the_other_steps_run(
    stage: Stage, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    stage.outcome["first/a"] = "error"
    assert call(monkeypatch) == 1
    out = capsys.readouterr().out.splitlines()
    assert out[0] == "3 steps of whole size, some 2 minutes; 0 are kept"
    assert out[-1] == "failed: first/a: RuntimeError: broke down"
    assert stage.ran == ["first/a", "first/b", "second/a"]
    assert "Broke down: `RuntimeError: broke down`" in stage.summary


def test_a_run_goes_on_with_the_steps_that_failed_or_whose_files_changed(
    stage: Stage, monkeypatch: pytest.MonkeyPatch
) -> None:
    stage.outcome["first/a"] = "error"
    assert call(monkeypatch) == 1
    stage.outcome.clear()
    assert call(monkeypatch) == 0
    stage.change("second/a", "2")
    assert call(monkeypatch) == 0
    assert stage.ran == ["first/a", "first/b", "second/a", "first/a", "second/a"]


@pytest.mark.parametrize("way", ["QUICK", "--quick"])
def test_quick_run_writes_no_committed_summary(
    stage: Stage, monkeypatch: pytest.MonkeyPatch, way: str
) -> None:
    if way == "QUICK":
        monkeypatch.setenv("QUICK", "1")
    assert call(monkeypatch, *([way] if way != "QUICK" else [])) == 0
    assert sorted(stage.ran) == ["first/a", "first/b"]
    assert not (stage.folder / "SUMMARY.md").exists()
    text = (stage.folder / "build" / "summary-quick.md").read_text()
    assert "| [first](#first) | met | quick |" in text


def test_a_full_result_serves_all_sizes(stage: Stage, monkeypatch: pytest.MonkeyPatch) -> None:
    assert call(monkeypatch, "--full") == 0
    assert call(monkeypatch) == 0
    assert call(monkeypatch, "--quick") == 0
    assert len(stage.ran) == 3
    assert "| [second](#second) | met | full |" in stage.summary


def test_only_named_parts_and_steps_are_run_and_the_summary_keeps_the_others(
    stage: Stage, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert call(monkeypatch, "second", "first/b") == 0
    assert "| [first](#first) | met, 1 of 2 steps |" in stage.summary
    assert call(monkeypatch, "first") == 0
    assert stage.ran == ["first/b", "second/a", "first/a"]
    assert "| [first](#first) | met | " in stage.summary
    assert "| [second](#second) | met | " in stage.summary


def test_in_a_fresh_clone_the_summary_keeps_what_others_have_reached(
    stage: Stage, monkeypatch: pytest.MonkeyPatch
) -> None:
    stage.outcome["second/a"] = "missed"
    assert call(monkeypatch, "second") == 0
    for _ in range(2):  # and in the clone of the clone
        shutil.rmtree(stage.folder / "build")
        (stage.folder / "build").mkdir()
        assert call(monkeypatch, "first") == 0
        assert "| [first](#first) | met |" in stage.summary
        assert "| [second](#second) | missed | whole | 01234567 |" in stage.summary
        assert stage.summary.count("\n## second\n\nThe claim of second.\n") == 1
        assert "| speed (target) | 1 | 2 | missed |" in stage.summary
        rests_on = json.loads((stage.folder / "rests_on.json").read_text())
        assert rests_on["rows"] == ["first", "second"]
        assert rests_on["files"]["second/a.cpp"] == [1]


def test_stale_parts_are_told_by_hash_here_and_by_commit_elsewhere(
    stage: Stage, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    changed: dict[str, list[str] | None] = {"01234567": ["docs/a.md"]}
    monkeypatch.setattr(store, "changed_since", lambda commit: changed.get(commit))
    assert call(monkeypatch) == 0

    def told(*arguments: str) -> list[str]:
        capsys.readouterr()
        assert call(monkeypatch, "--stale", *arguments) == 0
        return [line.partition(":")[0] for line in capsys.readouterr().out.splitlines()]

    assert told() == []
    assert told(str(stage.folder / "first/b.cpp"), "elsewhere.cpp") == ["first"]
    stage.change("second/a", "2")
    assert told() == ["second"]
    shutil.rmtree(stage.folder / "build")
    assert told() == []  # as far as git says
    changed["01234567"] = ["first/a.cpp", "docs/a.md"]
    assert told() == ["first"]
    changed.clear()  # a commit that nobody has
    assert told() == ["first", "second"]


def test_only_what_has_changed_is_run_where_that_is_asked_for(
    stage: Stage, monkeypatch: pytest.MonkeyPatch
) -> None:
    """As continuous integration does, in a clone without results. A new step runs as well."""
    changed: dict[str, list[str] | None] = {"01234567": ["docs/a.md"]}
    monkeypatch.setattr(store, "changed_since", lambda commit: changed.get(commit))
    assert call(monkeypatch) == 0

    def ran() -> list[str]:
        shutil.rmtree(stage.folder / "build")
        stage.ran.clear()
        assert call(monkeypatch, "--quick", "--changed", "--jobs", "1") == 0
        return stage.ran

    assert ran() == []
    changed["01234567"] = ["second/a.cpp"]
    assert ran() == [], "it has no quick form"
    changed["01234567"] = ["first/b.cpp"]
    assert ran() == ["first/a", "first/b"], "their row is one"
    changed["01234567"] = []
    stage.steps.append(Step("third/a", Minutes(0.1, 0.5, 1.0)))
    stage.change("third/a", "1")
    assert ran() == ["third/a"]
    stage.outcome["second/a"] = "error"
    assert call(monkeypatch, "--again", "second/a") == 1
    stage.outcome.clear()
    stage.steps[2] = Step("second/a", Minutes(0.1, 0.5, 1.0))
    assert ran() == ["second/a", "third/a"], "what has failed is run until it does not"
    changed.clear()
    assert sorted(ran()) == [step.name for step in stage.steps], "nobody knows what has changed"


def test_a_row_is_of_the_last_commit_at_which_its_files_were_as_in_the_run(
    stage: Stage, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(store, "changed_since", lambda commit: [])
    assert call(monkeypatch) == 0
    monkeypatch.setattr(store, "commit_of", lambda names: "fedcba9876")
    stage.change("second/a", "2")
    assert call(monkeypatch, "first") == 0
    assert "| [first](#first) | met | whole | fedcba98 |" in stage.summary
    assert "| [second](#second) | met | whole | 01234567 |" in stage.summary
    capsys.readouterr()
    assert call(monkeypatch, "--stale") == 0
    assert capsys.readouterr().out.startswith("second: ")


def test_a_step_that_runs_in_full_only_has_a_row_of_its_own(
    stage: Stage, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    """Otherwise the step's old result would make its part's result one of several commits, and
    stale."""
    monkeypatch.setattr(store, "changed_since", lambda commit: [])
    stage.steps.append(Step("second/hours", Minutes(None, None, 60.0)))
    stage.change("second/hours", "1")
    assert call(monkeypatch, "--full", "second/hours") == 0
    assert call(monkeypatch) == 0
    assert "| [second](#second) | met | whole | 01234567 |" in stage.summary
    assert "| [second/hours](#secondhours) | met | full | 01234567 |" in stage.summary
    stage.change("second/hours", "2")
    capsys.readouterr()
    assert call(monkeypatch, "--stale") == 0
    assert [line.partition(":")[0] for line in capsys.readouterr().out.splitlines()] == [
        "second/hours"
    ]


def test_without_the_models_of_the_paper_only_what_is_here_is_asked(
    stage: Stage, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    name = f"{recorded.MODELS}/bird.poly"
    document = {"files": {name: "0123"}}
    monkeypatch.delenv(recorded.MODELS)
    assert not store.is_current(document)
    assert store.is_current(document, with_models=False)
    assert call(monkeypatch) == 0
    capsys.readouterr()
    assert call(monkeypatch, "--stale") == 0
    assert capsys.readouterr().out.startswith("MINKREF_MODELS is not set: ")


def test_unknown_names_and_two_sizes_are_wrong_usage(
    stage: Stage, monkeypatch: pytest.MonkeyPatch
) -> None:
    assert call(monkeypatch, "third") == 2
    with pytest.raises(SystemExit, match="2"):
        call(monkeypatch, "--quick", "--full")
    assert stage.ran == []


def test_steps_that_run_alone_have_nothing_beside_them(
    stage: Stage, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Two other steps are under way together: each waits for the other."""
    meeting = threading.Barrier(2, timeout=60)
    under_way: set[str] = set()
    beside: dict[str, set[str]] = {}

    def run_in_child(step: Step, size: Size, tick: object) -> store.Document:
        under_way.add(step.name)
        if not step.alone:
            meeting.wait()
        beside[step.name] = under_way - {step.name}
        if not step.alone:
            meeting.wait()
        under_way.remove(step.name)
        return Stage.run_in_child(stage, step, size, tick)

    stage.steps.append(Step("first/timed", Minutes(0.1, 0.5, 1.0), alone=True))
    stage.change("first/timed", "1")
    monkeypatch.setattr(child, "run_in_child", run_in_child)
    assert call(monkeypatch, "--quick", "--jobs", "2") == 0
    assert beside == {"first/a": {"first/b"}, "first/b": {"first/a"}, "first/timed": set()}


def test_of_steps_at_once_the_longest_begin_first(
    stage: Stage, monkeypatch: pytest.MonkeyPatch
) -> None:
    """Otherwise a core waits at the end for a late step; one job at a time takes steps by name."""
    stage.steps = [
        Step(f"first/{name}", Minutes(quick, 2.0 - quick, 3.0))
        for name, quick in (("longest", 1.5), ("middle", 0.7), ("zero", 0.1))
    ]
    lines: list[list[str]] = []

    def at_once(chosen: list[Step], *_: object) -> dict[str, store.Document]:
        lines.append([step.name.partition("/")[2] for step in chosen])
        return {step.name: stage.run_in_child(step, Size.QUICK, None) for step in chosen}

    monkeypatch.setattr(run, "at_once", at_once)
    by_name = ["longest", "middle", "zero"]
    for jobs, order in (("2", by_name), ("1", by_name)):
        lines.clear()
        assert call(monkeypatch, "--quick", "--again", "--jobs", jobs) == 0
        assert lines == [order, []]
    lines.clear()
    assert call(monkeypatch, "--again", "--jobs", "2") == 0
    assert lines == [by_name[::-1], []]


def test_an_interrupt_ends_all_steps(stage: Stage, monkeypatch: pytest.MonkeyPatch) -> None:
    ended = []
    began = threading.Event()

    def run_in_child(step: Step, size: Size, tick: Callable[[], None]) -> store.Document:
        if step.name == "first/a":
            began.wait(60)
            raise KeyboardInterrupt
        try:
            began.set()
            while True:
                tick()
                time.sleep(0.01)
        finally:
            ended.append(step.name)

    monkeypatch.setattr(child, "run_in_child", run_in_child)
    monkeypatch.setattr(run, "interrupted", threading.Event())
    with pytest.raises(KeyboardInterrupt):
        call(monkeypatch, "first", "--jobs", "2")
    assert ended == ["first/b"]
