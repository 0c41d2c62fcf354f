"""One run of `minkref verify --json`, cut down to the verdicts of libraries and kept."""

from __future__ import annotations

import json
from collections import Counter
from dataclasses import dataclass
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from minkref.fuzz.libraries import catalogue
from minkref.fuzz.verdicts.verdict import GOOD, Verdict

FILE = Path(__file__).parent / "kept_run.json"
SUMS, UNIONS, OFFSETS = "Sums", "Unions", "Offsets"
OPEN = (Verdict.SKIPPED, Verdict.UNDECIDED)  # say nothing about the target


@dataclass(frozen=True)
class Cell:
    """A target's verdicts on a family, without `OPEN` ones. `asked`: sums, unions or offsets."""

    asked: str
    target: str
    family: str
    verdicts: dict[str, int]

    @property
    def judged(self) -> int:
        return sum(self.verdicts.values())

    @property
    def right(self) -> int:
        return sum(self.verdicts.get(verdict, 0) for verdict in GOOD)


@dataclass(frozen=True)
class Kept:
    """`seconds` and `cases` of the whole run. `versions` and `reasons` by target: reasons of wrong
    answers with their counts. `shrunk`: findings made small."""

    date: str
    seed: int
    seconds: int
    cases: int
    shrunk: int
    versions: dict[str, str]
    reasons: dict[str, dict[str, int]]
    cells: tuple[Cell, ...]

    def of(self, target: str) -> list[Cell]:
        return [cell for cell in self.cells if cell.target == target]

    @property
    def libraries(self) -> dict[str, list[str]]:
        """The judged targets by the title of their library."""
        found: dict[str, list[str]] = {}
        for target in self.versions:
            if self.of(target):
                found.setdefault(library_of(target), []).append(target)
        return found


def library_of(target: str) -> str:
    """The title of the library with the longest matching prefix."""
    fitting = [each for each in catalogue.LIBRARIES.values() if target.startswith(each.targets)]
    return max(fitting, key=lambda each: len(each.targets)).title


def keep(document: Path, file: Path = FILE) -> None:
    """Writes what the page needs of a document of `verify`, a cell in each line."""
    run = json.loads(document.read_text(encoding="utf-8"))
    reasons: dict[str, Counter[str]] = {}
    for finding in run["findings"]:
        reasons.setdefault(finding["target"], Counter()).update(finding["reasons"])
    head: dict[str, Any] = {
        "date": f"{datetime.fromtimestamp(document.stat().st_mtime, tz=UTC):%Y-%m-%d}",
        "seed": run["seed"],
        "seconds": round(run["seconds"]),
        "cases": sum(group["cases"] for group in run["groups"]),
        "shrunk": len(run["shrunk"]),
        "versions": {each["name"]: each["version"] or "" for each in run["targets"]},
        "reasons": {target: dict(counts) for target, counts in reasons.items()},
    }
    targets = {each["name"]: each for each in run["targets"]}
    cells = []
    for cell in run["matrix"]:
        verdicts = {v: n for v, n in cell["verdicts"].items() if v not in OPEN}
        if verdicts:
            asked = _asked(targets[cell["target"]], cell["group"])
            cells.append(json.dumps([asked, cell["target"], cell["group"], verdicts]))
    lines = [f'"{key}": {json.dumps(value)},' for key, value in head.items()]
    told = ",\n".join(cells)
    file.write_text("\n".join(["{", *lines, f'"cells": [\n{told}\n]', "}", ""]), encoding="utf-8")


def _asked(target: dict[str, Any], group: str) -> str:
    """Groups that the target was asked for: `mutants` mix all."""
    if target["sum"] == "none":
        return OFFSETS if "offset" in target["capabilities"] else UNIONS
    return {"unions": UNIONS, "offsets": OFFSETS}.get(group, SUMS)


def kept() -> Kept:
    """The kept run."""
    value = json.loads(FILE.read_text(encoding="utf-8"))
    cells = tuple(Cell(*each) for each in value.pop("cells"))
    return Kept(**value, cells=cells)
