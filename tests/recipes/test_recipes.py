"""Each recipe of CONTRIBUTING is followed: so many files are touched, and the addition works."""

from __future__ import annotations

import json
import os
import subprocess
from collections.abc import Iterator
from pathlib import Path

import pytest
from minkref.reports.evidence.framework.places import ROOT
from minkref.reports.evidence.house.followed import PATCHES, environment, files_of, follow

TOUCHED = {"claim": 1, "mesh_format": 6, "route": 4, "setting": 5}
SHARED = 2  # files of all settings among those that a new setting touches


@pytest.fixture(scope="module")
def checkout() -> Iterator[Path]:
    """A checkout with all recipes followed; beside the sources, for hard links."""
    folder = ROOT / "build" / f"recipes-{os.getpid()}"
    follow(sorted(TOUCHED), folder)
    yield folder
    subprocess.run(["rm", "-r", folder], check=True)


def test_each_patch_is_counted() -> None:
    assert {path.stem for path in PATCHES.glob("*.patch")} == set(TOUCHED)
    assert {recipe: len(files_of(recipe)) for recipe in TOUCHED} == TOUCHED
    assert sum((ROOT / file).exists() for file in files_of("setting")) == SHARED


def test_a_claim_is_a_step_of_the_evidence(checkout: Path) -> None:
    pytest.importorskip("minkref._core", reason="the extension module is not built")
    run = "from minkref.reports.evidence.plane_sums import commuting\n"
    run += "from minkref.reports.evidence.framework.part import Findings, Size\n"
    run += "findings = Findings(); commuting.run(findings, Size.QUICK); print(findings.checks)\n"
    there = environment(checkout, ROOT / "build" / "release")
    python = ROOT / ".venv" / "bin" / "python"
    done = subprocess.run([python, "-c", run], env=there, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    assert "order" in done.stdout and "met=True" in done.stdout


def test_a_fifth_setting_is_answered_and_refuses_the_options_of_others(checkout: Path) -> None:
    pytest.importorskip("minkref._core", reason="the extension module is not built")
    there = environment(checkout, ROOT / "build" / "release")
    words = [ROOT / ".venv/bin/python", "-m", "minkref", "sum", "interval:0,1", "interval:2,5"]
    asked = [*words, "--scale", "2", "--json"]
    done = subprocess.run(asked, env=there, capture_output=True, text=True)
    assert json.loads(done.stdout)["result"] == ["2", "7"], done.stderr
    refused = subprocess.run([*words, "--plot"], env=there, capture_output=True, text=True)
    assert refused.returncode == 2
    assert "`minkref sum` does not have this option on the line" in refused.stderr
