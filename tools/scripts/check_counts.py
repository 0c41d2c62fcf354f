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
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parents[2]
LIMITS = Path(__file__).with_name("counts.toml")
CODE = (".cpp", ".hpp", ".py", ".js", ".v", ".ml")
READ = (*CODE, ".md", ".json", ".toml")
SETTINGS = ("plane", "disc", "space", "motion", "scene")
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


def tracked() -> dict[str, str]:
    """Texts of tracked files that exist, without the corpus and what commands write."""
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
    return {
        f: (ROOT / f).read_text(encoding="utf-8")
        for f in listed.stdout.splitlines()
        if f.endswith(READ) and not f.startswith(made) and (ROOT / f).is_file()
    }


def comments(file: str, text: str) -> Iterator[tuple[int, str]]:
    """Line and text of each comment and docstring, and of each paragraph of a document."""
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


def sentences(texts: Mapping[str, str]) -> Iterator[Sentence]:
    """Sentences of 5 to 60 words."""
    for file, text in texts.items():
        for line, said in comments(file, text):
            for sentence in re.split(r"(?<=[.;:?!])\s+(?=[A-Z`*])", re.sub(r"\s+", " ", said)):
                words = re.findall(r"[A-Za-z']+", sentence)
                if 5 <= len(words) <= 60:
                    share = sum(word.lower() in FUNCTION_WORDS for word in words) / len(words)
                    yield Sentence(f"{file}:{line}", sentence.strip(), share)


def functions_of_python(text: str) -> Iterator[int]:
    for node in ast.walk(ast.parse(text)):
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
            yield (node.end_lineno or 0) - node.lineno + 1


def functions_of_cpp(text: str) -> Iterator[int]:
    """Lines of each function that stands at the margin, as clang-format sets it: its head, perhaps
    of several lines, to the brace that closes there. Namespaces, classes and tables are none."""
    head, begin, start = None, 0, None
    for number, line in enumerate(text.splitlines()):
        if re.match(r"\w", line):
            head, begin = "", number
        if head is not None:
            head += line
            if line.endswith("{"):
                start = begin if is_function(head) else None
            if line.endswith(("{", "}", ";")):
                head = None
        elif line.startswith("}"):
            if line == "}" and start is not None:
                yield number - start + 1
            start = None


def is_function(head: str) -> bool:
    return ")" in head and not re.match(r"(?:namespace|struct|class|union|enum)\b", head)


def setting_of(name: str) -> str | None:
    """The setting whose folder a path or module lies in: plane/, plane_events/."""
    parts = name.replace(".", "/").replace("solids", "space").split("/")
    return next((part.split("_")[0] for part in parts if part.split("_")[0] in SETTINGS), None)


def names_two_settings(file: str, text: str) -> bool:
    """A file in the folder of no setting that includes or imports two settings."""
    if setting_of(str(Path(file).parent)) is not None:
        return False
    return len({setting_of(name) for name in IMPORT.findall(text)} - {None}) > 1


def count_rows(texts: Mapping[str, str]) -> dict[str, float]:
    """Each count by its name, of files by their paths."""

    def those(begin: str, *ends: str) -> dict[str, str]:
        return {f: t for f, t in texts.items() if f.startswith(begin) and f.endswith(ends)}

    code = those("", *CODE)
    python, cpp = (
        {f: t for f, t in those("", *ends).items() if not f.startswith("tests/")}
        for ends in ((".py",), (".cpp", ".hpp"))
    )
    project = tomllib.loads(texts["pyproject.toml"])
    contracts = project["tool"]["importlinter"]["contracts"]
    lengths = [n for t in python.values() for n in functions_of_python(t)]
    lengths += [n for t in cpp.values() for n in functions_of_cpp(t)]
    prose = {
        "C++": cpp,
        "Python": python,
        "tests": those("tests/", *CODE),
        "documents": those("", ".md"),
    }
    read = {name: list(sentences(group)) for name, group in prose.items()}
    hooked = those("reference/", ".cpp", ".hpp")
    return {
        "folders of code at the top": len({f.split("/")[0] for f in code if "/" in f}),
        "lines of JSON schemas written by hand": sum(
            t.count("\n") for t in those("minkref/schemas/", ".json").values()
        ),
        f"functions over {LONG} lines": sum(n > LONG for n in lengths),
        "files of no setting that name two": sum(
            names_two_settings(f, t) for f, t in (python | cpp).items()
        ),
        "exceptions to the floors": sum(len(c.get("ignore_imports", ())) for c in contracts),
        "hooks for faults in reference/": sum(t.count("planted(") for t in hooked.values()),
        "sentences that begin with Of, What, That, Which, Those": sum(
            bool(HEADS.match(s.text)) for group in read.values() for s in group
        ),
        **{
            f"function words in {name}, per thousand": round(
                1000 * sum(s.density for s in group) / max(len(group), 1)
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
        below = tuple(options.paths or [""])
        chosen = {f: t for f, t in tracked().items() if f.startswith(below)}
        for row in sorted(sentences(chosen), key=lambda row: -row.density)[: options.worst]:
            print(f"{row.density:.2f} {row.where}: {row.text}")
        return 0
    found = count_rows(tracked())
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
