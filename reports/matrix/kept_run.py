"""Runs of `minkref verify --json`, cut down to the verdicts of libraries and kept. A later run
replaces earlier verdicts about its targets."""

from __future__ import annotations

import json
from collections import Counter
from dataclasses import asdict, astuple, dataclass, replace
from datetime import UTC, datetime
from pathlib import Path
from typing import Any

from minkref.fuzz.libraries import catalogue
from minkref.fuzz.verdicts.verdict import GOOD, Verdict

FILE = Path(__file__).parent / "kept_run.json"
SUMS, UNIONS, OFFSETS, PATHS = "Sums", "Unions", "Offsets", "Paths"
OPEN = (Verdict.SKIPPED, Verdict.UNDECIDED)  # say nothing about the target


@dataclass(frozen=True)
class Cell:
    """A target's verdicts on a family, without `OPEN` ones. `asked`: sums, unions, offsets or
    paths."""

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
class Run:
    """`seconds` and `cases` of the whole run. `shrunk`: findings made small. `targets`: without
    later runs."""

    date: str
    seed: int
    seconds: int
    cases: int
    shrunk: int
    targets: list[str]


@dataclass(frozen=True)
class Kept:
    """`versions` and `reasons` by target: reasons of wrong answers with their counts."""

    runs: tuple[Run, ...]
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


NOTHING = Kept((), {}, {}, ())


def keep(document: Path, file: Path | None = None) -> None:
    """Adds a document of `verify`, cut down for the page, and drops earlier verdicts about its
    targets. Writes a cell in each line."""
    file = file or FILE
    found, before = _read(document), kept(file) if file.is_file() else NOTHING
    others = [target for target in before.versions if target not in found.versions]
    runs = [replace(run, targets=[t for t in run.targets if t in others]) for run in before.runs]
    head: dict[str, Any] = {
        "runs": [asdict(run) for run in (*runs, *found.runs) if run.targets],
        "versions": {t: before.versions[t] for t in others} | found.versions,
        "reasons": {t: r for t, r in before.reasons.items() if t in others} | found.reasons,
    }
    cells = [cell for cell in before.cells if cell.target in others] + [*found.cells]
    lines = [f'"{key}": {json.dumps(value)},' for key, value in head.items()]
    told = ",\n".join(json.dumps([*astuple(cell)]) for cell in cells)
    file.write_text("\n".join(["{", *lines, f'"cells": [\n{told}\n]', "}", ""]), encoding="utf-8")


def _read(document: Path) -> Kept:
    run = json.loads(document.read_text(encoding="utf-8"))
    targets = {each["name"]: each for each in run["targets"]}
    reasons: dict[str, Counter[str]] = {}
    for finding in run["findings"]:
        reasons.setdefault(finding["target"], Counter()).update(finding["reasons"])
    cells = []
    for cell in run["matrix"]:
        verdicts = {v: n for v, n in cell["verdicts"].items() if v not in OPEN}
        if verdicts:
            asked = _asked(targets[cell["target"]], cell["group"])
            cells.append(Cell(asked, cell["target"], cell["group"], verdicts))
    one = Run(
        date=f"{datetime.fromtimestamp(document.stat().st_mtime, tz=UTC):%Y-%m-%d}",
        seed=run["seed"],
        seconds=round(run["seconds"]),
        cases=sum(group["cases"] for group in run["groups"]),
        shrunk=len(run["shrunk"]),
        targets=[*targets],
    )
    versions = {name: each["version"] or "" for name, each in targets.items()}
    counts = {target: dict(each) for target, each in reasons.items()}
    return Kept((one,), versions, counts, tuple(cells))


def _asked(target: dict[str, Any], group: str) -> str:
    """Groups that the target was asked for: `mutants` mix all."""
    if target["sum"] == "none":
        able = {"offset": OFFSETS, "join-sharp": OFFSETS, "path": PATHS}
        return next((able[word] for word in target["capabilities"] if word in able), UNIONS)
    return {"unions": UNIONS, "offsets": OFFSETS, "paths": PATHS}.get(group, SUMS)


def kept(file: Path | None = None) -> Kept:
    """The kept runs."""
    value = json.loads((file or FILE).read_text(encoding="utf-8"))
    runs = tuple(Run(**each) for each in value.pop("runs"))
    return Kept(runs, **value | {"cells": tuple(Cell(*each) for each in value["cells"])})
