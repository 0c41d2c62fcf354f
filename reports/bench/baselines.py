"""Baselines of the dynamic update: the same found afresh at each scale."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from minkref import _core
from minkref.fuzz.cgal.oracle import CgalOracle
from minkref.reports.bench.pairs import Pair

PAIRWISE, CONTACTS, STATIC, CGAL = "pairwise", "contacts", "static", "cgal-reduced"
INTERSECTIONS, SUM = "intersections", "sum"
ABOUT = {
    PAIRWISE: "all pairs of convolution edges in plain doubles, boxes first (the paper's: in MPFR)",
    CONTACTS: "our exact static search for intersections, by a tree of boxes",
    STATIC: "our static sum, route paper",
    CGAL: "CGAL's reduced convolution",
}


class NoTimeError(Exception):
    """The baseline gave no answer at a scale."""


@dataclass(frozen=True)
class Baseline:
    name: str
    measure: str  # what it finds: INTERSECTIONS or SUM
    seconds: Callable[[str], float]  # at a scale; raises NoTimeError


def baselines(pair: Pair, oracle: CgalOracle | None) -> list[Baseline]:
    """A pair's baselines; without an oracle, CGAL's baseline drops out."""
    P, Q = pair.P.set, pair.Q.set
    pairwise, contacts = _core.PairwiseSearch(P, Q), _core.ContactSearch(P, Q)
    found = [
        Baseline(PAIRWISE, INTERSECTIONS, lambda scale: pairwise.run(scale)[1]),
        Baseline(CONTACTS, INTERSECTIONS, lambda scale: contacts.run(scale)[1]),
        Baseline(STATIC, SUM, lambda scale: _core.minkowski_sum(P, Q, scale).seconds),
    ]
    if oracle is not None:
        found.append(Baseline(CGAL, SUM, lambda scale: by_cgal(oracle, pair, scale)))
    return found


def by_cgal(oracle: CgalOracle, pair: Pair, scale: str) -> float:
    """Seconds of the call alone, from parsed operands."""
    answer = oracle.sum(pair.P.set.scaled(scale).to_json(), pair.Q.set.to_json())
    if answer.status != "result" or answer.seconds is None:
        raise NoTimeError(f"{answer.status}: {answer.reason}")
    return answer.seconds
