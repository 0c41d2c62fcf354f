"""The step `fresh_clone`, on a small repository whose goals tell their arguments."""

from __future__ import annotations

import subprocess
from pathlib import Path

import pytest

pytest.importorskip("minkref._core", reason="the extension module is not built")

from minkref.reports.evidence.framework import clone
from minkref.reports.evidence.framework.part import Findings, Size, Status
from minkref.reports.evidence.packages import fresh_clone

MAKEFILE = """
all_but_three = $(shell env | cut -d= -f1 | grep -vxE "PATH|HOME|CCACHE_DISABLE|PWD|OLDPWD|SHLVL|_\\
|MAKE.*|MFLAGS|SHELL|TERM|LC_CTYPE")
setup run test:
\t@test -z "$(all_but_three)" || { echo "$(all_but_three)"; exit 9; }
\t@test $@ != test || exit TESTS
evidence:
\t@test "$(QUICK)" = 1
\t@case "$(ONLY)" in *fresh_clone*) exit 9;; *plane_sums/random_pairs*) ;; *) exit 8;; esac
"""


def repository(folder: Path, tests: int) -> Path:
    folder.mkdir()
    (folder / "Makefile").write_text(MAKEFILE.replace("TESTS", str(tests)))
    git = ["git", "-C", str(folder), "-c", "user.name=t", "-c", "user.email=t@example.org"]
    for command in (["init", "-q"], ["add", "."], ["commit", "-q", "-m", "all"]):
        subprocess.run([*git, *command], check=True)
    return folder


@pytest.mark.parametrize(("tests", "status"), [(0, Status.MET), (3, Status.FAILED)])
def test_commands_run_in_a_clean_environment_and_a_failure_is_a_failure(
    tests: int, status: Status, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    source = repository(tmp_path / "repository", tests)
    monkeypatch.setattr(fresh_clone, "ROOT", source)
    monkeypatch.setattr(clone, "ROOT", source)
    monkeypatch.setattr(clone, "FOLDER", tmp_path)
    monkeypatch.setenv("MINKREF_MODELS", "/nowhere")
    findings = Findings()
    fresh_clone.run(findings, Size.FULL)
    broken = [check.what for check in findings.checks if not check.met]
    assert broken == ([] if tests == 0 else ["make test"])
    assert findings.status is status
