"""The GitHub Action's step, run as written, without GitHub."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
FAULTY = ROOT / "tests" / "verify"
WRITTEN = ("junit.xml", "results.sarif", "summary.md", "findings.jsonl", "index.html")


def step(folder: Path, **variables: str) -> subprocess.CompletedProcess[str]:
    environment = {
        **os.environ,
        "PATH": f"{Path(sys.executable).parent}{os.pathsep}{os.environ['PATH']}",
        "PYTHONPATH": str(FAULTY),
        "SECONDS_GIVEN": "1",
        "ARGUMENTS": "--no-models --family random --shrink-calls 5 --jobs 1",
        "GITHUB_STEP_SUMMARY": str(folder / "step.md"),
        **variables,
    }
    return subprocess.run(
        [ROOT / "tools" / "scripts" / "verify_in_ci.sh"],
        cwd=folder,
        env=environment,
        capture_output=True,
        text=True,
        timeout=300,
    )


@pytest.mark.parametrize(("target", "code"), [("right", 0), ("nothing", 1), ("raises", 3)])
def test_step_exits_as_verify_and_leaves_its_reports(
    tmp_path: Path, target: str, code: int
) -> None:
    ran = step(tmp_path, TARGETS=f"py:faulty_sums:{target} minkref:paper")
    assert ran.returncode == code, ran.stderr
    report = tmp_path / "minkref-report"
    assert all((report / name).is_file() for name in WRITTEN)
    assert (tmp_path / "step.md").read_text(encoding="utf-8").startswith("# minkref verify")
    last = (report / "findings.jsonl").read_text(encoding="utf-8").splitlines()[-1]
    assert json.loads(last)["exit_code"] == code


def test_baseline_makes_new_faults_alone_fail(tmp_path: Path) -> None:
    entry = {
        "target": "py:faulty_sums:*",
        "version": "*",
        "kind": "component",
        "reason": "known to us",
    }
    baseline = {"baseline": "baseline-v1", "entries": [entry]}
    (tmp_path / "known.json").write_text(json.dumps(baseline), encoding="utf-8")
    ran = step(tmp_path, TARGETS="py:faulty_sums:nothing", BASELINE="known.json")
    assert ran.returncode == 0, ran.stdout + ran.stderr


def test_step_reads_all_lines_of_targets_and_of_arguments(tmp_path: Path) -> None:
    """Passes several lines with mixed line ends, as workflows write them."""
    targets = "\n\npy:faulty_sums:right\r\nminkref:paper \n\t*\r\n"
    arguments = "\r\n--pairs\n2 --no-models \n\t--family random\n\n"
    (tmp_path / "a file").touch()
    ran = step(tmp_path, TARGETS=targets.replace("*", "minkref:winding"), ARGUMENTS=arguments)
    assert ran.returncode == 0, ran.stderr
    rows = (tmp_path / "minkref-report" / "findings.jsonl").read_text(encoding="utf-8")
    run = json.loads(rows.splitlines()[0])
    names = [row["name"] for row in run["targets"]]
    assert names == ["py:faulty_sums:right", "minkref:paper", "minkref:winding"]
    assert [group["name"] for group in run["groups"]] == ["random"]
    starred = step(tmp_path, TARGETS=targets, ARGUMENTS=arguments)
    assert starred.returncode == 2 and "*" in starred.stderr, "no pattern of file names"


def test_step_without_targets_says_so(tmp_path: Path) -> None:
    (tmp_path / "pyproject.toml").write_text("[tool.other]\nx = 1\n", encoding="utf-8")
    ran = step(tmp_path, TARGETS="")
    assert ran.returncode == 2
    assert "name the targets" in ran.stderr


@pytest.mark.parametrize(
    ("file", "head"), [("minkref.toml", ""), ("pyproject.toml", "[tool.minkref]\n")]
)
def test_step_takes_the_targets_of_the_settings(tmp_path: Path, file: str, head: str) -> None:
    text = f'{head}targets = ["py:faulty_sums:nothing"]\npairs = 4\nseed = 7\n'
    (tmp_path / file).write_text(text, encoding="utf-8")
    ran = step(tmp_path, TARGETS="", SECONDS_GIVEN="")
    assert ran.returncode == 1, ran.stderr
    assert f"settings: {file}" in ran.stdout
    assert "4 cases, 1 target" in ran.stdout


def test_action_gives_every_input_to_the_step() -> None:
    text = (ROOT / "action.yml").read_text(encoding="utf-8")
    script = (ROOT / "tools" / "scripts" / "verify_in_ci.sh").read_text(encoding="utf-8")
    for name in ("TARGETS", "SECONDS_GIVEN", "SEED", "BASELINE", "ARGUMENTS", "REPORT"):
        assert f"{name}: ${{{{ inputs." in text
        assert name in script
