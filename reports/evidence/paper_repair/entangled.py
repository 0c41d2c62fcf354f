"""Theorem 1, first half, where it might fail: tetrahedra made around a pair of entangled normals
(docs/audit/section-6.md). Where no facet has an error, edge pairs change as an odd sum of four
entangled pairs says; whether one ever is odd is searched."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass

import numpy as np
from minkref.reports.audit.bodies import Body, Whole, hull
from minkref.reports.audit.chapters.section_6.entangled import changed, keeps, sums, table
from minkref.reports.evidence.framework.in_processes import in_processes
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size

MINUTES = Minutes(0.1, 0.7, 6)

SEED = 61
BLOCK = 100_000  # pairs that doubles look at; some 30 of them keep all facets
BLOCKS = Counts(1, 24, 240)
DIGITS = 10**7  # coordinates are rounded to integers up to this
Array = np.ndarray[tuple[int, ...], np.dtype[np.float64]]
Numbers = np.ndarray[tuple[int, ...], np.dtype[np.intp]]


@dataclass(frozen=True)
class Task:
    number: int


def study(task: Task) -> Counter[str]:
    """Exact counts for the pairs that doubles propose."""
    counts: Counter[str] = Counter()
    for P, Q, s in _proposed(np.random.default_rng([SEED, task.number])):
        if not keeps(P, Q, s):
            continue
        entangled = table(P, Q, s)
        odd = [k % 2 == 1 for k in sums(P, Q, entangled)]
        moved = changed(P, Q, s)
        counts["kept"] += 1
        counts["entangled"] += any(map(any, entangled))
        counts["odd"] += any(odd)
        counts["changed"] += any(moved)
        counts["not as the four say"] += odd != moved
    return counts


def run(findings: Findings, size: Size) -> None:
    total: Counter[str] = Counter()
    blocks = size.of(BLOCKS)
    for counts in in_processes(study, [Task(number) for number in range(blocks)]):
        total.update(counts)
    met = total["entangled"]
    findings.law("pairs with all facets kept and entangled normals", met > 0, "some", met)
    findings.none("edge pairs that do not change as the four say", total["not as the four say"])
    findings.note(
        f"of {blocks * BLOCK:,} pairs of tetrahedra around two entangled normals {total['kept']:,} "
        f"keep all facets, {total['entangled']:,} of them with entangled normals; {total['odd']:,} "
        f"have an odd sum of four, and in {total['changed']:,} a pair of edges changes: "
        "counterexamples to Theorem 1, first half"
    )
    findings.figures = {"entangled": dict(total)}


def _proposed(dice: np.random.Generator) -> Iterator[tuple[Body, Body, Whole]]:
    """Tetrahedra whose vertex opposite to the facet n of P has m and S m of Q in its cell, and the
    other way round, where n = D m for a D between I and S: by doubles, those that keep all."""
    spread = dice.choice([0.3, 1, 2, 4], size=(BLOCK, 1))
    s = np.exp(dice.normal(size=(BLOCK, 3)) * spread)
    power, way = dice.uniform(-1, 1, size=(BLOCK, 1)), dice.uniform(size=(BLOCK, 1))
    between = ((1 - way) + way * s**power) ** (1 / power)
    m = dice.normal(size=(BLOCK, 3))
    n = between * m
    with np.errstate(all="ignore"):
        P, Q = (
            _corners(dice, s, between) / m[:, None],
            _corners(dice, 1 / s, 1 / between) / n[:, None],
        )
        of_P, of_Q = _normals(P), _normals(Q)
        stays = _tops(of_P, Q) == _tops(of_P / s[:, None], Q)
        stays &= _tops(of_Q, P) == _tops(of_Q * s[:, None], P)
    for i in np.nonzero(stays.all(axis=1))[0]:
        # A stretch along the axes of P and Q alike changes nothing.
        stretch = 1 / np.abs(P[i]).max(axis=0)
        try:
            yield _body(P[i] * stretch), _body(Q[i] * stretch), _whole(s[i] / s[i].max())
        except ValueError:  # rounding has made it flat
            continue


def _corners(dice: np.random.Generator, s: Array, between: Array) -> Array:
    """The origin and three points a with sums -1 by `between`, and not below 0 by 1 and by s."""
    rows = np.stack([np.ones_like(s), s, between], axis=1)
    bad = np.abs(np.linalg.det(rows)) < 1e-12
    rows[bad] = np.eye(3)
    heights = np.concatenate(
        [np.exp(3 * dice.normal(size=(len(s), 3, 2))), -np.ones((len(s), 3, 1))], axis=2
    )
    points = np.einsum("kab,kjb->kja", np.linalg.inv(rows), heights)
    points[bad] = np.nan
    return np.concatenate([np.zeros((len(s), 1, 3)), -points], axis=1)


def _normals(corners: Array) -> Array:
    """Outward, each opposite to a corner."""
    found = []
    for i in range(4):
        a, b, c = (corners[:, k] for k in range(4) if k != i)
        normal = np.cross(b - a, c - a)
        side = np.sign(np.einsum("kj,kj->k", normal, corners[:, i] - a))
        found.append(-normal * side[:, None])
    return np.stack(found, axis=1)


def _tops(normals: Array, corners: Array) -> Numbers:
    tops: Numbers = np.einsum("kij,klj->kil", normals, corners).argmax(axis=2)
    return tops


def _whole(numbers: Array) -> Whole:
    x, y, z = (max(round(DIGITS * number), 1) for number in numbers)
    return x, y, z


def _body(corners: Array) -> Body:
    most = np.abs(corners).max()
    return hull([(int(x), int(y), int(z)) for x, y, z in np.rint(corners / most * DIGITS)])
