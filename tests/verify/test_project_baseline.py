"""The project's own baseline, and the known fault of CGAL 5.5 behind it."""

from __future__ import annotations

import json
from pathlib import Path

import pytest
from minkref import fuzz
from minkref.cli.cli import run
from minkref.fuzz.cgal.executables import OracleNotFoundError, cgal_version, target_names
from minkref.fuzz.verdicts.baseline import read_baseline
from minkref.fuzz.verdicts.verdict import Reason, Verdict
from thoroughness import draws

BASELINE = Path(fuzz.__file__).parent / "baseline.json"

# CGAL issue 5830: the right area is 438.125 with one hole; CGAL 5.5 answers 440.5 without a hole.
P = "POLYGON((0 0,20 0,20 20,0 20,0 0),(6 12,7 16,11 16,9 14,8 14,7 12,6 12))"
Q = "POLYGON((1 1,0 1,0 0,1 1))"


def test_every_entry_names_a_target_a_kind_and_a_reason() -> None:
    kinds = {str(kind) for kind in (*Reason, *Verdict)}
    for entry in read_baseline(BASELINE).entries:
        assert entry.kind in kinds
        assert len(entry.reason) > 20
        assert any(Path(name).match(entry.target) for name in target_names())


@pytest.fixture
def lost_hole(tmp_path: Path) -> str:
    try:
        version = cgal_version("reduced")
    except OracleNotFoundError:
        pytest.skip("the CGAL oracle is not built")
    if not version.startswith("5.5."):
        pytest.skip(f"CGAL {version} has this fault mended")
    (tmp_path / "P.wkt").write_text(P, encoding="utf-8")
    (tmp_path / "Q.wkt").write_text(Q, encoding="utf-8")
    return f"{tmp_path}/P.wkt+{tmp_path}/Q.wkt@1"


def test_lost_hole_of_cgal_is_wrong_with_a_program_and_known_with_the_baseline(
    lost_hole: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    report = tmp_path / "report"
    call = ["verify", "cgal-reduced", "--case", lost_hole, "--json", "--jobs", "1"]
    call += ["--shrink-calls", str(draws(5, 200))]
    assert run([*call, "--report", str(report)]) == 1
    finding = json.loads(capsys.readouterr().out)["findings"][0]
    assert finding["reasons"] == ["hole-lost"]
    assert finding["witness"]["in_truth"] is False
    program = (report / "cgal-reduced-hole-lost.cpp").read_text(encoding="utf-8")
    assert "CGAL::minkowski_sum_by_reduced_convolution_2" in program
    assert "minkref" not in program
    assert run([*call, "--baseline", str(BASELINE)]) == 0
    finding = json.loads(capsys.readouterr().out)["findings"][0]
    assert (finding["verdict"], finding["was"]) == ("known", "wrong")
    assert "5830" in finding["message"]
