"""The three settings: their random cases, and their judges."""

from __future__ import annotations

import tempfile
from collections.abc import Callable
from pathlib import Path

from minkref.reports.evidence.as_written import (
    inputs_disc,
    inputs_plane,
    inputs_space,
    judge_events,
    judge_moving,
    judge_page,
    judge_pair_events,
    judge_plane,
    judge_radii,
    judge_space,
    judge_sum,
)
from minkref.reports.evidence.as_written.answers import Answers, Change
from minkref.reports.evidence.as_written.tally import Tally
from minkref.reports.evidence.as_written.units import use_bits

SEED = 46
DISC_JUDGES = {
    "sum": judge_sum.judge, "events": judge_events.judge, "pair events": judge_pair_events.judge,
    "radii": judge_radii.judge,
}  # fmt: skip


def with_disc(tally: Tally, answers: Answers, index: int) -> None:
    one = inputs_disc.drawn(SEED, index)
    tally.begin(one.kind, f"'{one.text}' {one.radius}")
    for what, judge in DISC_JUDGES.items():
        with tally.answer(what):
            judge(tally, answers, one)


def in_plane(tally: Tally, answers: Answers, index: int) -> None:
    one = inputs_plane.pair(SEED, index)
    tally.begin(one.kind, f"'{one.P}' '{one.Q}' --scale {one.scale}")
    with tally.answer("sum"):
        judge_plane.judge(tally, answers, one)
    judge_moving.judge(tally, answers, one)
    judge_page.judge(tally, answers, one)


def in_space(tally: Tally, answers: Answers, index: int) -> None:
    one = inputs_space.solids(SEED, index)
    tally.begin(one.kind, f"solids({SEED}, {index}) of inputs_space --scale {one.scale}")
    with tally.answer("sum"):
        judge_space.judge(tally, answers, one)


SETTINGS: dict[str, Callable[[Tally, Answers, int], None]] = {
    "disc": with_disc, "plane": in_plane, "space": in_space,
}  # fmt: skip


def kinds(setting: str) -> set[str]:
    """All kinds of cases that a setting may draw."""
    return {
        "disc": inputs_disc.kinds, "plane": inputs_plane.kinds, "space": inputs_space.kinds,
    }[setting]()  # fmt: skip


_INSIDE = tuple(f".{ending} inside as doubles" for ending in ("wkt", "geojson", "poly"))
WRITERS = {
    "disc": (
        ".dxf", ".svg", *_INSIDE, "sum --json", "--measures", "table of sum", "events --json",
        "table of events", "events --kind pair", "index", "sweep --json", "table of sweep",
        "DiscIndex.vertices", "DiscIndex.area_and_length", "minkref.offset", judge_events.PAGE,
    ),
    "plane": (
        ".wkt", ".geojson", ".poly", ".json", ".svg", ".parquet", "sum --json", "table of sum",
        "sweep --json", "table of sweep", "table of events", "convolution .geojson",
        "table of convolution", "ScaleIndex.area", "ScaleIndex.rings", "PolygonSet.arrays",
        judge_page.PAGE, judge_page.PICTURES,
    ),
    "space": (
        ".off", ".obj", ".ply", ".stl", ".off --triangles", ".obj --triangles", ".ply --triangles",
        "sum in space --json", "table of sum in space",
    ),
}  # fmt: skip


def judged(setting: str, indices: range, change: Change | None = None) -> Tally:
    """The judge's tally for a setting's cases; `change` alters answers on the way."""
    use_bits()
    tally = Tally()
    with tempfile.TemporaryDirectory() as folder:
        answers = Answers(Path(folder), change)
        for index in indices:
            SETTINGS[setting](tally, answers, index)
    return tally
