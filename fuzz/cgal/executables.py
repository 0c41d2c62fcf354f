"""The executables of the CGAL oracle: where they are, what they offer, how to build them."""

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
SWEPT_SOLID = "swept-solid"  # not a sum: heights of the vertices of the solid that the sum sweeps
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
    """The executable was not built, or is not where it is looked for."""


def search_folders() -> list[Path]:
    """In this order: MINKREF_CGAL, beside the interpreter, the build folder of the checkout."""
    given = os.environ.get("MINKREF_CGAL")
    folders = [Path(given)] if given else []
    folders.append(Path(sys.executable).parent)
    checkouts = dict.fromkeys([Path(__file__).resolve().parents[2], Path(sys.prefix).parent])
    folders += [checkout / "build" / "release" / "oracle" / "cgal" for checkout in checkouts]
    return folders


def refuse_wrong_folder() -> None:
    """Refuses a MINKREF_CGAL that is no folder with executables of the oracle."""
    given = os.environ.get("MINKREF_CGAL")
    if not given:
        return
    folder = Path(given)
    what = "there is no such folder"
    if folder.is_dir():
        if any((folder / f"minkref-cgal-{group}").is_file() for group in METHOD_GROUPS.values()):
            return
        what = "the folder holds no executable of the CGAL oracle"
    raise Refusal(
        what,
        f"MINKREF_CGAL={given}",
        "name the folder that holds minkref-cgal-reduced, or unset it",
        "no-such-folder",
    )


def find_executable(method: str) -> Path:
    """The server that knows `method`. OracleNotFoundError names the command that builds it."""
    name = f"minkref-cgal-{GROUPS[method]}"
    for folder in search_folders():
        candidate = folder / name
        if candidate.is_file() and os.access(candidate, os.X_OK):
            return candidate
    raise OracleNotFoundError(f"{name} was not found; build it with: {BUILD_COMMAND}")


@cache
def _description(executable: Path, modified: float) -> dict[str, Any]:
    command = [str(executable), "--version"]
    text = subprocess.run(command, capture_output=True, text=True, check=True, timeout=60).stdout
    description: dict[str, Any] = json.loads(text)
    return description


def cgal_version(method: str, executable: Path | None = None) -> str:
    """The version of CGAL that the server of `method` was compiled with, as `5.5.1`."""
    path = executable or find_executable(method)
    return str(_description(path, path.stat().st_mtime)["cgal"])


def target_names() -> list[str]:
    """All targets of this oracle, built or not: those with `-raw` call CGAL with every hole."""
    names = [f"cgal-{method}" for method in METHOD_GROUPS]
    return names + [f"cgal-{method}-raw" for method in METHODS_WITH_HOLES]


def method_of_target(target: str) -> tuple[str, bool]:
    """The method and whether it is raw: cgal-vertical-raw is ("vertical", True)."""
    method = target.removeprefix("cgal-")
    return method.removesuffix("-raw"), method.endswith("-raw")


def available_targets() -> list[str]:
    """The targets whose executable is there."""
    found = []
    for target in target_names():
        try:
            find_executable(method_of_target(target)[0])
        except OracleNotFoundError:
            continue
        found.append(target)
    return found
