"""The rule of independence: shared code weakens a cross-check of two sides.

check_includes.py [ROOT]: prints a line for each include or import that breaks the rule, and exits
with 1 if any does. The tables below hold the rules; docs/definitions.md gives the reasons.
"""

from __future__ import annotations

import ast
import re
import sys
from collections.abc import Iterator
from pathlib import Path

INCLUDE = re.compile(r'^[ \t]*#[ \t]*include[ \t]*([<"])([^>"]+)[>"]', re.MULTILINE)
# Imports by module name, except of a module beside the importer.
BY_NAME = re.compile(r"(import_module|__import__)\(\s*f?[\"'](?!\.[^.])[^\"']*")
FOREIGN = ("CGAL/", "nlohmann/")
ROOMS = (
    "reference", "formats", "certify", "oracle", "degeneracies", "fuzz", "reports",
    "bindings", "minkref",
)  # fmt: skip

# Room: our rooms and the libraries from FOREIGN that the room may include.
MAY_INCLUDE: dict[str, tuple[tuple[str, ...], tuple[str, ...]]] = {
    "reference": (("reference",), ()),
    "formats": (("formats", "reference"), ("nlohmann/",)),
    "certify": (("certify", "formats", "reference"), ("nlohmann/",)),
    "bindings": (("bindings", "certify", "formats", "reference"), ()),
    "fuzz": (("fuzz", "formats", "reference"), ("nlohmann/",)),
    "oracle": (("oracle",), FOREIGN),
}
_AFTER_CRITICAL = tuple(f"reference/plane/{room}/" for room in ("history", "dynamic", "index"))
# Folder: forbidden includes from the same room. The two ways through the scales share only the
# parts below them.
APART = {
    "reference/number": ("reference/plane/", "reference/space/"),
    "reference/plane": (
        "reference/space/", "reference/motion/", "reference/paper/", "reference/scene/",
    ),
    "reference/disc": ("reference/paper/",),
    "reference/space": ("reference/motion/", "reference/paper/"),
    "reference/motion": ("reference/space/", "reference/disc/", "reference/paper/"),
    "reference/scene": ("reference/space/", "reference/disc/", "reference/paper/"),
    "reference/paper/plane": ("reference/paper/trials/",),
    "reference/paper/space": ("reference/paper/trials/",),
    "reference/plane/moving": ("reference/plane/critical/", *_AFTER_CRITICAL),
    "reference/plane/critical": _AFTER_CRITICAL,
    "reference/plane/history": _AFTER_CRITICAL[1:],
    "reference/plane/dynamic": ("reference/plane/index/",),
    "reference/plane/index": ("reference/plane/dynamic/",),
    "reference/space/definition": tuple(
        f"reference/space/{room}/" for room in ("convex", "edges")
    ),
    "reference/space/critical": tuple(
        f"reference/space/{room}/" for room in ("convex", "definition")
    ),
    "reference/motion/space": (
        "reference/disc/", "reference/paper/",
        *(f"reference/space/{room}/" for room in ("convex", "critical", "edges")),
    ),
    "reference/motion/space/free": (
        "reference/disc/", "reference/paper/", "reference/space/convex/",
    ),
    "reference/space/edges": tuple(
        f"reference/space/{room}/" for room in ("convex", "definition")
    ),
}  # fmt: skip
# Folder: a subfolder whose own rule replaces the outer folder's.
ITS_OWN = {
    "reference/motion": "reference/motion/space",
    "reference/motion/space": "reference/motion/space/free",
}
# Room: modules that Python files there may not import.
NO_IMPORT = {"oracle": ("minkref", "fuzz", "reports")}
# Commands that only run the checker, or unpack its files.
CHECK_COMMANDS = tuple(
    Path(f"minkref/verbs/{name}.py") for name in ("check", "certify_check", "unpacked")
)
STANDARD_LIBRARY_ONLY = (
    "oracle/slow", "oracle/features", "oracle/places", "oracle/distances", "oracle/checker",
)  # fmt: skip
# The floors of the package, from the ground up: a module imports nothing from a higher floor,
# neither by statement nor by name. The last matching line gives a folder's floor. The ground floor
# holds the package's own basics: values, operands and streams; the package's interface stands above
# everything it offers.
API = ("minkref/api", "minkref/api.py", "minkref/__init__.py")
SETTINGS = ("plane", "disc", "space", "motion", "scene")
COMMANDS = (
    "minkref/verbs", "minkref/cli", "minkref/page", "minkref/schemas",
    *(f"minkref/{setting}/{room}" for setting in SETTINGS for room in ("commands", "page")),
)  # fmt: skip
FLOORS = (
    ("minkref",), ("certify",), API, ("fuzz",), ("degeneracies",),
    ("minkref/strategies", "reports"), COMMANDS, ("reports/documentation", "reports/evidence"),
)  # fmt: skip
DOOR = Path("minkref/__main__.py")  # for `python -m minkref`
# Words forbidden in the room's build files, except in comments.
NO_LINK = {"reference": ("CGAL", "nlohmann", "minkref::formats")}


def room_of_test(path: Path) -> str:
    """tests/oracle may see the oracle; no other test may."""
    return "oracle" if path.parts[1] == "oracle" else "tests"


def includes(text: str) -> Iterator[tuple[int, str]]:
    for found in INCLUDE.finditer(text):
        yield text.count("\n", 0, found.start()) + 1, found[2]


def room_named(include: str) -> str | None:
    """The room that an include path leads to, also through `../`."""
    parts = [part for part in include.split("/") if part not in ("", ".", "..")]
    return parts[0] if len(parts) > 1 and parts[0] in ROOMS else None


def check_cpp(root: Path) -> Iterator[str]:
    for path in sorted((*root.rglob("*.cpp"), *root.rglob("*.hpp"), *root.rglob("*.h"))):
        relative = path.relative_to(root)
        room = relative.parts[0]
        if room not in (*MAY_INCLUDE, "tests"):
            continue
        if room == "tests":
            room = room_of_test(relative)
        own, foreign = MAY_INCLUDE.get(
            room, (tuple(r for r in ROOMS if r != "oracle"), ("nlohmann/",))
        )
        apart = [
            apart for folder, apart in APART.items()
            if relative.is_relative_to(folder)
            and not relative.is_relative_to(ITS_OWN.get(folder, "/"))
        ]  # fmt: skip
        for line, include in includes(path.read_text(encoding="utf-8")):
            target = room_named(include)
            if ".." in include.split("/"):
                yield f"{relative}:{line}: {include}: includes are written from the root"
            elif target is not None and target not in own:
                yield f"{relative}:{line}: {room} may not include {include}"
            elif any(include.startswith(folders) for folders in apart):
                yield f"{relative}:{line}: {relative.parent} may not include {include}"
            elif include.startswith(FOREIGN) and not include.startswith(foreign):
                yield f"{relative}:{line}: {room} may not use {include}"


def imports(tree: ast.AST) -> Iterator[tuple[int, str, int]]:
    """Line, dotted name, level (0 for an absolute import)."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            for alias in node.names:
                yield node.lineno, alias.name, 0
        elif isinstance(node, ast.ImportFrom):
            yield node.lineno, node.module or "", node.level


def floor_of(place: str) -> int:
    """The floor of a path from the root, or of a module written as a path; -1 if no floor
    matches."""
    found = -1
    for floor, rooms in enumerate(FLOORS):
        if any(place == room or place.startswith(f"{room}/") for room in rooms):
            found = floor
    return found


def place_of(module: str) -> str:
    """`reports/audit/page` for minkref.reports.audit.page; a path below minkref/ for modules
    outside the rooms."""
    inside = "/".join(module.split(".")[1:])
    room = inside.split("/")[0]
    return inside if room in ROOMS else f"minkref/{inside}"


def modules(tree: ast.AST) -> Iterator[tuple[int, str]]:
    """Line and name of each imported module of the package, by statement or by name, as far as the
    source spells the name out."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Import):
            yield from ((node.lineno, alias.name) for alias in node.names)
        elif isinstance(node, ast.ImportFrom) and node.level == 0:
            names = [node.module or ""]
            if node.module == "minkref":
                names = [f"minkref.{alias.name}" for alias in node.names]
            yield from ((node.lineno, name) for name in names)
        elif isinstance(node, ast.Call) and node.args:
            function = node.func
            name = function.attr if isinstance(function, ast.Attribute) else ""
            name = function.id if isinstance(function, ast.Name) else name
            first: ast.AST = node.args[0]
            if isinstance(first, ast.JoinedStr):
                first = first.values[0]
            if name in ("import_module", "__import__") and isinstance(first, ast.Constant):
                yield node.lineno, str(first.value).rstrip(".")


def check_floors(root: Path) -> Iterator[str]:
    for path in sorted(root.rglob("*.py")):
        relative = path.relative_to(root)
        floor = floor_of(relative.as_posix())
        if floor < 0 or relative == DOOR:
            continue
        for line, module in modules(ast.parse(path.read_text(encoding="utf-8"))):
            if module.startswith("minkref.") and floor_of(place_of(module)) > floor:
                yield f"{relative}:{line}: {module} stands on a floor above"


def check_python(root: Path) -> Iterator[str]:
    for path in sorted(root.rglob("*.py")):
        relative = path.relative_to(root)
        room = relative.parts[0]
        if room not in ROOMS:
            continue
        alone = next((f for f in STANDARD_LIBRARY_ONLY if relative.is_relative_to(f)), None)
        text = path.read_text(encoding="utf-8")
        if room == "oracle":
            for found in BY_NAME.finditer(text):
                line = text.count("\n", 0, found.start()) + 1
                yield f"{relative}:{line}: a judge imports nothing of another: {found[0]}"
        for line, name, level in imports(ast.parse(text)):
            first = name.split(".")[0]
            if level == 0 and first in NO_IMPORT.get(room, ()):
                yield f"{relative}:{line}: {room} may not import {name}"
            elif room != "oracle" and level == 0 and first == "oracle":
                yield f"{relative}:{line}: nobody imports the oracle: {name}"
            elif room == "oracle" and level > len(relative.parts) - 2:  # out of its folder
                yield f"{relative}:{line}: a judge imports nothing of another: {'.' * level}{name}"
            elif name == "minkref.oracle.checker" and relative in CHECK_COMMANDS:
                pass
            elif room != "fuzz" and level == 0 and name.startswith("minkref.oracle"):
                yield f"{relative}:{line}: only fuzz/ puts the oracle to use: {name}"
            elif alone and level == 0 and first not in sys.stdlib_module_names:
                if not name.startswith(alone.replace("/", ".")):
                    yield f"{relative}:{line}: {alone} imports the standard library only: {name}"


def check_build_files(root: Path) -> Iterator[str]:
    for room, words in NO_LINK.items():
        for path in sorted((root / room).rglob("CMakeLists.txt")):
            for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
                for word in words:
                    if word in line.split("#")[0]:
                        yield f"{path.relative_to(root)}:{number}: {room} may not use {word}"


def faults(root: Path) -> list[str]:
    return [
        *check_cpp(root), *check_python(root), *check_floors(root), *check_build_files(root),
    ]  # fmt: skip


def main() -> int:
    root = Path(sys.argv[1]) if len(sys.argv) > 1 else Path(__file__).resolve().parents[2]
    found = faults(root)
    for fault in found:
        print(fault)
    print(f"independence: {len(found)} faults" if found else "independence: the rule is kept")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
