"""What GitHub runs: actions by commit, least permissions, a limit of time for each job."""

from __future__ import annotations

import re
import subprocess
import sys
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


def test_there_are_workflows() -> None:
    assert [file.name for file in WORKFLOWS] == ["ci.yml", "nightly.yml", "release.yml"]


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
    workflow: dict[str, Any] = yaml.safe_load(file.read_text(encoding="utf-8"))
    assert workflow["permissions"] == {"contents": "read"}
    for name, job in workflow["jobs"].items():
        assert job.get("permissions", {}) == MAY_WRITE.get((file.name, name), {}), name
        assert job["timeout-minutes"] <= 120, name
        for step in job["steps"]:
            if step.get("uses", "").startswith("actions/checkout@"):
                assert step["with"]["persist-credentials"] is False, "no token for what runs"


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
    release = (ROOT / ".github" / "workflows" / "release.yml").read_text(encoding="utf-8")
    project = (ROOT / "pyproject.toml").read_text(encoding="utf-8")
    (tag,) = re.findall(r"bare\.py dist/minkref-\*-(cp\d+)-abi3-", release)
    assert f'"wheel.py-api" = "{tag}"' in project and f"{tag}-manylinux_x86_64" in project


def test_bubblewrap_may_make_user_namespaces_where_it_is_used(tmp_path: Path) -> None:
    """On ubuntu-24.04, whose AppArmor keeps them from programs without a profile."""
    script = "scripts/allow_user_namespaces.sh"
    for file in [*WORKFLOWS, ROOT / "action.yml"]:
        assert script in file.read_text(encoding="utf-8"), file.name
    setting = tmp_path / "setting"
    for before, after in (("1\n", "0\n"), ("0\n", "0\n")):
        setting.write_text(before)
        subprocess.run([ROOT / script, setting], check=True)
        assert setting.read_text() == after
    subprocess.run([ROOT / script, tmp_path / "absent"], check=True)
    assert not (tmp_path / "absent").exists()


def test_the_site_is_built() -> None:
    workflow = yaml.safe_load((ROOT / ".github/workflows/ci.yml").read_text(encoding="utf-8"))
    steps = [step.get("run", "") for job in workflow["jobs"].values() for step in job["steps"]]
    assert any("make docs" in step for step in steps)
