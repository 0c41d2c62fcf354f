"""The supply chain: nothing from a package index is installed without its file's digest."""

from __future__ import annotations

import os
import re
import shutil
import subprocess
import zipfile
from pathlib import Path

import pytest
from packaging.requirements import Requirement
from packaging.utils import canonicalize_name

ROOT = Path(__file__).resolve().parents[2]
ADAPTERS = sorted(ROOT.glob("fuzz/libraries/*/requirements.txt"))
OTHERS = [
    ROOT / "docs/site/requirements.txt",
    ROOT / "tools/javascript/requirements.txt",
    ROOT / "tools/packaging/tools.requirements.txt",
]
LOCKS = [ROOT / "requirements.txt", *OTHERS, *ADAPTERS]


def locked(file: Path) -> dict[str, tuple[Requirement, list[str]]]:
    """The requirement and the digests of each package."""
    text = re.sub(r"\\\n", " ", file.read_text(encoding="utf-8"))
    found = {}
    for line in text.splitlines():
        words = line.split("#")[0].split("--hash=")
        if words[0].strip():
            requirement = Requirement(words[0])
            found[canonicalize_name(requirement.name)] = (requirement, words[1:])
    return found


@pytest.mark.parametrize("file", LOCKS, ids=lambda file: file.name)
def test_each_package_has_one_version_and_its_digests(file: Path) -> None:
    for requirement, digests in locked(file).values():
        assert re.fullmatch(r"==[^,*]+", str(requirement.specifier)), requirement
        assert digests, requirement
        assert all(re.fullmatch(r"sha256:[0-9a-f]{64}\s*", one) for one in digests), requirement
    assert "://" not in file.read_text(encoding="utf-8")


def test_locks_hold_what_is_asked_for() -> None:
    sources = [file for lock in LOCKS if (file := lock.with_suffix(".in")).is_file()]
    assert ROOT / "requirements.in" in sources and len(sources) == 11
    for source in sources:
        held = locked(source.with_suffix(".txt"))
        for line in source.read_text(encoding="utf-8").splitlines():
            if wanted := line.split("#")[0].strip():
                asked = Requirement(wanted)
                (version,) = held[canonicalize_name(asked.name)][0].specifier
                assert asked.specifier.contains(version.version), asked


def test_set_up_installs_no_package_without_a_digest(tmp_path: Path) -> None:
    """Checks out the scripts alone, with requirements that name a package within reach."""
    shutil.copytree(ROOT / "tools" / "scripts", tmp_path / "tools" / "scripts")
    with zipfile.ZipFile(tmp_path / "sought-1-py3-none-any.whl", "w") as wheel:
        information = "sought-1.dist-info"
        wheel.writestr(
            f"{information}/METADATA", "Metadata-Version: 2.1\nName: sought\nVersion: 1\n"
        )
        wheel.writestr(f"{information}/WHEEL", "Wheel-Version: 1.0\nTag: py3-none-any\n")
        wheel.writestr(f"{information}/RECORD", "")
    (tmp_path / "requirements.txt").write_text("sought==1\n", encoding="utf-8")
    done = subprocess.run(
        [tmp_path / "tools" / "scripts" / "set_up.sh", "environment"],
        env={**os.environ, "PIP_NO_INDEX": "1", "PIP_FIND_LINKS": str(tmp_path)},
        capture_output=True,
        text=True,
        check=False,
    )
    assert done.returncode == 2, done.stderr
    assert "Hashes are required" in done.stderr and "--hash=sha256:" in done.stderr
    assert not (tmp_path / "build" / "stamps" / "environment").exists()


def test_actions_are_pinned_to_commits_and_workflows_may_only_read() -> None:
    for name in ("action.yml", "docs/ci.md"):
        text = (ROOT / name).read_text(encoding="utf-8")
        used = re.findall(r"\buses: (\S+)@(\S+)(.*)", text)
        assert used, name
        for action, version, remark in used:
            if action == "OWNER/minkref":
                assert version == "COMMIT"
            else:
                assert re.fullmatch(r"[0-9a-f]{40}", version), action
                assert re.fullmatch(r" # v\d+\.\d+\.\d+", remark), action
        if "jobs:" in text:
            assert re.search(r"^ *permissions:\n *contents: read\n *jobs:", text, re.MULTILINE)
