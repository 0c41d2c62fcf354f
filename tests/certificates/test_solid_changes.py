"""Certificates of sums of solids with small changes, each before both checkers, which agree; what
they still verify is true by the slow engine."""

from __future__ import annotations

from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
import solid_pairs
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.judges.space.certified_solids import SolidConfirmation
from minkref.fuzz.space.cells import surface_of
from replacing import sample, verdicts_on
from test_convex_changes import changes

MOST = 700
PAIRS: dict[str, tuple[Polyhedron, Polyhedron, solid_pairs.Scaling]] = {
    "L and cube": (solid_pairs.L, solid_pairs.brick(1, 1, 1), solid_pairs.UNEQUAL),
    "two cells and a tetrahedron": (
        surface_of({(0, 0, 0), (2, 0, 0)}), solid_pairs.tetrahedron(), ("1/3", "1/2", "1"),
    ),
}  # fmt: skip


@pytest.mark.parametrize("name", PAIRS)
def test_every_change_is_refused_or_true(tmp_path: Path, name: str) -> None:
    P, Q, scaling = PAIRS[name]
    certificate, case = solid_pairs.values(P, Q, [scaling])
    certificate = {name: certificate[name] for name in ("certificate", "case", "proof", "claims")}
    given = sample(changes(certificate, case), MOST)
    codes = verdicts_on(tmp_path, [(certificate, case), *given])
    assert codes[0] == 0 and SolidConfirmation(case).all_hold(certificate["claims"])
    held = [one for one, code in zip(given, codes[1:], strict=True) if code == 0]
    different = {repr((one["claims"], of)): (one, of) for one, of in held}
    assert all(SolidConfirmation(of).all_hold(one["claims"]) for one, of in different.values())
    assert all(same_claims(one, certificate) for one, _ in held)
    assert len(held) < len(given) / 10
    by_code = {code: codes.count(code) for code in (0, 1, 2)}
    assert min(by_code[1], by_code[2]) > len(given) / 7, by_code


def same_claims(one: Any, other: Any) -> bool:
    return [numbers(claim) for claim in one["claims"]] == [
        numbers(claim) for claim in other["claims"]
    ]


def numbers(claim: Any) -> Any:
    scaling = [Fraction(factor) for factor in claim["scaling"]]
    return {**claim, "scaling": scaling, "volume": Fraction(claim["volume"])}
