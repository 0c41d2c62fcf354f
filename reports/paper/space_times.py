"""Times of the paper's update in space (Fig. 9), made by the evidence (`make evidence
ONLY=paper_program/space_times FULL=1`), which in full writes space_times.json."""

from __future__ import annotations

import json
from dataclasses import asdict, dataclass
from importlib import resources
from typing import Any

from minkref.reports.bench.rank_correlation import Interval, rank_correlation

FILE = "space_times.json"


@dataclass(frozen=True)
class Step:
    """A re-scaling; seconds are the least of several. `update`: stepping through the events;
    `placing`: all `crossings` at the end; the clock's. `near`: finding the crossings there from
    scratch, among facets whose boxes meet; `whole`: arrangements and collision detection (None: not
    timed); the processor's."""

    start: str
    scale: str
    events: int
    crossings: int
    update: float
    placing: float
    near: float
    whole: float | None

    @property
    def ours(self) -> float:
        return self.update + self.placing


@dataclass(frozen=True)
class Timed:
    """A pair of solids in an arithmetic. `facets` of the convolution; `crossings` that exist at
    some scale, with so many `events`; `preparation`: processor seconds for all of them; `search`:
    processor seconds for finding the crossings at one scale among all pairs."""

    name: str
    arithmetic: str
    facets: int
    crossings: int
    events: int
    preparation: float
    search: float
    steps: tuple[Step, ...]

    @property
    def pairs(self) -> int:
        return self.facets * (self.facets - 1) // 2

    def intersections(self, of_all: bool = False) -> list[float]:
        """Part (d): times faster, ascending; against facets whose boxes meet, or all pairs."""
        return sorted(self._scratch(step, of_all) / step.ours for step in self.steps)

    def total(self, of_all: bool = False) -> list[float]:
        """Part (c): with arrangements and collision detection on both sides."""
        return sorted(
            (self._scratch(step, of_all) + step.whole) / (step.ours + step.whole)
            for step in self.steps
            if step.whole is not None
        )

    def falls(self) -> Interval:
        """The rank correlation of part (d) with the number of events."""
        return rank_correlation(
            [step.near / step.ours for step in self.steps], [step.events for step in self.steps]
        )

    def _scratch(self, step: Step, of_all: bool) -> float:
        return self.search if of_all else step.near


@dataclass(frozen=True)
class Times:
    """`window` of scales in words; the least of so many `repetitions` of updates, and of
    `searches`."""

    date: str
    window: str
    repetitions: int
    searches: int
    runs: tuple[Timed, ...]

    def names(self) -> list[str]:
        return list(dict.fromkeys(run.name for run in self.runs))

    def of(self, arithmetic: str) -> list[Timed]:
        return [run for run in self.runs if run.arithmetic == arithmetic]


def as_text(times: Times) -> str:
    """A line for each run, seconds to four digits."""
    head = {key: value for key, value in asdict(times).items() if key != "runs"}
    columns = list(Step.__dataclass_fields__)
    lines = [f'"{key}": {json.dumps(value)},' for key, value in head.items()]
    lines.append(f'"steps": {json.dumps(columns)},')
    rows = []
    for run in times.runs:
        row = {key: _told(value) for key, value in asdict(run).items()}
        row["steps"] = [[_told(getattr(step, name)) for name in columns] for step in run.steps]
        rows.append(json.dumps(row))
    return "{\n" + "\n".join(lines) + '\n"runs": [\n' + ",\n".join(rows) + "\n]\n}\n"


def _told(value: Any) -> Any:
    return float(f"{value:.4g}") if isinstance(value, float) else value


def read(text: str) -> Times:
    value = json.loads(text)
    columns = value.pop("steps")
    runs = tuple(
        Timed(**{
            **run,
            "steps": tuple(Step(**dict(zip(columns, step, strict=True))) for step in run["steps"]),
        })
        for run in value.pop("runs")
    )  # fmt: skip
    return Times(runs=runs, **value)


def kept() -> Times | None:
    """The last full run's times, if kept."""
    try:
        return read((resources.files(__package__) / FILE).read_text(encoding="utf-8"))
    except FileNotFoundError:
        return None
