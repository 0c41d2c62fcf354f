"""Indices of changed operands, of every family, equal new ones after any number of changes."""

from __future__ import annotations

import random
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.exact import digest
from minkref.fuzz.plane.families.catalogue import FAMILIES
from minkref.fuzz.plane.families.mutation import mutate
from minkref.reports.evidence.framework.in_processes import in_processes
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

MINUTES = Minutes(None, 1, 10)

SEED = 310
PAIRS, CHANGES = Counts(0, 4, 100), 6
Task = tuple[str, int]


def everything(index: _core.ScaleIndex) -> list[Any]:
    """All columns but counts of work, as texts and numbers."""
    states: list[Any] = []
    index.ring_states(states.append)
    return [
        index.edges(),
        index.tracks(),
        index.event_scales(),
        index.boundary_events(),
        index.topology_events(),
        *(index.features(kind) for kind in ("hole", "component")),
        states,
        index.counts()["corners"],
        index.counts()["bytes"],
    ]


def same_as_new(task: Task) -> tuple[str, int, int, str]:
    """The task's name, edges reused and rebuilt, and the first difference or exception."""
    family, number = task
    name, reused, rebuilt = f"{family} {number}", 0, 0
    pair = FAMILIES[family].pair(SEED, number)
    dice = random.Random(f"{SEED} {name}")
    texts, scale = (pair.P, pair.Q), pair.scale
    window = (str(Fraction(scale) / 2), str(Fraction(scale) * 2))
    read = _core.PolygonSet.from_json
    try:
        index = _core.ScaleIndex(read(texts[0]), read(texts[1]), *window)
        for change in range(CHANGES):
            texts = mutate(dice, *texts, scale)[:2]
            P, Q = map(read, texts)
            index = index.updated(P, Q, threads=1 + change % 2)
            if everything(index) != everything(_core.ScaleIndex(P, Q, *window)):
                return name, reused, rebuilt, f"change {change}: {texts}"
            reused += index.reuse()["reused"]
            rebuilt += index.reuse()["rebuilt"]
            found, expected = index.sum(scale).region, _core.minkowski_sum(P, Q, scale).region
            if digest(found.canonical_json()) != digest(expected.canonical_json()):
                return name, reused, rebuilt, f"change {change}: another sum at {scale}"
    except Exception as error:  # noqa: BLE001 a fault too
        return name, reused, rebuilt, f"{type(error).__name__}: {error}"
    return name, reused, rebuilt, ""


def run(findings: Findings, size: Size) -> None:
    tasks = [(family, number) for family in FAMILIES for number in range(size.of(PAIRS))]
    kept, anew, wrong = 0, 0, []
    for name, reused, rebuilt, fault in in_processes(same_as_new, tasks, each=100, what="updates"):
        kept, anew = kept + reused, anew + rebuilt
        if fault:
            wrong.append(f"{name}: {fault}")
    findings.none("updated indices other than new ones", wrong)
    findings.figures["updates"] = (
        f"{len(tasks) * CHANGES:,} of {len(tasks):,} pairs of {len(FAMILIES)} families; "
        f"{kept:,} convolution edges reused, {anew:,} rebuilt"
    )
    findings.target("updates that reuse edges", kept > 0, 1, kept)
    findings.note(f"seed {SEED}; a vertex, a hole or more changed at a time")
