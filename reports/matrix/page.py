"""The page docs/matrix.md with its badges: `python -m minkref.reports.matrix.page [RUN.json]`.

RUN.json, a document of `minkref verify --json`, replaces earlier verdicts about its targets.
"""

from __future__ import annotations

import sys
import textwrap
from collections import Counter
from collections.abc import Iterable
from pathlib import Path

import minkref.reports
from minkref.fuzz.verdicts.verdict import GOOD, Verdict
from minkref.reports.matrix.badge import badge
from minkref.reports.matrix.kept_run import (
    OFFSETS,
    PATHS,
    SUMS,
    UNIONS,
    Cell,
    Kept,
    Run,
    keep,
    kept,
)

DOCS = Path(minkref.reports.__file__).resolve().parents[1] / "docs"
PAGE = DOCS / "matrix.md"
BADGES = DOCS / "matrix"
WIDTH = 120
HEAD = (Path(__file__).parent / "head.md").read_text(encoding="utf-8")


def page() -> str:
    """The whole page, as Markdown."""
    run = kept()
    libraries = run.libraries
    told = f"{len(libraries)} libraries. {' '.join(map(_told, run.runs))}"
    images = " ".join(f"![{title}](matrix/{_file(title)})" for title in libraries)
    parts = [HEAD.rstrip(), _wrapped(told), images, _targets(run)]
    for asked in (SUMS, UNIONS, OFFSETS, PATHS):
        if any(cell.asked == asked for cell in run.cells):
            parts += [f"## {asked}", _families(run, asked)]
    return "\n\n".join(parts) + "\n"


def _told(run: Run) -> str:
    return (
        f"A run of {run.date}: seed {run.seed}, {run.cases:,} cases in {run.seconds // 60} "
        f"minutes, {len(run.targets)} targets, {run.shrunk} findings made small."
    )


def badges() -> dict[str, str]:
    """Each badge's file name and text."""
    run = kept()
    found = {}
    for title, targets in run.libraries.items():
        cells = [cell for target in targets for cell in run.of(target)]
        found[_file(title)] = badge(title, *_right_of_judged(cells))
    return found


def _targets(run: Kept) -> str:
    rows = []
    for title, targets in run.libraries.items():
        for target in targets:
            verdicts = sum((Counter(cell.verdicts) for cell in run.of(target)), Counter())
            amiss = ", ".join(
                f"{verdicts[v]} {v}" for v in Verdict if v in verdicts.keys() - set(GOOD)
            )
            reasons = ", ".join(
                f"{n} {reason}" for reason, n in run.reasons.get(target, {}).items()
            )
            rows.append([
                f"{title} {run.versions[target]}", f"`{target}`", f"{verdicts.total():,}",
                *(f"{verdicts[v]:,}" for v in GOOD), amiss, reasons,
            ])  # fmt: skip
    heads = ["Library", "Target", "Judged", "Right", "Within tolerance", "Not right", "Reasons"]
    return _table(heads, rows)


def _families(run: Kept, asked: str) -> str:
    cells = [cell for cell in run.cells if cell.asked == asked]
    columns = {
        title: [cell for cell in cells if cell.target in targets]
        for title, targets in run.libraries.items()
    }
    columns = {title: own for title, own in columns.items() if own}
    rows = [
        [family, *(_share([c for c in own if c.family == family]) for own in columns.values())]
        for family in dict.fromkeys(cell.family for cell in cells)
    ]
    return _table(["Family", *columns], rows)


def _share(cells: Iterable[Cell]) -> str:
    right, judged = _right_of_judged(cells)
    if not judged:
        return ""
    return str(judged) if right == judged else f"**{right}/{judged}**"


def _right_of_judged(cells: Iterable[Cell]) -> tuple[int, int]:
    every = list(cells)
    return sum(cell.right for cell in every), sum(cell.judged for cell in every)


def _table(heads: list[str], rows: list[list[str]]) -> str:
    lines = [heads, ["---"] * len(heads), *rows]
    return "\n".join(f"| {' | '.join(line)} |" for line in lines)


def _file(title: str) -> str:
    return f"{title.lower().replace(' ', '-').replace('.', '-')}.svg"


def _wrapped(text: str) -> str:
    return textwrap.fill(text, WIDTH, break_long_words=False, break_on_hyphens=False)


def write() -> None:
    PAGE.write_text(page(), encoding="utf-8")
    BADGES.mkdir(exist_ok=True)
    for name, text in badges().items():
        (BADGES / name).write_text(text, encoding="utf-8")


if __name__ == "__main__":
    if len(sys.argv) > 1:
        keep(Path(sys.argv[1]))
    write()
