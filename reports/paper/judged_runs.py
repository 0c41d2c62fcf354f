"""Runs of the paper's own programs beside other programs, made by the evidence (`make evidence
ONLY=paper_targets`). A full evidence run writes judged_sums.json, judged_solids.json and
judged_events.json."""

from __future__ import annotations

import json
from collections.abc import Sequence
from dataclasses import asdict, dataclass
from importlib import resources

SUMS, SOLIDS = "judged_sums.json", "judged_solids.json"
EVENTS = "judged_events.json"


@dataclass(frozen=True)
class Row:
    """A program in one arithmetic beside another program: counts of cases or events by outcome."""

    program: str
    arithmetic: str
    against: str
    counts: dict[str, int]

    @property
    def bits(self) -> int | None:
        """The bits of MPFR; None for other arithmetics."""
        kind, _, bits = self.arithmetic.partition(":")
        return int(bits) if kind == "mpfr" else None


@dataclass(frozen=True)
class Judged:
    """`least`: counts, for each program, how many bits suffice for a case."""

    date: str
    cases: int
    rows: tuple[Row, ...]
    least: dict[str, dict[str, int]]

    def of(self, program: str, against: str) -> list[Row]:
        """Rows in MPFR, ascending precision."""
        found = [r for r in self.rows if (r.program, r.against) == (program, against) and r.bits]
        return sorted(found, key=lambda row: row.bits or 0)

    def programs(self) -> list[str]:
        return list(dict.fromkeys(row.program for row in self.rows))

    def others(self, program: str) -> list[str]:
        return list(dict.fromkeys(row.against for row in self.rows if row.program == program))


def as_text(judged: Judged) -> str:
    """A line for each row."""
    head = {"date": judged.date, "cases": judged.cases, "least": judged.least}
    lines = [f'"{key}": {json.dumps(value)},' for key, value in head.items()]
    rows = ",\n".join(json.dumps(asdict(row)) for row in judged.rows)
    return "{\n" + "\n".join(lines) + f'\n"rows": [\n{rows}\n]\n' + "}\n"


def read(text: str) -> Judged:
    value = json.loads(text)
    rows = tuple(Row(**row) for row in value["rows"])
    return Judged(value["date"], value["cases"], rows, value["least"])


def kept(file: str) -> Judged | None:
    """The runs of the last full evidence, if kept."""
    try:
        return read((resources.files(__package__) / file).read_text(encoding="utf-8"))
    except FileNotFoundError:
        return None


def together(*every: Judged | None) -> Judged | None:
    """Joins the runs of several files; None without any."""
    found = [judged for judged in every if judged is not None]
    if not found:
        return None
    rows = tuple(row for judged in found for row in judged.rows)
    least = {program: counts for judged in found for program, counts in judged.least.items()}
    date = min(judged.date for judged in found)
    return Judged(date, sum(judged.cases for judged in found), rows, least)


def share(row: Row, kinds: Sequence[str], of: Sequence[str]) -> float:
    """Percentage: `kinds` per `of`."""
    total = sum(row.counts.get(kind, 0) for kind in of)
    return 100 * sum(row.counts.get(kind, 0) for kind in kinds) / total if total else 0.0
