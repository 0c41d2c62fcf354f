"""The CGAL oracle's executables: their places, their methods, the commands that build them."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from functools import cache
from pathlib import Path
from typing import Any

from minkref.errors import Refusal

BUILD_COMMAND = "cmake --preset release && cmake --build --preset release --target minkref_cgal"
METHOD_GROUPS = {
    "reduced": "reduced",
    "full": "full",
    "vertical": "decomposition",
    "triangulation": "decomposition",
    "ssab": "decomposition",
    "optimal": "decomposition",
    "hertel-mehlhorn": "decomposition",
    "greene": "decomposition",
}
SWEPT_SOLID = "swept-solid"  # not a sum: the vertex heights of the solid that the sum sweeps
GROUPS = {**METHOD_GROUPS, SWEPT_SOLID: "swept"}
METHODS_WITH_HOLES = ("reduced", "vertical", "triangulation")
ABOUT = {
    "reduced": "CGAL, reduced convolution",
    "full": "CGAL, full convolution (no holes)",
    "vertical": "CGAL, vertical decomposition",
    "triangulation": "CGAL, triangulation",
    "ssab": "CGAL, small-side angle-bisector decomposition (no holes)",
    "optimal": "CGAL, optimal convex decomposition (no holes)",
    "hertel-mehlhorn": "CGAL, Hertel-Mehlhorn convex decomposition (no holes)",
    "greene": "CGAL, Greene convex decomposition (no holes)",
}


class OracleNotFoundError(FileNotFoundError):
    """The executable was not built, or lies outside the searched folders."""


def search_folders() -> list[Path]:
    """Returns, in this order: the folders in MINKREF_CGAL, the interpreter's folder, the checkout's
    build folder."""
    return [*given_folders(), *built_folders("cgal")]


def built_folders(room: str) -> list[Path]:
    """Returns folders that may hold a room's executables (oracle/ROOM): the interpreter's folder,
    and the checkout's build folder."""
    checkouts = dict.fromkeys([Path(__file__).resolve().parents[2], Path(sys.prefix).parent])
    built = [checkout / "build" / "release" / "oracle" / room for checkout in checkouts]
    return [Path(sys.executable).parent, *built]


def given_folders() -> list[Path]:
    """Returns the folders in MINKREF_CGAL, separated by colons: builds of the oracle with several
    CGAL versions."""
    given = os.environ.get("MINKREF_CGAL", "")
    return [Path(part) for part in given.split(os.pathsep) if part]


def refuse_wrong_folder() -> None:
    """Refuses a MINKREF_CGAL that names a folder without executables of the oracle."""
    for folder in given_folders():
        what = "there is no such folder"
        if folder.is_dir():
            groups = METHOD_GROUPS.values()
            if any((folder / f"minkref-cgal-{group}").is_file() for group in groups):
                continue
            what = "the folder holds no executable of the CGAL oracle"
        raise Refusal(
            what,
            f"MINKREF_CGAL={os.environ['MINKREF_CGAL']}",
            "name folders that hold minkref-cgal-reduced, separated by colons, or unset it",
            "no-such-folder",
        )


def find_executable(method: str) -> Path:
    """Returns the server that knows `method`. OracleNotFoundError names the build command."""
    found = _executables(method)
    if found:
        return found[0]
    name = f"minkref-cgal-{GROUPS[method]}"
    raise OracleNotFoundError(f"{name} was not found; build it with: {BUILD_COMMAND}")


def _executables(method: str) -> list[Path]:
    name = f"minkref-cgal-{GROUPS[method]}"
    candidates = (folder / name for folder in search_folders())
    return [path for path in candidates if path.is_file() and os.access(path, os.X_OK)]


def executable_of_target(target: str) -> Path:
    """Returns the server for `cgal-METHOD`; for `cgal-METHOD@VERSION` the first with this CGAL
    version."""
    method, _ = method_of_target(target)
    _, at, version = target.partition("@")
    if not at:
        return find_executable(method)
    for path in _executables(method):
        if cgal_version(method, path) == version:
            return path
    raise OracleNotFoundError(
        f"no executable of CGAL {version} is found; name its folder in MINKREF_CGAL"
    )


def other_versions(method: str) -> list[str]:
    """CGAL versions of further executables for `method`, other than the first one's version."""
    paths = _executables(method)
    versions = [cgal_version(method, path) for path in paths]
    return [version for version in dict.fromkeys(versions) if version != versions[0]]


@cache
def _description(executable: Path, modified: float) -> dict[str, Any]:
    command = [str(executable), "--version"]
    text = subprocess.run(command, capture_output=True, text=True, check=True, timeout=60).stdout
    description: dict[str, Any] = json.loads(text)
    return description


def cgal_version(method: str, executable: Path | None = None) -> str:
    """The CGAL version that the server for `method` was compiled with, as `5.5.1`."""
    path = executable or find_executable(method)
    return str(_description(path, path.stat().st_mtime)["cgal"])


def target_names() -> list[str]:
    """All targets of this oracle, built or not: targets with `-raw` pass every hole to CGAL;
    targets with `@VERSION` use further CGAL versions, if MINKREF_CGAL names several folders."""
    names = [f"cgal-{method}" for method in METHOD_GROUPS]
    names += [f"cgal-{method}-raw" for method in METHODS_WITH_HOLES]
    return names + [
        f"{name}@{version}"
        for name in names
        for version in other_versions(method_of_target(name)[0])
    ]


def method_of_target(target: str) -> tuple[str, bool]:
    """Splits a target into method and rawness: cgal-vertical-raw gives ("vertical", True)."""
    method = target.removeprefix("cgal-").partition("@")[0]
    return method.removesuffix("-raw"), method.endswith("-raw")


def available_targets() -> list[str]:
    """The targets whose executable exists."""
    found = []
    for target in target_names():
        try:
            find_executable(method_of_target(target)[0])
        except OracleNotFoundError:
            continue
        found.append(target)
    return found
