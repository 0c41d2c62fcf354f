"""The bill of materials: valid, with everything installed, compiled in or linked."""

from __future__ import annotations

import json
import shutil
import subprocess
import sys
from importlib import metadata
from pathlib import Path
from typing import Any

import pytest
from cyclonedx.schema import SchemaVersion
from cyclonedx.validation.json import JsonStrictValidator

ROOT = Path(__file__).resolve().parents[2]
BUILD = ROOT / "build" / "release"

pytestmark = [
    pytest.mark.skipif(not (BUILD / ".ninja_deps").is_file(), reason="build/release is not built"),
    pytest.mark.skipif(not shutil.which("dpkg-query"), reason="not a Debian system"),
]


@pytest.fixture(scope="module")
def bill(tmp_path_factory: pytest.TempPathFactory) -> dict[str, Any]:
    file = tmp_path_factory.mktemp("sbom") / "sbom.cdx.json"
    command = [sys.executable, ROOT / "tools" / "scripts" / "sbom.py", file]
    subprocess.run(command, check=True, capture_output=True)
    text = file.read_text(encoding="utf-8")
    assert JsonStrictValidator(SchemaVersion.V1_6).validate_str(text) is None
    document: dict[str, Any] = json.loads(text)
    return document


def test_it_lists_each_python_package_with_its_version(bill: dict[str, Any]) -> None:
    listed = {(part["name"].lower(), part["version"]) for part in bill["components"]}
    assert bill["metadata"]["component"]["name"] == "minkref"
    site = str(metadata.distribution("pytest").locate_file(""))
    for package in metadata.distributions(path=[site]):
        if package.name != "minkref":
            assert (package.name.lower(), package.version) in listed


def test_it_lists_the_libraries_that_debian_ships(bill: dict[str, Any]) -> None:
    listed = {
        part["name"]: part for part in bill["components"] if part["purl"].startswith("pkg:deb/")
    }
    for name in ("libgmp10", "libmpfr6", "libgmp-dev", "libmpfr-dev", "libeigen3-dev"):
        said = subprocess.run(
            ["dpkg-query", "-W", "-f", "${Version}", name], capture_output=True, text=True
        )
        assert listed[name]["version"] == said.stdout
        assert listed[name]["scope"] == "required"
    assert any(name.startswith("libboost") for name in listed)
    assert listed["libgtest-dev"]["scope"] == "excluded"
    assert listed["libcgal-dev"]["description"] == "headers, used by oracle/cgal"


def test_what_is_listed_is_a_dependency_of_minkref_or_of_its_tests(bill: dict[str, Any]) -> None:
    needs = {entry["ref"]: entry.get("dependsOn", []) for entry in bill["dependencies"]}
    names = [part["bom-ref"] for part in bill["components"]]
    assert len(names) == len(set(names)) and set(names) <= set(needs)
    for part in bill["components"]:
        if part.get("scope") == "required":
            assert part["bom-ref"] in needs["root-component"]
