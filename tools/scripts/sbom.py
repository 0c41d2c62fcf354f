"""Writes the checkout's software bill of materials: CycloneDX 1.6, as JSON.

sbom.py [FILE]: writes build/sbom.cdx.json by default. The list has the Python packages of .venv
with their requirements, and the Debian packages whose headers or libraries build/release uses,
according to its build record, each with the folders that use it; packages for tests only have the
scope "excluded". Headers from elsewhere are named on standard error.
"""

from __future__ import annotations

import json
import subprocess
import sys
import tempfile
from collections import defaultdict
from collections.abc import Iterable
from pathlib import Path
from typing import Any

from cyclonedx.schema import SchemaVersion
from cyclonedx.validation.json import JsonStrictValidator
from packageurl import PackageURL

ROOT = Path(__file__).resolve().parents[2]
BUILD = ROOT / "build" / "release"
BINARIES = ("bindings/_core*.so", "oracle/*/minkref-*")  # in BUILD
MINKREF = "root-component"  # as cyclonedx-bom names what a project file describes

Json = dict[str, Any]
Users = dict[str, set[str]]  # file or package: the folders in BUILD that use it


def output(*command: str | Path, check: bool = True) -> str:
    return subprocess.run(command, check=check, capture_output=True, text=True).stdout


def python_packages() -> Json:
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder, "packages.json")
        project = ("--pyproject", ROOT / "pyproject.toml")
        command = (sys.executable, "-m", "cyclonedx_py", "environment", "--output-reproducible")
        output(*command, "--no-validate", *project, "-o", file, sys.executable)
        document: Json = json.loads(file.read_text(encoding="utf-8"))
    for component in [*document["components"], *document["metadata"]["tools"]["components"]]:
        component.pop("externalReferences", None)
    return document


def room(path: str) -> str:
    """The source folder of an object or binary; all tests count as one folder."""
    folder = path.split("/CMakeFiles/")[0].rsplit("/minkref-", 1)[0].rsplit("/_core", 1)[0]
    return "tests" if folder.startswith("tests") else folder


def headers_compiled_in() -> Users:
    """System headers and their users, from Ninja's build record; headers inside the checkout do not
    count."""
    users: Users = defaultdict(set)
    user = ""
    for line in output("ninja", "-C", BUILD, "-t", "deps").splitlines():
        if not line.startswith(" "):
            user = room(line.split(":")[0])
        elif (file := line.strip()).startswith("/") and not file.startswith(f"{ROOT}/"):
            users[file].add(user)
    return users


def libraries_linked() -> Users:
    users: Users = defaultdict(set)
    for binary in (found for pattern in BINARIES for found in BUILD.glob(pattern)):
        for word in output("ldd", binary).split():
            if word.startswith("/"):
                users[word].add(room(str(binary.relative_to(BUILD))))
    return users


def debian_packages(files: Users, what: str) -> list[Json]:
    """The Debian packages that own the files; dpkg may know a file by its path without the links of
    merged /usr."""
    owners = {}
    names = sorted({name for file in files for name in (file, str(Path(file).resolve()))})
    for line in output("dpkg-query", "--search", *names, check=False).splitlines():
        package, _, file = line.rpartition(": ")
        owners[file] = package
    users: Users = defaultdict(set)
    for file, rooms in files.items():
        path = Path(file).resolve()
        users[owners.get(file) or owners.get(str(path)) or str(path.parent)] |= rooms
    for folder in sorted(name for name in users if name.startswith("/")):
        print(f"minkref: of no Debian package, so not listed: {what} in {folder}", file=sys.stderr)
    return [
        debian_package(name, f"{what}, used by {', '.join(sorted(rooms))}", rooms == {"tests"})
        for name, rooms in sorted(users.items())
        if not name.startswith("/")
    ]


def debian_package(name: str, description: str, tests_only: bool) -> Json:
    fields = "${Package} ${Version} ${Architecture}"
    package, version, architecture = output("dpkg-query", "-W", "-f", fields, name).split()
    purl = PackageURL("deb", "debian", package, version, {"arch": architecture})
    return {
        "type": "library",
        "name": package,
        "version": version,
        "description": description,
        "purl": str(purl),
        "bom-ref": str(purl),
        "scope": "excluded" if tests_only else "required",
    }


def bill_of_materials() -> Json:
    document = python_packages()
    linked = debian_packages(libraries_linked(), "shared library")
    compiled = debian_packages(headers_compiled_in(), "headers")
    document["components"] += [*linked, *compiled]
    document["dependencies"] += [{"ref": part["bom-ref"]} for part in (*linked, *compiled)]
    (own,) = (entry for entry in document["dependencies"] if entry["ref"] == MINKREF)
    own["dependsOn"] += [
        part["bom-ref"] for part in (*linked, *compiled) if part["scope"] == "required"
    ]
    return document


def main(arguments: Iterable[str]) -> int:
    file = Path(next(iter(arguments), ROOT / "build" / "sbom.cdx.json"))
    text = json.dumps(bill_of_materials(), indent=1) + "\n"
    fault = JsonStrictValidator(SchemaVersion.V1_6).validate_str(text)
    if fault is not None:
        print(f"minkref: the bill of materials is not CycloneDX 1.6: {fault}", file=sys.stderr)
        return 1
    file.write_text(text, encoding="utf-8")
    print(f"minkref: {file}: {text.count(chr(34) + 'purl')} components")
    return 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
