"""Numbers of convex pieces by CGAL, to compare with: Hertel and Mehlhorn's partition, and Greene's
optimal one, of simple polygons."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Self

from minkref.fuzz.cgal.executables import BUILD_COMMAND, search_folders
from minkref.fuzz.cgal.line_process import LineProcess

_PROGRAM = "minkref-cgal-partition"
Ring = Sequence[tuple[object, object]]  # coordinates that print exactly


@dataclass(frozen=True)
class PartitionAnswer:
    """Numbers of pieces; None where there is no answer, and then `why` gives the reason."""

    approximate: int | None
    optimal: int | None = None
    seconds: float = 0.0
    why: str = ""


def executable() -> Path | None:
    paths = (folder / _PROGRAM for folder in search_folders())
    return next((path for path in paths if path.is_file()), None)


def absence() -> str | None:
    """Names the missing program, and the command that builds it."""
    return None if executable() else f"{_PROGRAM} is not built: {BUILD_COMMAND}"


class PartitionJudge:
    """CGAL in a child process for many polygons. Close it, or use `with`."""

    def __init__(self, seconds: float) -> None:
        path = executable()
        self._process = None if path is None else LineProcess(path, seconds)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        if self._process is not None:
            self._process.close()

    def count(self, ring: Ring, optimal: bool) -> PartitionAnswer:
        """Counts the pieces of a simple polygon, counter-clockwise, without straight vertices. The
        optimal partition takes n^4 steps and n^3 memory."""
        if self._process is None:
            return PartitionAnswer(None, why=str(absence()))
        asked = [[str(x), str(y)] for x, y in ring]
        found = self._process.ask({"ring": asked, "optimal": optimal})
        if "error" in found:
            return PartitionAnswer(None, why=str(found["error"]))
        return PartitionAnswer(found["approximate"], found.get("optimal"), found["seconds"])
