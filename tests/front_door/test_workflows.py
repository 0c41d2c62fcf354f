"""Workflows on GitHub: actions by commit, least permissions, a time limit for each job, and
commands that people can call."""

from __future__ import annotations

import json
import os
import re
import subprocess
import sys
import tomllib
from pathlib import Path
from typing import Any

import pytest
import yaml

ROOT = Path(__file__).resolve().parents[2]
TOOLS = Path(sys.executable).parent
WORKFLOWS = sorted(ROOT.glob(".github/workflows/*.yml"))
#: Jobs that may do more than read the repository.
MAY_WRITE = {
    ("release.yml", "publish"): {"contents": "write", "id-token": "write", "attestations": "write"}
}


def read(file: Path) -> dict[Any, Any]:
    workflow: dict[Any, Any] = yaml.safe_load(file.read_text(encoding="utf-8"))
    return workflow


def steps(workflow: dict[Any, Any]) -> list[dict[str, Any]]:
    return [step for job in workflow["jobs"].values() for step in job.get("steps", [])]


def lines(workflow: dict[Any, Any]) -> list[str]:
    """The commands of all steps, line by line."""
    return [line for step in steps(workflow) for line in step.get("run", "").splitlines()]


def test_there_are_workflows() -> None:
    names = ["ci.yml", "nightly.yml", "packages.yml", "release.yml"]
    assert [file.name for file in WORKFLOWS] == names
    ci, nightly, *_ = (read(file) for file in WORKFLOWS)
    assert nightly[True]["schedule"], "`on` is a word for true in YAML"
    assert {"bash .ci/run", "make test-clang", "make docs"} <= set(lines(ci)), "two compilers"
    assert "make test-flushed" in lines(nightly)


def test_workflows_are_what_their_schema_says() -> None:
    schema = ("--builtin-schema", "vendor.github-workflows")
    command = [TOOLS / "check-jsonschema", *schema, *WORKFLOWS]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr


def test_zizmor_finds_nothing() -> None:
    files = [*WORKFLOWS, ROOT / "action.yml"]
    command = [TOOLS / "zizmor", "--offline", "--quiet", "--no-progress", *files]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr


@pytest.mark.parametrize("file", WORKFLOWS, ids=lambda file: file.name)
def test_jobs_read_and_end(file: Path) -> None:
    workflow = read(file)
    assert workflow["permissions"] == {"contents": "read"}
    for name, job in workflow["jobs"].items():
        assert job.get("permissions", {}) == MAY_WRITE.get((file.name, name), {}), name
        assert job["timeout-minutes"] <= 120 if "steps" in job else (ROOT / job["uses"]).is_file()
    for step in steps(workflow):
        if step.get("uses", "").startswith("actions/checkout@"):
            assert step["with"]["persist-credentials"] is False, "no token for what runs"


def test_steps_call_what_can_be_called_by_hand() -> None:
    makefile = (ROOT / "Makefile").read_text(encoding="utf-8")
    (phony,) = re.findall(r"^\.PHONY: (.*)$", makefile, re.MULTILINE)
    for line in (line for file in WORKFLOWS for line in lines(read(file))):
        if line.startswith("make "):
            goals = re.sub(r'\w+=("[^"]*"|\S+)', "", line).split()[1:]
            assert set(goals) <= set(phony.split()), line
        for script in re.findall(r"tools/(?:scripts|packaging)/\w+\.sh", line):
            assert os.access(ROOT / script, os.X_OK), line


def test_parts_and_packages_of_the_nightly_run_exist() -> None:
    evidence = read(ROOT / ".github/workflows/nightly.yml")["jobs"]["evidence"]
    for row in evidence["strategy"]["matrix"]["include"]:
        assert all((ROOT / f"reports/evidence/{one}.py").is_file() for one in row["parts"].split())
    others = read(ROOT / ".github/workflows/packages.yml")["jobs"]["others"]
    script = (ROOT / "tools/packaging/try.sh").read_text(encoding="utf-8")
    cases = re.findall(r"^  (\w+)\)$", script, re.MULTILINE)
    assert sorted(cases) == sorted(["wheels", *others["strategy"]["matrix"]["package"]])


def test_images_are_pinned_or_listed_as_not_pinned() -> None:
    """Pins images by digest. Images without a digest, and no others, stand in docs/packages.md."""
    used = set()
    for workflow in map(read, WORKFLOWS):
        containers = [job.get("container", {}) for job in workflow["jobs"].values()]
        used |= {one if isinstance(one, str) else one.get("image") for one in containers}
    container = (ROOT / "Containerfile").read_text(encoding="utf-8")
    used |= set(re.findall(r"^FROM (\S+)", container, re.MULTILINE))
    used.add(json.loads((ROOT / ".devcontainer/devcontainer.json").read_bytes())["image"])
    project = tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))
    used.add(project["tool"]["cibuildwheel"]["manylinux-x86_64-image"])
    open_ones = {one for one in used - {None} if not re.search(r"@sha256:[0-9a-f]{64}$", one)}
    page = (ROOT / "docs/packages.md").read_text(encoding="utf-8")
    (row,) = re.findall(r"^- Images have tags, .*?(?=^- |\Z)", page, re.MULTILINE | re.DOTALL)
    assert set(re.findall(r"`([^` ]+)`", row)) == open_ones


def test_an_action_has_one_commit_everywhere() -> None:
    commits: dict[str, set[str]] = {}
    for file in [*WORKFLOWS, ROOT / "action.yml", ROOT / "docs" / "ci.md"]:
        used = re.findall(r"\buses: (\S+)@(\S+)(.*)", file.read_text(encoding="utf-8"))
        for action, commit, remark in used:
            if action == "OWNER/minkref":
                continue
            assert re.fullmatch(r"[0-9a-f]{40}", commit), f"{file.name}: {action}"
            assert re.fullmatch(r" # v\d+\.\d+\.\d+", remark), f"{file.name}: {action}"
            commits.setdefault(action, set()).add(commit + remark)
    assert all(len(found) == 1 for found in commits.values()), commits
    assert all(action.startswith("actions/") for action in commits), "GitHub's own only"


def test_the_wheel_that_the_release_tries_is_one_that_it_builds() -> None:
    release = (ROOT / "tools/packaging/try.sh").read_text(encoding="utf-8")
    project = (ROOT / "pyproject.toml").read_text(encoding="utf-8")
    (tag,) = re.findall(r"bare\.py dist/minkref-\*-(cp\d+)-abi3-", release)
    assert f'"wheel.py-api" = "{tag}"' in project and f"{tag}-manylinux_x86_64" in project


def test_bubblewrap_may_make_user_namespaces_where_it_is_used(tmp_path: Path) -> None:
    """Ubuntu 24.04's AppArmor denies user namespaces to programs without a profile."""
    script = "tools/scripts/allow_user_namespaces.sh"
    for file in [*WORKFLOWS, ROOT / "action.yml"]:
        text = file.read_text(encoding="utf-8")
        assert script in text or not re.search("bubblewrap|privileged", text), file.name
    setting = tmp_path / "setting"
    for before, after in (("1\n", "0\n"), ("0\n", "0\n")):
        setting.write_text(before)
        subprocess.run([ROOT / script, setting], check=True)
        assert setting.read_text() == after
    subprocess.run([ROOT / script, tmp_path / "absent"], check=True)
    assert not (tmp_path / "absent").exists()
