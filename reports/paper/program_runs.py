"""Runs of the paper's own program, made by the evidence (`make evidence ONLY=paper_program`): how
often the sum was right. A full evidence run writes program_runs.json."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from importlib import resources
from typing import Any

FILE = "program_runs.json"
CORRECTED = "all corrected"  # the variant


@dataclass(frozen=True)
class Run:
    """A program's run on a pair of operands. `right`: whether the structure was right after each
    number of re-scalings from `Runs`; `seconds` of processor time for finding the regions of so
    many edge `pairs`."""

    name: str
    arithmetic: str
    variant: str
    right: tuple[bool, ...]
    most_ulps: float
    pairs: int
    seconds: float


@dataclass(frozen=True)
class Runs:
    """`paper_models`: whether the large pairs are the paper's own; `variants` in their order."""

    date: str
    paper_models: bool
    after: tuple[int, ...]
    variants: tuple[str, ...]
    runs: tuple[Run, ...]

    def names(self) -> list[str]:
        return list(dict.fromkeys(run.name for run in self.runs))

    def of(self, variant: str, arithmetic: str) -> list[Run]:
        return [r for r in self.runs if (r.variant, r.arithmetic) == (variant, arithmetic)]


def as_text(runs: Runs) -> str:
    """A line for each run."""
    head = {key: value for key, value in asdict(runs).items() if key != "runs"}
    columns = list(Run.__dataclass_fields__)
    rows = [[getattr(run, column) for column in columns] for run in runs.runs]
    lines = [f'"{key}": {json.dumps(value)},' for key, value in head.items()]
    lines.append(f'"columns": {json.dumps(columns)},')
    told = ",\n".join(json.dumps([_told(value) for value in row]) for row in rows)
    return "{\n" + "\n".join(lines) + f'\n"rows": [\n{told}\n]\n' + "}\n"


def _told(value: Any) -> Any:
    if isinstance(value, tuple):
        return "".join("1" if right else "0" for right in value)
    return float(f"{value:.4g}") if isinstance(value, float) else value


def read(text: str) -> Runs:
    value = json.loads(text)
    runs = []
    for row in value["rows"]:
        fields = dict(zip(value["columns"], row, strict=True))
        right = tuple(letter == "1" for letter in fields.pop("right"))
        runs.append(Run(right=right, **fields))
    return Runs(
        value["date"], value["paper_models"], tuple(value["after"]), tuple(value["variants"]),
        tuple(runs),
    )  # fmt: skip


def committed() -> Runs:
    """The runs of the last full run."""
    return read((resources.files(__package__) / FILE).read_text(encoding="utf-8"))


def share(runs: Sequence[Run], k: int) -> float:
    """Percentage of runs that were right after the k-th number of re-scalings."""
    return 100 * sum(run.right[k] for run in runs) / len(runs) if runs else 0.0
