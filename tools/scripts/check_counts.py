"""Counts of the house that only fall: folders, long functions, hooks, circles, schemas written by
hand, and the English of comments, docstrings and documents.

check_counts.py: prints each count beside its limit in counts.toml, exits 1 if one is above it.
check_counts.py --lower: sets each limit to today's count where that is smaller.
check_counts.py --worst N [PATH...]: the N sentences below PATHs with most function words.
"""

from __future__ import annotations

import argparse
import ast
import re
import subprocess
import sys
import tomllib
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parents[2]
LIMITS = Path(__file__).with_name("counts.toml")
CODE = (".cpp", ".hpp", ".py", ".js", ".v", ".ml")
SETTINGS = ("plane", "disc", "space", "motion")
LONG = 100  # lines of a function
FUNCTION_WORDS = frozenset(
    "of which that what those these it its one ones other others such where whose they them there "
    "is are by in".split()
)
HEADS = re.compile(r"(Of|What|That|Which|Those) ")
IMPORT = re.compile(r'^\s*(?:#include "|from |import )([\w./]+)', re.M)


class Sentence(NamedTuple):
    where: str  # file:line of its comment
    text: str
    density: float  # share of function words


def tracked() -> list[str]:
    """Tracked files that exist, without the corpus and what commands write."""
    listed = subprocess.run(
        ["git", "ls-files"], cwd=ROOT, capture_output=True, text=True, check=True
    )
    made = (
        "degeneracies/corpus/",
        "docs/audit/",
        "tests/fuzzing/corpus/",
        "LICENSES/",
        "CHANGELOG",
    )
    return [
        f for f in listed.stdout.splitlines() if not f.startswith(made) and (ROOT / f).is_file()
    ]


def text_of(file: str) -> str:
    return (ROOT / file).read_text(encoding="utf-8")


def comments(file: str) -> Iterator[tuple[int, str]]:
    """Line and text of each comment and docstring, and of each paragraph of a document."""
    text = text_of(file)
    if file.endswith(".py"):
        blocks = re.finditer(r'"""(.*?)"""|((?:^[ \t]*# .*\n)+)', text, re.S | re.M)
        for found in blocks:
            yield (
                text.count("\n", 0, found.start()) + 1,
                re.sub(r"(?m)^\s*# ", "", found[1] or found[2]),
            )
    elif file.endswith(".md"):
        plain = re.sub(r"```.*?```", lambda block: "\n" * block[0].count("\n"), text, flags=re.S)
        for found in re.finditer(r"(?:^(?!\||#).+\n?)+", plain, re.M):
            yield plain.count("\n", 0, found.start()) + 1, found[0]
    elif file.endswith((".cpp", ".hpp", ".js")):
        for found in re.finditer(r"(?:^[ \t]*(?:///?<?|\*) ?.*\n)+", text, re.M):
            line = text.count("\n", 0, found.start()) + 1
            yield line, re.sub(r"(?m)^[ \t]*(?:///?<?|\*) ?", "", found[0])


def sentences(files: list[str]) -> Iterator[Sentence]:
    """Sentences of 5 to 60 words."""
    for file in files:
        for line, text in comments(file):
            for sentence in re.split(r"(?<=[.;:?!])\s+(?=[A-Z`*])", re.sub(r"\s+", " ", text)):
                words = re.findall(r"[A-Za-z']+", sentence)
                if 5 <= len(words) <= 60:
                    share = sum(word.lower() in FUNCTION_WORDS for word in words) / len(words)
                    yield Sentence(f"{file}:{line}", sentence.strip(), share)


def functions_of_python(text: str) -> Iterator[int]:
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
            yield (node.end_lineno or 0) - node.lineno + 1


def functions_of_cpp(text: str) -> Iterator[int]:
    """Lines from a brace that opens a body at the margin, as clang-format sets it, to the next that
    closes there; namespaces, classes and tables end otherwise."""
    start = None
    for number, line in enumerate(text.splitlines()):
        if re.match(r"\S.*\) (?:const )?(?:noexcept )?\{$", line):
            start = number
        elif line == "}" and start is not None:
            yield number - start + 1
            start = None


def setting_of(name: str) -> str | None:
    """The setting whose folder a path or module lies in: plane/, plane_events/."""
    parts = name.replace(".", "/").replace("solids", "space").split("/")
    return next((part.split("_")[0] for part in parts if part.split("_")[0] in SETTINGS), None)


def names_two_settings(file: str) -> bool:
    """A file in the folder of no setting that includes or imports two settings."""
    if setting_of(str(Path(file).parent)) is not None:
        return False
    return len({setting_of(name) for name in IMPORT.findall(text_of(file))} - {None}) > 1


def count_rows() -> dict[str, float]:
    """Each count by its name."""
    files = tracked()
    code = [f for f in files if f.endswith(CODE)]
    ours = [f for f in code if not f.startswith("tests/")]
    python, cpp = ([f for f in ours if f.endswith(end)] for end in (".py", (".cpp", ".hpp")))
    project = tomllib.loads(text_of("pyproject.toml"))
    contracts = project["tool"]["importlinter"]["contracts"]
    schemas = [f for f in files if f.startswith("minkref/schemas/") and f.endswith(".json")]
    hooked = [f for f in cpp if f.startswith("reference/")]
    lengths: Callable[[str], Iterator[int]] = lambda f: (  # noqa: E731
        functions_of_python(text_of(f)) if f.endswith(".py") else functions_of_cpp(text_of(f))
    )
    prose = {
        "C++": [f for f in ours if f.endswith((".cpp", ".hpp"))],
        "Python": python,
        "tests": [f for f in code if f.startswith("tests/")],
        "documents": [f for f in files if f.endswith(".md")],
    }
    read = {name: list(sentences(group)) for name, group in prose.items()}
    return {
        "folders of code at the top": len({f.split("/")[0] for f in code if "/" in f}),
        "lines of JSON schemas written by hand": sum(text_of(f).count("\n") for f in schemas),
        f"functions over {LONG} lines": sum(n > LONG for f in python + cpp for n in lengths(f)),
        "files of no setting that name two": sum(map(names_two_settings, python + cpp)),
        "exceptions to the floors": sum(len(c.get("ignore_imports", ())) for c in contracts),
        "hooks for faults in reference/": sum(text_of(f).count("planted(") for f in hooked),
        "sentences that begin with Of, What, That, Which, Those": sum(
            bool(HEADS.match(s.text)) for group in read.values() for s in group
        ),
        **{
            f"function words in {name}, per thousand": round(
                1000 * sum(s.density for s in group) / len(group)
            )
            for name, group in read.items()
        },
    }


def main() -> int:
    parser = argparse.ArgumentParser(prog="check_counts.py", description=__doc__)
    parser.add_argument("--lower", action="store_true")
    parser.add_argument("--worst", type=int, metavar="N")
    parser.add_argument("paths", nargs="*", metavar="PATH")
    options = parser.parse_args()
    if options.worst:
        chosen = [f for f in tracked() if f.startswith(tuple(options.paths or [""]))]
        for row in sorted(sentences(chosen), key=lambda row: -row.density)[: options.worst]:
            print(f"{row.density:.2f} {row.where}: {row.text}")
        return 0
    found = count_rows()
    limits = tomllib.loads(LIMITS.read_text(encoding="utf-8")) if LIMITS.exists() else {}
    if options.lower:
        lines = (f'"{name}" = {min(n, limits.get(name, n))}\n' for name, n in found.items())
        LIMITS.write_text("".join(lines), encoding="utf-8")
        return 0
    above = [name for name, n in found.items() if n > limits.get(name, 0)]
    for name, n in found.items():
        print(f"{n:7} of {limits.get(name, 0):<7} {name}{'  TOO MANY' if name in above else ''}")
    return 1 if above else 0


if __name__ == "__main__":
    sys.exit(main())
