"""Leads from files that Python read to their C++ sources: through names from the extension module,
and includes."""

from __future__ import annotations

import os
import re
from collections.abc import Iterable
from functools import cache
from pathlib import Path

DEFINED = re.compile(
    r"""\b(?:module|m)\s*\.(?:def|attr)\(\s*"(\w+)"  # of the module; not .def( of a class
    |\b(?:module|m),\s*"(\w+)"                       # nb::class_<Type> bound(module, "Name"
    |\bbind_\w+\(\s*"(\w+)" """,
    re.X,
)
USED = re.compile(r"\b_core\.(\w+)")
IMPORTED = re.compile(r"from minkref\._core import \(?([\w\s,]+)")
INCLUDED = re.compile(r'^\s*#\s*include "([^"]+)"', re.M)
SOURCES = (".cpp", ".hpp", ".h")
BINDING = "bindings"  # the extension module's sources
ALWAYS = ("CMakeLists.txt", "tools/cmake/MinkrefBuild.cmake", f"{BINDING}/core.cpp")


def reached(files: Iterable[str], root: Path) -> set[str]:
    """Adds the sources of extension functions and classes that Python files name, and everything
    included from there. A folder (`oracle/cgal/`) stands for its sources."""
    found, sources = set(), set()
    for name in files:
        if name.endswith("/"):
            sources |= {p for p in (root / name).glob("*.?pp")} | {root / name / "CMakeLists.txt"}
        else:
            found.add(name)
    texts = [read(root / name) for name in found if name.endswith(".py")]
    used = {name for text in texts for name in names_used(text)}
    where = bindings(root)
    sources |= {path for name in used for path in where.get(name, ())}
    if any(path.parent.name == BINDING for path in sources):
        sources |= {root / name for name in ALWAYS}
    for path in closure(sources, root):
        found.add(str(path.relative_to(root)))
    return found


def names_used(text: str) -> set[str]:
    """Names that a Python text uses from the extension module."""
    imported = " ".join(IMPORTED.findall(text))
    quoted = re.findall(r'"(\w+)"', text) if "getattr(_core" in text else ()
    return {*USED.findall(text), *re.findall(r"\w+", imported), *quoted}


@cache
def bindings(root: Path) -> dict[str, set[Path]]:
    """The source files that define each name of the extension module."""
    found: dict[str, set[Path]] = {}
    for path in (root / BINDING).glob("*.cpp"):
        for groups in DEFINED.findall(read(path)):
            found.setdefault("".join(groups), set()).add(path)
    return found


def closure(sources: Iterable[Path], root: Path) -> set[Path]:
    """The files with all direct and indirect includes; a header brings its implementations."""
    seen: set[Path] = set()
    left = [path for path in sources if path.is_file()]
    while left:
        path = left.pop()
        if path in seen:
            continue
        seen.add(path)
        if path.suffix in SOURCES:
            left += [*included(path, root), *implementations(path, root)]
    return seen


@cache
def included(path: Path, root: Path) -> tuple[Path, ...]:
    """Found beside the file, or from the root."""
    found = []
    for name in INCLUDED.findall(read(path)):
        places = (Path(os.path.normpath(folder / name)) for folder in (path.parent, root))
        found += [place for place in places if place.is_file()][:1]
    return tuple(found)


def implementations(header: Path, root: Path) -> set[Path]:
    """The source with the header's name, and the folder's sources without a header of their name
    that include this header."""
    if header.suffix == ".cpp" or header.parent.name == BINDING:
        return set()
    return {header.with_suffix(".cpp"), *of_headers(root, header.parent).get(header, ())} & {
        *header.parent.glob("*.cpp")
    }


@cache
def of_headers(root: Path, folder: Path) -> dict[Path, list[Path]]:
    found: dict[Path, list[Path]] = {}
    for path in folder.glob("*.cpp"):
        if not path.with_suffix(".hpp").is_file():
            for header in included(path, root):
                found.setdefault(header, []).append(path)
    return found


@cache
def read(path: Path) -> str:
    return path.read_text(encoding="utf-8", errors="replace")
