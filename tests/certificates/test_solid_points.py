"""Certificates for points of sums of solids: both checkers verify them; a judge in fractions
confirms them; what breaks a rule is refused."""

from __future__ import annotations

import copy
import json
import random
from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
import solid_pairs
from minkref.certify.plane.certificate import NoProof
from minkref.certify.space.solid_point_certificate import SolidPointCertificate
from minkref.errors import Refusal
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.judges.witness_certificate import is_true
from minkref.fuzz.space.cells import surface_of
from minkref.fuzz.space.witness import holds
from minkref.fuzz.verdicts.verdict import Witness
from replacing import sample, verdicts_on
from test_convex_changes import changes
from thoroughness import draws

SEED = 88
Value = Any
Pair = tuple[Polyhedron, Polyhedron]


def made_of(P: Polyhedron, Q: Polyhedron) -> SolidPointCertificate:
    return SolidPointCertificate(solid_pairs.given(P), solid_pairs.given(Q))


def values_of(certificate: SolidPointCertificate) -> tuple[Value, Value]:
    return json.loads(certificate.text("case.json")), json.loads(certificate.case())


def somewhere(P: Polyhedron, Q: Polyhedron, scaling: Any, dice: random.Random) -> Any:
    """Often beside the boundary: a sum of two vertices, moved a little, or not."""
    p, q = dice.choice(P.vertices), dice.choice(Q.vertices)
    by = [dice.choice((0, 0, 1, -1)) * dice.choice((Fraction(1, 2**30), Fraction(1, 3), 2))
          for _ in range(3)]  # fmt: skip
    return tuple(str(Fraction(s) * a + b + c) for s, a, b, c in zip(scaling, p, q, by, strict=True))


def is_outside(P: Polyhedron, Q: Polyhedron, claim: Value) -> bool:
    scaling = tuple(map(Fraction, claim["scaling"]))
    return holds(P, Q, (scaling[0], scaling[1], scaling[2]), Witness(tuple(claim["point"]), False))


@pytest.mark.parametrize("name", solid_pairs.PAIRS)
def test_points_in_the_sum_and_points_that_are_not(check_value: Any, name: str) -> None:
    P, Q, scalings = solid_pairs.PAIRS[name]
    dice, certificate = random.Random(f"{SEED} {name}"), made_of(P, Q)
    for _ in range(draws(4, 40)):
        point = somewhere(P, Q, scalings[-1], dice)
        try:
            certificate.outside(scalings[-1], point)
        except NoProof:
            certificate.point(scalings[-1], point)
    different = {json.dumps(claim): claim for claim in certificate.claims}
    certificate.claims = list(different.values())
    code, said = check_value(*values_of(certificate))
    assert code == 0, (SEED, said)
    for claim in certificate.claims:
        assert is_outside(P, Q, claim) == (claim["claim"] == "outside"), (SEED, claim)


def test_a_false_claim_has_no_proof() -> None:
    certificate = made_of(solid_pairs.L, solid_pairs.brick(1, 1, 1))
    with pytest.raises(NoProof, match="is in the sum"):
        certificate.outside(solid_pairs.ONE, ("1", "1", "1"))
    with pytest.raises(NoProof, match="is not in the sum"):
        certificate.point(solid_pairs.ONE, ("5", "1", "1"))
    assert not certificate.claims and "claims none" in repr(certificate)


def test_the_closed_sum_has_its_boundary_and_no_point_beside_it(check_value: Any) -> None:
    """Also the single point of a cavity that a cube just fills."""
    hollow, cube = surface_of(solid_pairs.HOLLOW), solid_pairs.brick(1, 1, 1)
    centre = ("2", "2", "2")
    certificate = made_of(hollow, cube)
    certificate.point(solid_pairs.ONE, centre)
    certificate.point(solid_pairs.ONE, ("0", "0", "0"))
    certificate.outside(solid_pairs.ONE, ("-1/1000000000000000000000", "0", "0"))
    certificate.outside(("1000001/1000000",) * 3, ("4000003/2000000",) * 3)
    assert check_value(*values_of(certificate))[0] == 0


CERTIFICATE = made_of(solid_pairs.L, solid_pairs.brick(1, 1, 1))
CERTIFICATE.outside(solid_pairs.ONE, ("5/2", "5/2", "1"))
CERTIFICATE.point(solid_pairs.ONE, ("1", "2", "1"))


def set_(number: int, **members: Any) -> Callable[[Value], None]:
    return lambda value: value["claims"][number].update(members)


def drop(number: int, name: str) -> Callable[[Value], None]:
    return lambda value: value["claims"][number].pop(name)


FAULTS: dict[str, tuple[Callable[[Value], None], int, str]] = {
    "a point in the sum": (set_(0, point=["2", "2", "1"]), 1, "apart"),
    "a point on the boundary": (set_(0, point=["2", "3", "1"]), 1, "apart"),
    "another scaling": (set_(0, scaling=["2", "2", "2"]), 1, "apart"),
    "a factor that is 0": (set_(0, scaling=["0", "1", "1"]), 2, "not positive"),
    "a normal of 0": (set_(0, normals=[[0, 0, 0]], code=[0, 0]), 2, "a normal is"),
    "a normal that is no vector": (set_(0, normals=[[1, 0]]), 2, "has not 3 entries"),
    "a normal of fractions": (set_(0, normals=[["1/2", 0, 0]], code=[0, 0]), 2, "no integer"),
    "a normal without use": (lambda v: v["claims"][0]["normals"].append([7, 7, 7]), 2, "not used"),
    "a code too short": (lambda v: v["claims"][0]["code"].pop(), 2, "has not 2 entries"),
    "a code too long": (lambda v: v["claims"][0]["code"].append(0), 2, "has not 2 entries"),
    "a normal of nowhere": (set_(0, code=[0, 9]), 2, "is no number here"),
    "no proof": (drop(0, "code"), 2, "a member is missing"),
    "s p + q is elsewhere": (set_(1, point=["1", "2", "1/2"]), 1, "is another point"),
    "p outside of its piece": (
        set_(1, point=["4", "2", "1"], p=["4", "2", "1"], q=["0", "0", "0"]), 1, "not in",
    ),
    "another piece": (lambda v: v["claims"][1]["pieces"].reverse(), 0, ""),
    "a piece of nowhere": (set_(1, pieces=[2, 0]), 2, "before this"),
    "a claim of another form": (set_(1, claim="sum"), 2, "no"),
    "a claim twice": (lambda v: v["claims"].append(v["claims"][0]), 2, "twice"),
    "no claim": (lambda v: v["claims"].clear(), 2, ""),
    "a member more": (set_(0, sum=0), 2, "more members"),
    "pieces that do not tile": (
        lambda v: v["proof"]["P"]["hulls"].pop(), 1, "do not tile it",
    ),
    "sums beside": (lambda v: v["proof"].update(sums=[]), 2, "more members"),
    "the form of sums": (lambda v: v.update(certificate="solid-certificate-v1"), 2, "missing"),
}  # fmt: skip


@pytest.mark.parametrize("spoil, code, why", FAULTS.values(), ids=FAULTS)
def test_what_breaks_a_rule_is_refused(
    check_value: Any, spoil: Callable[[Value], None], code: int, why: str
) -> None:
    value, case = copy.deepcopy(values_of(CERTIFICATE))
    spoil(value)
    got, said = check_value(value, case)
    assert got == code and why in said, said


def test_every_change_is_refused_or_true(tmp_path: Path) -> None:
    """Both checkers agree; a judge without proofs confirms what they accept."""
    value, case = values_of(CERTIFICATE)
    value = {name: value[name] for name in ("certificate", "case", "proof", "claims")}
    given = sample(changes(value, case), 700)
    codes = verdicts_on(tmp_path, [(value, case), *given])
    assert codes[0] == 0
    held = [one for one, code in zip(given, codes[1:], strict=True) if code == 0]
    assert 0 < len(held) < len(given) / 4
    for certificate, of in held:
        assert all(is_true(of, claim) for claim in certificate["claims"]), (certificate, of)


def test_another_case_is_refused(check_value: Any) -> None:
    value, case = copy.deepcopy(values_of(CERTIFICATE))
    case["Q"]["vertices"] = [[str(2 * Fraction(c)) for c in v] for v in case["Q"]["vertices"]]
    assert check_value(value, case)[0] == 1


def test_too_many_pieces_are_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("minkref.certify.space.tiled_solids.MOST_PAIRS", 1)
    with pytest.raises(Refusal, match="2 pairs of convex pieces"):
        made_of(solid_pairs.L, solid_pairs.brick(1, 1, 1))
