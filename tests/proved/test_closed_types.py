"""Files that are not believed cannot make the proved checker accept: they hand over derivations in
closed types, whose numbers are of the kinds that the theorems are about."""

from __future__ import annotations

import importlib.util
import json
import re
import shutil
import subprocess
from pathlib import Path

import pytest
import squares
from minkref.reports.evidence.certificates.checkers import ROOT

BUILT = ROOT / "build" / "proofs"
DRIVER = ROOT / "oracle" / "proved" / "driver"
COUNTS = ROOT / "tools" / "scripts" / "trusted_lines.py"
PAGE = ROOT / "docs" / "proved.md"
DOUBTED = (
    "pieces", "elaborate", "moving", "classes", "rings", "faces", "theorem", "point_theorem",
    "cells", "ways", "hits",
)  # fmt: skip
#: What goes around types, or says a verdict
AROUND = re.compile(r"\b(Obj|external|Marshal|exit|Unix|Sys|std(?:out|err)|print_\w+|[ep]?rintf)\b")
PLACES = "[] -> Checked.origin | at -> Checked.corner at"
NOWHERE = "[] -> Checked.origin | at -> Checked.corner (List.map (fun _ -> (Q.{0}, Q.{0})) at)"


@pytest.fixture
def order() -> list[str]:
    script = (ROOT / "tools" / "scripts" / "proofs.sh").read_text(encoding="utf-8")
    (programs,) = re.findall(r"^programs=\(([^)]*)\)", script, re.MULTILINE)
    return str(programs).split()


def built(folder: Path, order: list[str], name: str, text: str) -> subprocess.CompletedProcess[str]:
    """The program with another text of one file; what comes before it is compiled already."""
    if shutil.which("ocamlfind") is None or not (BUILT / "main.cmx").exists():
        pytest.skip("OCaml or the compiled checker is absent: make proofs")
    for file in BUILT.iterdir():
        if file.suffix in (".ml", ".mli", ".cmi", ".cmx", ".o"):
            (folder / file.name).symlink_to(file)
    at = order.index(name)
    for later in order[at:]:
        for suffix in (".cmi", ".cmx", ".o"):
            (folder / (later + suffix)).unlink(missing_ok=True)
    (folder / f"{name}.ml").unlink()
    (folder / f"{name}.ml").write_text(text, encoding="utf-8")
    parts = [f"{part}.cmx" for part in order[:at]] + [f"{part}.ml" for part in order[at:]]
    command = ["ocamlfind", "ocamlopt", "-package", "zarith,unix", "-linkpkg", "-w", "-a"]
    return subprocess.run(
        [*command, *parts, "-o", "checker.exe"], cwd=folder, capture_output=True, text=True
    )


def test_only_what_is_believed_knows_the_extracted_types() -> None:
    for name in DOUBTED:
        text = re.sub(r"\(\*.*?\*\)", "", (DRIVER / f"{name}.ml").read_text(), flags=re.DOTALL)
        assert name == "theorem" or "Checker." not in text, name  # it writes down, and no way back
        found = AROUND.findall(text)
        assert found == [], (name, found)


def test_the_page_counts_all_that_is_believed() -> None:
    """`tools/scripts/trusted_lines.py --write` counts: every file of the driver that is not listed
    as doubted, and every definition."""
    spec = importlib.util.spec_from_file_location("trusted_lines", COUNTS)
    assert spec is not None and spec.loader is not None
    counts = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(counts)
    page = PAGE.read_text(encoding="utf-8")
    assert counts.written(page) == page and counts.table() in page
    assert counts.DOUBTED == set(DOUBTED)


@pytest.mark.parametrize("number", ["inf", "undef", "minus_inf"])
def test_a_denominator_of_zero_proves_nothing(
    order: list[str], tmp_path: Path, number: str
) -> None:
    """A wrong line in a file that is not believed, for zarith's 1/0, 0/0 and -1/0."""
    text = (DRIVER / "elaborate.ml").read_text(encoding="utf-8")
    assert PLACES in text
    folder = tmp_path / "built"
    folder.mkdir()
    ran = built(folder, order, "elaborate", text.replace(PLACES, NOWHERE.format(number)))
    assert ran.returncode == 0, ran.stderr
    (tmp_path / "case.json").write_text(json.dumps(squares.CASE), encoding="utf-8")
    path = tmp_path / "it.cert.json"
    path.write_text(json.dumps(squares.certificate()), encoding="utf-8")
    told = subprocess.run([folder / "checker.exe", path], capture_output=True, text=True)
    assert told.returncode == 2 and "no positive denominator" in told.stdout


@pytest.mark.parametrize(
    "made", ["(Checker.Fixed zero, Checker.Fixed zero)", "(Obj.magic 0 : Checker.corner)"]
)
def test_the_extracted_types_are_no_derivation(order: list[str], tmp_path: Path, made: str) -> None:
    """The compiler refuses a corner that no function of `checked.mli` has made."""
    text = (DRIVER / "elaborate.ml").read_text(encoding="utf-8")
    zero = "let zero : Checker.q = { qnum = Z.zero; qden = Z.zero } in"
    ran = built(tmp_path, order, "elaborate", text.replace(PLACES, f"_ -> {zero} {made}"))
    assert ran.returncode != 0
    assert "but an expression was expected of type" in ran.stderr and "Checked.corner" in ran.stderr
