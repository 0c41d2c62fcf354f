"""The action's first step installs an attested wheel, otherwise the sources."""

from __future__ import annotations

import os
import subprocess
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[2]
COMMIT = "0123456789abcdef0123456789abcdef01234567"
# Stand-ins that record their calls. `gh` has a release if RELEASE is set, and attests the release
# if ATTESTED is set.
RECORD = '#!/bin/bash\necho "${0##*/} $*" >>"$CALLS"\n'
GH = """
case "$1 $2" in
  "release download") [[ -n ${RELEASE:-} ]] || exit 1
    while [[ $1 != --dir ]]; do shift; done
    mkdir -p "$2"; touch "$2/minkref-0-py3-none-any.whl" ;;
  "attestation verify") [[ -n ${ATTESTED:-} ]] ;;
esac
"""
PYTHON = """
if [[ $3 == download ]]; then
  while [[ $1 != --dest ]]; do shift; done
  mkdir -p "$2"; touch "$2/minkref-0-py3-none-any.whl"
fi
"""


def calls(folder: Path, **variables: str) -> list[str]:
    for name, body in {"gh": GH, "python": PYTHON, "sudo": ""}.items():
        program = folder / name
        program.write_text(RECORD + body, encoding="utf-8")
        program.chmod(0o755)
    environment = {
        "PATH": f"{folder}{os.pathsep}{os.environ['PATH']}",
        "CALLS": str(folder / "log"),
    }
    script = ROOT / "tools" / "scripts" / "install_in_ci.sh"
    subprocess.run([script], env=environment | variables, check=True, capture_output=True)
    return (folder / "log").read_text(encoding="utf-8").splitlines()


def installed(made: list[str]) -> list[str]:
    return [line for line in made if line.startswith("python -m pip install")]


@pytest.mark.parametrize(
    ("ref", "proof"),
    [(COMMIT, f"--source-digest {COMMIT}"), ("v0.1.0", "--source-ref refs/tags/v0.1.0")],
)
def test_an_attested_wheel_is_installed(tmp_path: Path, ref: str, proof: str) -> None:
    given = {"ACTION_REPOSITORY": "OWNER/minkref", "ACTION_REF": ref}
    made = calls(tmp_path, RELEASE="1", ATTESTED="1", **given)
    (verified,) = (line for line in made if line.startswith("gh attestation verify"))
    assert verified.endswith(f"--repo OWNER/minkref {proof}")
    (line,) = installed(made)
    assert line.endswith(".whl")
    assert not any(line.startswith("sudo") for line in made), "no compiler is needed"


@pytest.mark.parametrize(
    "variables",
    [
        {},
        {"ACTION_REPOSITORY": "OWNER/minkref", "ACTION_REF": COMMIT},
        {"ACTION_REPOSITORY": "OWNER/minkref", "ACTION_REF": COMMIT, "RELEASE": "1"},
    ],
    ids=["not on GitHub", "no release", "not attested"],
)
def test_otherwise_the_sources_are(tmp_path: Path, variables: dict[str, str]) -> None:
    made = calls(tmp_path, **variables)
    assert installed(made) == [f"python -m pip install {ROOT}"]
    (packages,) = (line for line in made if "apt-get install" in line)
    assert "libgmp-dev" in packages and "libcgal-dev" not in packages
