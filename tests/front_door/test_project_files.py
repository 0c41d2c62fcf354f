"""Files for other tools: each satisfies its tool, and all agree about the version."""

from __future__ import annotations

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


def text(name: str) -> str:
    return (ROOT / name).read_text(encoding="utf-8")


def document(name: str) -> Any:
    return yaml.safe_load(text(name))


def version() -> str:
    return str(tomllib.loads(text("pyproject.toml"))["project"]["version"])


@pytest.mark.parametrize(
    ("schema", "name"), [("citation-file-format", "CITATION.cff"), ("github-actions", "action.yml")]
)
def test_files_are_what_their_schema_says(schema: str, name: str) -> None:
    command = [TOOLS / "check-jsonschema", "--builtin-schema", f"vendor.{schema}", ROOT / name]
    done = subprocess.run(command, capture_output=True, text=True)
    assert done.returncode == 0, done.stdout + done.stderr


def test_citation_names_the_version() -> None:
    assert document("CITATION.cff")["version"] == version()


def test_the_changelog_speaks_of_the_version() -> None:
    """Starts with the coming changes, then the versions with their dates, by setting."""
    heads = re.findall(r"^## (.*)$", text("CHANGELOG.md"), re.MULTILINE)
    assert heads[0] == "Unreleased"
    assert re.fullmatch(rf"{re.escape(version())} - \d{{4}}-\d\d-\d\d", heads[1])


def test_hooks_start_tools_of_the_checkout() -> None:
    (repository,) = document(".pre-commit-config.yaml")["repos"]
    assert repository["repo"] == "local", "nothing that is fetched at the time of a commit"
    lock = text("requirements.txt")
    for hook in repository["hooks"]:
        program = Path(hook["entry"].split()[0])
        assert program.parts[:2] == (".venv", "bin"), hook
        assert program.name == "python" or re.search(rf"^{program.name}==", lock, re.MULTILINE)


def test_hooks_check_what_the_linters_check() -> None:
    makefile = text("Makefile")
    entries = {
        hook["id"]: hook for hook in document(".pre-commit-config.yaml")["repos"][0]["hooks"]
    }
    rooms = re.search(r"^CXX_SOURCES = \$\(shell find ([a-z ]+) -name", makefile, re.MULTILINE)
    assert rooms is not None
    assert entries["clang-format"]["files"].startswith(f"^({'|'.join(rooms[1].split())})/")
    assert "tools/scripts/check_includes.py" in makefile and entries["check-includes"]


def test_paths_and_commands_that_contributors_are_told_exist() -> None:
    page = text("CONTRIBUTING.md")
    for name in re.findall(r"`([\w./-]+/[\w.-]*)`", page):
        if "NAME" not in name and not name.startswith(".venv"):
            assert (ROOT / name).exists(), name
    for link in re.findall(r"\]\(([^)#:]+)\)", page):
        assert (ROOT / link).exists(), link
    targets = set(re.findall(r"^([a-z]+(?: [a-z]+)*):", text("Makefile"), re.MULTILINE))
    known = {target for line in targets for target in line.split()}
    assert set(re.findall(r"\bmake ([a-z]+)", page)) - {"it"} <= known


def test_the_map_of_the_house_names_what_is_there() -> None:
    """Folders and files of the map exist, and each deciding function stands in its stated file."""
    page = text("docs/architecture.md")
    rooms = (
        "bindings|certify|degeneracies|formats|fuzz|minkref|oracle|reference|reports|tests|tools"
    )
    named = re.findall(rf"`((?:{rooms})/[\w./-]*)`", page)
    assert len(named) > 60
    assert [name for name in named if not (ROOT / name).exists()] == []
    for way in re.split(r"^## ", page, flags=re.MULTILINE)[1:]:
        (found,) = re.findall(r"\*\*`([\w:]+)` in `([\w./]+)`\s+decides", way)
        function, file = found[0].split("::")[-1], found[1]
        below = [*ROOT.glob(f"reference/**/{file}"), *ROOT.glob(f"fuzz/**/{file}")]
        places = [path for path in (ROOT / file, *below) if path.is_file()]
        assert any(re.search(rf"\b{function}\b", path.read_text("utf-8")) for path in places), found


def test_files_that_a_readme_names_exist() -> None:
    listed = subprocess.run(
        ["git", "ls-files"], cwd=ROOT, capture_output=True, text=True, check=True
    )
    files = set(listed.stdout.split())
    absent = []
    for readme in (file for file in files if file.endswith("README.md")):
        folder = readme.removesuffix("README.md")
        inside = [file for file in files if file.startswith(folder)]
        for name in re.findall(r"`((?:[\w.-]+/)*[\w-]+\.(?:py|hpp|cpp|js|sh))`", text(readme)):
            beside = (ROOT / folder / name).is_file() or name in files or name.startswith("NAME/")
            if not beside and not any(file.endswith(f"/{name}") for file in inside):
                absent.append(f"{readme}: {name}")
    assert absent == []


def test_each_room_of_the_tests_stands_in_their_table() -> None:
    rows = re.findall(r"^\| ([\w/]+) \| ", text("tests/README.md"), re.MULTILINE)
    tests = ROOT / "tests"
    kinds = ("*_test.cpp", "test_*.py", "fuzz_*.cpp", "consumer.cpp")
    rooms = {str(path.parent.relative_to(tests)) for kind in kinds for path in tests.rglob(kind)}
    assert rows == ["Room", *sorted(rooms)]
