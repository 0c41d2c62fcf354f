"""The claims `interval` and `event`: what moves between two scales, and what changes at one."""

from __future__ import annotations

import copy
import itertools
import json
import random
from pathlib import Path
from typing import Any

import pytest
import squares
from minkref import _core
from minkref.certify.plane.certificate import Certificate
from minkref.fuzz.judges.plane.certified_claims import Confirmation
from minkref.reports.evidence.certificates.certified_cases import events, written
from minkref.reports.evidence.certificates.checkers import ROOT
from minkref.reports.evidence.certificates.mutants import is_changed, mutants
from named_cases import named

SEED = 19
VERIFIED, REFUTED, MALFORMED, OUT_OF_BUDGET = 0, 1, 2, 4
SIGN = {"claim": "sign", "of": ["orientation", [[0, 0], [1, 0], [2, 0]]], "from": "1/2",
        "to": "2", "sign": 1}  # fmt: skip
HOLED = "POLYGON((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 1 3, 3 3, 3 1, 1 1))"
APART = "MULTIPOLYGON(((0 0, 1 0, 1 1, 0 1, 0 0)), ((5 0, 6 0, 6 1, 5 1, 5 0)))"
TOUCHING = "MULTIPOLYGON(((0 0, 2 0, 2 2, 0 2, 0 0)), ((2 2, 4 2, 4 4, 2 4, 2 2)))"
PINCHED = "POLYGON((0 0, 6 0, 6 4, 0 4, 0 0), (1 2, 2 3, 3 2, 2 1, 1 2), (3 2, 4 3, 5 2, 4 1, 3 2))"
RINGED = "POLYGON((0 0, 4 0, 4 4, 0 4, 0 0), (0 2, 2 4, 4 2, 2 0, 0 2))"
TRIANGLE = "POLYGON((-3 -2, 4 -1, 1 3, -3 -2))"
FRAME = "POLYGON((-40 -40, 40 -40, 40 40, -40 40, -40 -40), (0 20, 17 -11, -19 -9, 0 20))"
SCALE = "541/186"  # the hole of FRAME is a point there, and no more after it


def set_of(text: str) -> _core.PolygonSet:
    return _core.read_text(text, "wkt", "a test")


def value_of(certificate: Certificate) -> tuple[Any, Any]:
    """The certificate and its case as values."""
    return json.loads(certificate.text("case.json")), json.loads(certificate.case())


def vanishing(kind: str = "topology") -> Certificate:
    certificate = Certificate(set_of(TRIANGLE), set_of(FRAME))
    certificate.event(SCALE, "5/2", kind=kind, passages=True)
    return certificate


def in_stages() -> dict[str, Any]:
    """No event from 1/2 to 2, by way of 1."""
    value = squares.certificate()
    value["steps"] += [copy.deepcopy(squares.BEFORE), copy.deepcopy(squares.MOVE)]
    value["claims"] = [{**squares.INTERVAL, "from": "1/2", "steps": [3, 2, 4]}]
    return value


def test_an_interval_beside_a_sum_and_a_sign(check_value: Any) -> None:
    value = squares.moving_certificate()
    value["claims"].append(SIGN)
    code, said = check_value(value, squares.CASE)
    assert code == VERIFIED, said
    assert "  interval: from 1 to 2 " in said and squares.INTERVAL["digest"] in said
    assert "of 1 components and 0 holes" in said


def test_an_interval_in_stages(check_value: Any) -> None:
    code, said = check_value(in_stages(), squares.CASE)
    assert code == VERIFIED, said
    assert "interval: from 1/2 to 2 " in said


@pytest.mark.parametrize("limit", ["--tests=80", "--seconds=0"])
def test_limits(check_value: Any, check: Any, tmp_path: Path, limit: str) -> None:
    assert check_value(in_stages(), squares.CASE)[0] == VERIFIED
    assert check(tmp_path / "it.cert.json", limit)[0] == OUT_OF_BUDGET


@pytest.mark.parametrize(
    ("member", "other"),
    [
        ("from", "1/3"),
        ("from", "1"),
        ("from", "0"),
        ("to", "3"),
        ("to", "3/2"),
        ("to", "1/2"),
        ("components", 2),
        ("components", 0),
        ("holes", 1),
        ("holes", -1),
        ("digest", squares.CLAIM["digest"]),
        ("steps", []),
        ("steps", [3]),
        ("steps", [3, 4]),
        ("steps", [3, 2]),
        ("steps", [2, 4]),
        ("steps", [4, 2, 3]),
        ("steps", [3, 2, 3]),
        ("steps", [3, 3, 4]),
        ("steps", [3, 2, 4, 2, 4]),
        ("steps", [0, 2, 4]),
        ("steps", [2]),
    ],
)
def test_false_intervals(check_value: Any, member: str, other: Any) -> None:
    value = in_stages()
    value["claims"][0][member] = other
    assert check_value(value, squares.CASE)[0] in (REFUTED, MALFORMED)


@pytest.mark.parametrize(
    "spoil",
    [
        lambda move: move["scales"].reverse(),
        lambda move: move.__setitem__("scales", ["1", "1"]),
        lambda move: move.__setitem__("scales", ["1"]),
        lambda move: move.__setitem__("scales", ["1", "4"]),
        lambda move: move.__setitem__("box", ["-1", "-1", "5/2", "5/2"]),
        lambda move: move["proofs"].__setitem__(4, ["sep", 0]),
        lambda move: move["proofs"].__setitem__(3, ["cov", 0, 0]),
        lambda move: move.__setitem__("polygons", []),
        lambda move: move["elements"].__setitem__(0, ["P", 0, 1, 2]),
    ],
)
def test_false_moves(check_value: Any, spoil: Any) -> None:
    value = squares.moving_certificate()
    spoil(value["steps"][3])
    assert check_value(value, squares.CASE)[0] in (REFUTED, MALFORMED)


@pytest.mark.parametrize("kind", ["boundary", "topology"])
def test_a_hole_that_vanishes(check: Any, tmp_path: Path, kind: str) -> None:
    code, said = check(written(vanishing(kind), tmp_path, "it"))
    assert code == VERIFIED, said
    assert f"  event: {kind} at {SCALE}, " in said and "from 5/2 to it" in said
    assert f"  passage: at {SCALE}" in said
    assert said.count("  interval: ") == 2 and said.count("  sum: ") == 1


def test_all_events_between_two_scales(check: Any, check_value: Any, tmp_path: Path) -> None:
    certificate = Certificate(set_of(TRIANGLE), set_of(FRAME))
    certificate.events("5/2", "3")
    code, said = check(written(certificate, tmp_path, "it"))
    assert code == VERIFIED, said
    assert (
        f"  events: from 5/2 to 3, without both, all of the boundary: topology at {SCALE}" in said
    )
    value, case = value_of(certificate)
    for name, other in (("scales", ["5/2"]), ("kinds", ["boundary"]), ("holes", [1, 1]),
                        ("components", [1]), ("intervals", [0, 0]), ("events", [1]), ("to", "4"),
                        ("from", "2")):  # fmt: skip
        changed = copy.deepcopy(value)
        changed["claims"][-1][name] = other
        assert check_value(changed, case)[0] in (REFUTED, MALFORMED), name


def test_other_events_are_refused(check_value: Any) -> None:
    """Each claim with another member, and claims that refer to others."""
    certificate = vanishing()
    value, case = value_of(certificate)
    *_, event = (i for i, claim in enumerate(value["claims"]) if claim["claim"] == "event")
    before, at, after = (value["claims"][event][name] for name in ("before", "at", "after"))
    assert check_value(value, case)[0] == VERIFIED
    for member, other in (
        ("before", after), ("after", before), ("before", at), ("at", before), ("at", event),
        ("at", 99), ("scale", "3"), ("scale", "0"), ("kind", "passage"), ("kind", None),
    ):  # fmt: skip
        spoilt = copy.deepcopy(value)
        spoilt["claims"][event][member] = other
        assert check_value(spoilt, case)[0] in (REFUTED, MALFORMED), (member, other)
    spoilt = copy.deepcopy(value)
    claim = spoilt["claims"][event]
    claim["before"], claim["after"] = after, before
    assert check_value(spoilt, case)[0] == REFUTED


def test_no_event_where_nothing_changes(check_value: Any) -> None:
    value = in_stages()
    value["claims"] = [
        {**squares.INTERVAL, "from": "1/2", "to": "1", "steps": [3]},
        squares.CLAIM,
        {**squares.INTERVAL, "steps": [4]},
    ]
    assert check_value(value, squares.CASE)[0] == VERIFIED
    for kind in ("boundary", "topology"):
        event = {"claim": "event", "scale": "1", "kind": kind, "before": 0, "at": 1, "after": 2}
        spoilt = {**value, "claims": [*value["claims"], event]}
        code, said = check_value(spoilt, squares.CASE)
        assert (code, "nothing changes" in said) == (REFUTED, True)


@pytest.mark.parametrize(
    ("P", "Q", "ends"),
    [
        ("POINT(1/3 2)", HOLED, ("1/2", "3")),
        (HOLED, "POINT(1/3 2)", ("1/2", "3")),
        ("LINESTRING(0 0, 1/3 1/2)", HOLED, ("1/2", "1")),
        (HOLED, "LINESTRING(0 0, 0 5)", ("7/2", "4")),
        ("POLYGON EMPTY", HOLED, ("1/2", "3")),
        (HOLED, "POLYGON EMPTY", ("1/2", "3")),
        (TOUCHING, "POINT(1 1)", ("1/2", "3")),
        (TOUCHING, "LINESTRING(0 0, 1 -1)", ("1", "2")),
        (PINCHED, "POINT(0 0)", ("1/2", "3")),
        (RINGED, "POINT(0 1/7)", ("1/2", "3")),
        (APART, HOLED, ("1/10", "1/9")),
    ],
)
def test_thin_and_empty_operands_and_rings_that_touch(
    check: Any, tmp_path: Path, P: str, Q: str, ends: tuple[str, str]
) -> None:
    certificate = Certificate(set_of(P), set_of(Q))
    certificate.interval(*ends)
    path = written(certificate, tmp_path, "it")
    code, said = check(path)
    assert code == VERIFIED, said
    value = json.loads(path.read_text(encoding="utf-8"))
    for member, by in itertools.product(("components", "holes"), (-1, 1)):
        other = copy.deepcopy(value)
        other["claims"][0][member] += by
        path.write_text(json.dumps(other), encoding="utf-8")
        assert check(path)[0] in (REFUTED, MALFORMED), (member, by)


def test_events_of_all_families(check: Any, tmp_path: Path) -> None:
    """And no interval over them: the boundary is another one before, at or after the scale."""
    for case, scale, before in itertools.islice(events(SEED, 1), 24):
        certificate = Certificate(case.P, case.Q)
        certificate.event(scale, before)
        path = written(certificate, tmp_path, "it")
        code, said = check(path)
        assert code == VERIFIED, (case.name.text, scale, said)
        value = json.loads(path.read_text(encoding="utf-8"))
        claims = value["claims"]
        low, at, high = (claims[claims[-1][name]] for name in ("before", "at", "after"))
        steps = [*low["steps"], at["step"], *high["steps"]]
        value["claims"] = [{**low, "to": high["to"], "steps": steps}]
        path.write_text(json.dumps(value), encoding="utf-8")
        boundary = any(claim.get("kind") == "boundary" for claim in claims)
        if boundary or low["digest"] != high["digest"]:
            assert check(path)[0] == REFUTED, (case.name.text, scale)


@pytest.mark.parametrize(
    ("name", "scale", "before"),
    [("passing:77:0", "244/165", "4/3"), ("passing:77:6", "19/17", "1")],
)
def test_corners_that_touch_in_passing(
    check: Any, tmp_path: Path, name: str, scale: str, before: str
) -> None:
    """The moving form is the same before and after; at the scale alone rings touch in a point."""
    case = named(name)
    certificate = Certificate(case.P, case.Q)
    certificate.event(scale, before, kind="boundary")
    path = written(certificate, tmp_path, "it")
    code, said = check(path)
    assert code == VERIFIED, said
    value = json.loads(path.read_text(encoding="utf-8"))
    low, at, high, event = value["claims"]
    assert low["digest"] == high["digest"] and low["holes"] == at["holes"] == high["holes"]
    event["kind"] = "topology"
    path.write_text(json.dumps(value), encoding="utf-8")
    assert check(path)[0] == REFUTED
    steps = [*low["steps"], at["step"], *high["steps"]]
    value["claims"] = [{**low, "to": high["to"], "steps": steps}]
    path.write_text(json.dumps(value), encoding="utf-8")
    assert check(path)[0] == REFUTED


def test_points_that_pass_each_other(check: Any, tmp_path: Path) -> None:
    """Two points of a ring, first the one and then the other farther to the left, and above."""
    case = named("lattice:77:5")
    certificate = Certificate(case.P, case.Q)
    certificate.event("15/7", "2")
    code, said = check(written(certificate, tmp_path, "it"))
    assert code == VERIFIED, said


def test_the_corpus(check: Any) -> None:
    """Returns some certificates for events."""
    files = sorted((ROOT / "degeneracies" / "corpus").glob("*/*.cert.json"))
    with_events = [path for path in files if '"event"' in path.read_text(encoding="utf-8")]
    assert len(with_events) > 300
    for path in random.Random(SEED).sample(with_events, 12):
        code, said = check(path)
        assert code == VERIFIED and "  event: " in said, (path, said)


def test_no_mutant_with_a_changed_claim_is_accepted(check_value: Any) -> None:
    value, case = value_of(vanishing())
    value["claims"] = [claim for claim in value["claims"] if claim["claim"] != "passage"]
    value["claims"][-1]["after"] -= len(vanishing().claims) - len(value["claims"])
    assert check_value(value, case)[0] == VERIFIED
    confirmation = Confirmation(json.dumps(case))
    count = 0
    for mutant in mutants({"claims": value["claims"]}, 2, random.Random(SEED)):
        claims = mutant.value["claims"]
        if not is_changed(claims, value["claims"]):
            continue
        count += 1
        if check_value({**value, "claims": claims}, case)[0] == VERIFIED:
            assert confirmation.all_hold(claims), (SEED, mutant)
    assert count >= 40


def test_mutants_of_steps_never_break_it(check_value: Any) -> None:
    """Mutants that the proved checker verifies, the others verify (see conftest.py): not quite with
    another box, which may touch the sum at an end for what is proved."""
    value = in_stages()
    for mutant in mutants({"steps": value["steps"]}, 2, random.Random(SEED)):
        if ("move" in mutant.field and "box" not in mutant.field) or mutant.path == ("steps",):
            check_value({**value, **mutant.value}, squares.CASE)
