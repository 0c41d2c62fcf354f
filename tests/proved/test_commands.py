"""`minkref check --proved` and `minkref certify --theorem`."""

from __future__ import annotations

import gzip
import json
import shutil
import subprocess
import sys
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
import squares
import touching
from minkref import proved_program
from minkref.cli.cli import run
from minkref.reports.evidence.certificates.checkers import ROOT

HOLED = "POLYGON((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 1 3, 3 3, 3 1, 1 1))"


@pytest.fixture
def holed(tmp_path: Path) -> str:
    path = tmp_path / "holed.wkt"
    path.write_text(HOLED, encoding="utf-8")
    return str(path)


@pytest.fixture
def square(tmp_path: Path) -> Path:
    (tmp_path / "case.json").write_text(json.dumps(squares.CASE), encoding="utf-8")
    path = tmp_path / "it.cert.json"
    path.write_text(json.dumps(squares.certificate()), encoding="utf-8")
    return path


@pytest.mark.usefixtures("proved")
def test_what_is_proved_and_what_is_not(square: Path, capsys: Any) -> None:
    assert run(["check", str(square), "--proved"]) == 0
    said = capsys.readouterr().out
    assert "  proved: sum: at 1" in said and "in canonical form" in said
    assert "not proved" not in said
    assert run(["check", str(square), "--proved", "--json", "--case", str(square)]) == 2
    (row,) = json.loads(capsys.readouterr().out)["files"]
    assert row["verdict"] == "malformed" and "proved" not in row


@pytest.mark.usefixtures("proved")
@pytest.mark.parametrize("member", ["components", "holes"])
def test_other_counts_are_refuted(square: Path, member: str) -> None:
    """By the other checker, which goes first."""
    value = squares.certificate()
    value["claims"][0][member] += 1
    square.write_text(json.dumps(value), encoding="utf-8")
    assert run(["check", str(square), "--proved"]) == 1


@pytest.mark.usefixtures("proved")
def test_a_claim_without_a_theorem_is_declined(square: Path, capsys: Any) -> None:
    square.with_name("case.json").write_text(json.dumps(touching.CASE), encoding="utf-8")
    square.write_text(json.dumps(touching.certificate()), encoding="utf-8")
    assert run(["check", str(square)]) == 0
    capsys.readouterr()
    assert run(["check", str(square), "--proved", "--json"]) == 5
    (row,) = json.loads(capsys.readouterr().out)["files"]
    assert row["verdict"] == "declined" and row["proved"] == []
    assert row["not_proved"] == row["claims"] != [] and row["checked"] == "verified"
    assert run(["check", str(square), "--proved"]) == 5
    assert "  by check.py: " in capsys.readouterr().out
    # Refuted is worse than declined.
    assert run(["check", str(square), str(square.with_name("nowhere")), "--proved"]) == 2


VERDICT = ": verified{0}  sum: at 1, the set of points{0}: verified"


@pytest.mark.usefixtures("proved")
@pytest.mark.parametrize(
    "end", ["\u2028", "\u2029", "\x85", "\n", "\x0b", "\udcff", "\u2028\udcff"]
)
def test_a_name_proves_nothing(square: Path, capsys: Any, end: str) -> None:
    """A name that has a verdict on lines of its own, and bytes that are no text."""
    value, case = touching.certificate(), json.dumps(touching.CASE)
    (square.parent / "touching.case.json").write_text(case, encoding="utf-8")
    value["case"]["path"] = "touching.case.json"
    named = square.with_name(VERDICT.format(end) + ".cert.json")
    named.write_text(json.dumps(value), encoding="utf-8")
    assert run(["check", str(named), str(square), "--proved", "--json"]) == 5
    first, second = json.loads(capsys.readouterr().out)["files"]
    assert (first["verdict"], first["proved"]) == ("declined", [])
    assert (second["verdict"], len(second["proved"])) == ("verified", 1)
    named.write_text(square.read_text(encoding="utf-8"), encoding="utf-8")
    assert run(["check", str(named), "--proved"]) == 0
    said = capsys.readouterr().out.splitlines()
    assert sum("proved: sum: at 1" in line for line in said) == 1


@pytest.mark.usefixtures("proved")
@pytest.mark.parametrize("names", [["it.cert.json"], ["case.json"], ["it.cert.json", "case.json"]])
def test_what_is_compressed_is_unpacked(square: Path, capsys: Any, names: list[str]) -> None:
    for name in names:
        file = square.with_name(name)
        file.write_bytes(gzip.compress(file.read_bytes()))
    assert run(["check", str(square), "--proved"]) == 0
    assert "  proved: sum: at 1" in capsys.readouterr().out


def test_without_the_program(square: Path, capsys: Any, monkeypatch: Any) -> None:
    monkeypatch.setattr(proved_program, "PROGRAM", "minkref-no-such-program")
    assert run(["check", str(square), "--proved"]) == 2
    assert "make proofs" in capsys.readouterr().err


@pytest.mark.parametrize(
    ("options", "why"),
    [
        (["--from", "1", "--to", "2", "--theorem", "it.v"], "a theorem is about a sum, or a point"),
        (["--event", "2", "--theorem", "it.v"], "a theorem is about a sum, or a point"),
        (["--theorem", "it.txt"], "not the name of a file of Coq"),
        (["--theorem", "1.v"], "not the name of a file of Coq"),
    ],
)
def test_no_theorem(holed: str, tmp_path: Path, capsys: Any, options: list[str], why: str) -> None:
    assert run(["certify", holed, holed, *options, "-o", str(tmp_path / "it.cert.json")]) == 2
    assert why in capsys.readouterr().err
    assert not (tmp_path / "it.cert.json").exists()


def test_a_program_that_a_signal_ends_proves_nothing(
    square: Path, capsys: Any, monkeypatch: Any
) -> None:
    """As where memory ends; a program that answers anything else is an internal error."""
    killed = square.with_name("killed")
    killed.write_text("#!/bin/sh\nkill -9 $$\n", encoding="utf-8")
    killed.chmod(0o755)
    monkeypatch.setattr(proved_program, "program", lambda *_: str(killed))
    assert run(["check", str(square), str(square), "--proved"]) == 4
    assert capsys.readouterr().out.count("out of budget: a signal ended") == 2
    killed.write_text("#!/bin/sh\necho it.cert.json: verified\n", encoding="utf-8")
    assert run(["check", str(square), "--proved"]) == 70


@pytest.mark.parametrize("command", ["check", "point"])
def test_a_program_ends_with_the_command_that_runs_it(square: Path, command: str) -> None:
    slow, number = square.with_name("slow"), square.with_name("number")
    slow.write_text(f"#!/bin/sh\necho $$ >{number}.new\nmv {number}.new {number}\nexec sleep 60\n")
    slow.chmod(0o755)
    box = "POLYGON((0 0,1 0,1 1,0 0))"
    words = ["check", str(square)] if command == "check" else ["point", box, box, "--at", "0,0"]
    told = f"""
from minkref import proved_program
from minkref.cli.cli import run
proved_program.program = lambda *_: {str(slow)!r}
raise SystemExit(run({[*words, "--proved"]}))
"""
    with subprocess.Popen([sys.executable, "-c", told], stdout=subprocess.DEVNULL) as running:
        assert waited(number.exists)
        running.terminate()
    assert running.returncode != 0
    assert waited(lambda: not Path(f"/proc/{number.read_text().strip()}").exists())


def waited(is_so: Callable[[], bool], seconds: float = 20) -> bool:
    end = time.monotonic() + seconds
    while not is_so() and time.monotonic() < end:
        time.sleep(0.02)
    return is_so()


def test_of_several_sums_there_is_no_theorem(proved: list[str], square: Path) -> None:
    value = squares.certificate()
    value["claims"].append({**squares.CLAIM, "scale": "1.0"})
    square.write_text(json.dumps(value), encoding="utf-8")
    theorem = square.with_name("it.v")
    command = [*proved, f"--theorem={theorem}", str(square)]
    ran = subprocess.run(command, capture_output=True, text=True)
    assert ran.returncode == 2 and "several sums or points" in ran.stdout
    assert not theorem.exists()


@pytest.mark.usefixtures("proved")
def test_a_compressed_certificate_has_the_same_theorem(holed: str, tmp_path: Path) -> None:
    texts = []
    for name in ("it.cert.json", "packed.cert.json.gz"):
        theorem = tmp_path / "it.v"
        out = ["-o", str(tmp_path / name), "--theorem", str(theorem)]
        assert run(["certify", holed, holed, "--scale", "1/5", *out]) == 0
        texts.append(theorem.read_text(encoding="utf-8"))
    assert texts[0] == texts[1] != ""


def compiled(theorem: Path) -> subprocess.CompletedProcess[str]:
    coqc = shutil.which("coqc")
    if coqc is None or not (ROOT / "build" / "proofs" / "Canonical.vo").exists():
        pytest.skip("coqc or the compiled proofs are absent: make proofs")
    command = [coqc, "-q", "-Q", str(ROOT / "build" / "proofs"), "Proved", theorem.name]
    return subprocess.run(command, cwd=theorem.parent, capture_output=True, text=True)


@pytest.mark.usefixtures("proved")
def test_a_theorem_is_taken_by_coq_and_a_false_one_is_not(holed: str, tmp_path: Path) -> None:
    """The sum of a square ring and a smaller one, which has a hole."""
    theorem, out = tmp_path / "it.v", tmp_path / "it.cert.json"
    options = ["--scale", "1/5", "-o", str(out), "--theorem", str(theorem)]
    assert run(["certify", holed, holed, *options]) == 0
    text = theorem.read_text(encoding="utf-8")
    ran = compiled(theorem)
    assert ran.returncode == 0, ran.stderr
    assert "functional_extensionality" in ran.stdout
    it = "(set_of (rings_of (figure R')))"
    for old, new in (
        ("(24#5, 0#1)", "(23#5, 0#1)"),
        (f"has_components {it} 1", f"has_components {it} 2"),
        (f"has_holes {it} 1", f"has_holes {it} 0"),
        ("size := 1%nat", "size := 0%nat"),
    ):
        assert old in text
        theorem.write_text(text.replace(old, new, 1), encoding="utf-8")
        assert compiled(theorem).returncode != 0, new


@pytest.mark.usefixtures("proved")
@pytest.mark.parametrize(
    ("point", "other", "said"),
    [("1,1", "(12#5, 12#5)", "this_point_is_inside"), ("12/5,12/5", "(1#1, 1#1)", "~ exists p q")],
)
def test_a_point_is_a_theorem_too(
    holed: str, tmp_path: Path, point: str, other: str, said: str
) -> None:
    """In the sum, or not; with the other point the same proof is none."""
    theorem, out = tmp_path / "it.v", tmp_path / "it.cert.json"
    options = ["--scale", "1/5", "--point", point, "-o", str(out), "--theorem", str(theorem)]
    assert run(["certify", holed, holed, *options]) == 0
    text = theorem.read_text(encoding="utf-8")
    ran = compiled(theorem)
    assert said in text and ran.returncode == 0, ran.stderr
    x, y = (f"{n}#{d or 1}" for n, _, d in (part.partition("/") for part in point.split(",")))
    assert f"x : vertex := ({x}, {y})" in text
    theorem.write_text(text.replace(f"({x}, {y})", other, 1), encoding="utf-8")
    assert compiled(theorem).returncode != 0
