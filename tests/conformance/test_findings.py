"""The wall of findings: its page is as generated, a judge that stands alone confirms each witness,
and programs whose library is installed still show the fault."""

from __future__ import annotations

import re
import subprocess
import sys
from pathlib import Path

import pytest
from minkref.errors import Refusal
from minkref.fuzz.libraries import catalogue
from minkref.reports.findings import page
from minkref.reports.findings.command import arguments, shown
from minkref.reports.findings.entry import FOLDER, Entry, entries
from minkref.reports.findings.letter import letter
from minkref.reports.findings.reports import write_findings
from minkref.reports.findings.running import ABSENT, COMPILED, MENDED, STILL, Ran, ran

UNCOMPILED = [each for each in entries() if each.path.suffix not in COMPILED]


def test_page_and_pictures_are_those_of_the_file() -> None:
    """`python -m minkref.reports.findings.page` writes them again."""
    assert page.PAGE.read_text(encoding="utf-8") == page.page()
    drawn = {path.name: path.read_text(encoding="utf-8") for path in page.PICTURES.glob("*.svg")}
    assert drawn == page.pictures()


def test_a_judge_that_stands_alone_confirms_each_witness_in_the_plane() -> None:
    words = [sys.executable, "-I", str(FOLDER / "judge.py"), str(FOLDER / "findings.json")]
    done = subprocess.run(words, capture_output=True, text=True, check=True)
    planar = [e.id for e in entries() if e.witness and "vertices" not in e.case.get("P", {})]
    assert done.stdout.split("\n")[:-1] == [f"{name}: confirmed" for name in planar]
    assert "minkref" not in re.findall(r"^(?:from|import) (\w+)", (FOLDER / "judge.py").read_text())


def test_the_judge_refutes_a_witness_on_the_other_side(tmp_path: Path) -> None:
    text = (FOLDER / "findings.json").read_text(encoding="utf-8")
    turned = re.sub(r'"in_truth": (true|false)', swapped, text)
    (tmp_path / "turned.json").write_text(turned, encoding="utf-8")
    words = [sys.executable, "-I", str(FOLDER / "judge.py"), str(tmp_path / "turned.json")]
    done = subprocess.run(words, capture_output=True, text=True, check=False)
    assert done.returncode == 1
    assert "confirmed" not in done.stdout


def swapped(found: re.Match[str]) -> str:
    return f'"in_truth": {"false" if found[1] == "true" else "true"}'


def test_each_finding_is_whole() -> None:
    assert len({each.id for each in entries()}) == len(entries())
    programs = {each.program for each in entries()}
    assert programs == {path.name for path in (FOLDER / "programs").iterdir()}
    for each in entries():
        assert catalogue.is_named(each.adapter) or each.adapter.startswith("cgal-"), each.id
        assert "minkref" not in each.path.read_text(encoding="utf-8"), each.program
        assert each.verb in ("sum", "union", "offset", "inset", "path")
        assert each.issue is None or each.issue.startswith("https://github.com/")


@pytest.mark.parametrize("entry", UNCOMPILED, ids=lambda each: each.id)
def test_the_fault_still_shows(entry: Entry) -> None:
    found = ran(entry)
    if found.state == ABSENT:
        pytest.skip(found.said)
    assert found.state == STILL, found.said


def test_a_program_is_given_the_case_as_its_library_reads_it() -> None:
    given = {each.id: arguments(each) for each in entries()}
    assert given["cgal-hole-lost"] == [
        "299/100 199/100", "out", "3 0 0 7/12 0 7/12 7/12 0",
        "4 0 0 9 0 10 7 0 8 1 4 3 2 9 3 1 1 9 7", "reduced",
    ]  # fmt: skip
    assert given["geos-octagon"][-1] == "2.9"
    assert given["boost-geometry-signal"][:2] == ["0 0", "any"]
    assert given["boost-geometry-needle"][3] == (
        "MULTIPOLYGON (((0 4398046511104,0 4194304,2709985951448 4194304,0 4398046511104)))"
    )
    assert given["manifold-copy"][2].startswith('{"vertices":[[0.0,0.0,0.0],')


def test_a_program_that_breaks_shows_nothing(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    entry = next(each for each in UNCOMPILED if each.path.suffix == ".py")
    (tmp_path / "programs").mkdir()
    (tmp_path / "programs" / entry.program).write_text("import no_such_module\n")
    monkeypatch.setattr("minkref.reports.findings.entry.FOLDER", tmp_path)
    monkeypatch.setattr(catalogue, "absence", lambda _: None)
    monkeypatch.setattr(
        "minkref.reports.findings.running.installation.interpreter", lambda _: sys.executable
    )
    with pytest.raises(Refusal, match="no_such_module"):
        ran(entry)


def test_reports_to_send(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    states = dict.fromkeys((each.id for each in entries()), Ran(MENDED, "it prints this"))
    states[entries()[0].id] = Ran(STILL, "x: out")
    monkeypatch.setattr(
        "minkref.reports.findings.reports.ran", lambda entry, compiling: states[entry.id]
    )
    front = write_findings(tmp_path, True, lambda _: None, lambda: None)
    lines = front.read_text(encoding="utf-8").splitlines()[4:]
    assert [line.split("|")[-2].strip() for line in lines] == [
        STILL, *[MENDED] * (len(entries()) - 1),
    ]  # fmt: skip
    first = (tmp_path / f"finding-{entries()[0].id}.md").read_text(encoding="utf-8")
    assert first == letter(entries()[0], Ran(STILL, "x: out"))
    assert entries()[0].path.read_text(encoding="utf-8").rstrip() in first
    assert shown(entries()[0]) in first
