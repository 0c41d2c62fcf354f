"""Paths and traps: whatever is changed in a certificate or its case, both checkers give one
verdict, and what they still verify is true by the reference at all scales."""

from __future__ import annotations

import copy
import json
from collections.abc import Iterator
from fractions import Fraction
from functools import cache
from pathlib import Path
from typing import Any

import minkref
import pytest
import walls
from minkref.certify.motion.path_certificate import PathCertificate
from minkref.fuzz.judges.motion.certified_paths import PathConfirmation
from replacing import Change, Value, changed, replaced, sample, verdicts_on


def set_of(value: Value) -> Any:
    return minkref.read_text(json.dumps(value), "json")


def made(case: Value, contact: str) -> Change:
    """By the producer."""
    sets = set_of(case["R"]), set_of(case["O"])
    certificate = PathCertificate(*sets, case["path"])
    if len(case["path"]) == 1:
        certificate.trap(contact)
    else:
        certificate.valid(contact)
    return json.loads(certificate.text("case.json")), json.loads(certificate.case())


#: Around the end of a wall and between two others, twice over the same place.
BENT: Value = {
    "R": walls.polygons(walls.box(-1, -1, 1, 1)),
    "O": walls.polygons(walls.box(2, 0, 3, 9), walls.box(5, -3, 6, 6)),
    "path": [["0", "3"], ["5/2", "-2"], ["4", "2"], ["4", "2"]],
}
GIVEN: dict[str, Change] = {
    "by hand, a path": (walls.certificate(), walls.CASE),
    "by hand, a trap": (walls.room(), walls.ROOM_CASE),
    "a path": made(BENT, "allowed"),
    "a path, contact forbidden": made(BENT, "forbidden"),
    "a trap, contact forbidden": made(walls.ROOM_CASE, "forbidden"),
}


def changes(certificate: Value, case: Value) -> Iterator[Change]:
    """Changes the certificate, and the case with its old digest and with its new one."""
    for value in changed(certificate):
        yield value, case
    for value in changed(case):
        yield certificate, value
        try:
            digest = walls.digest_of_case(value)
        except (KeyError, TypeError, ValueError, AttributeError):
            continue
        yield replaced(certificate, ("case", "sha256"), digest), value


def is_true(certificate: Value, case: Value) -> bool:
    """A certificate is about the points that are wound around, and a vertex that is there twice
    does not matter to it."""
    plain = {**case, **{name: {"polygons": list(map(simple, case[name]["polygons"]))}
                        for name in "RO"}}  # fmt: skip
    return confirmation(json.dumps(plain)).all_hold(certificate["claims"])


@cache
def confirmation(case: str) -> PathConfirmation:
    """Many changes leave the case as it is."""
    return PathConfirmation(case)


def simple(polygon: Value) -> Value:
    """Its outer ring without a vertex twice in a row."""
    ring = polygon["outer"]
    return {"outer": [p for k, p in enumerate(ring) if p != ring[k - 1]]}


@pytest.mark.parametrize("name", GIVEN)
def test_every_change_is_refused_or_true(tmp_path: Path, name: str) -> None:
    certificate, case = GIVEN[name]
    given = sample(changes(certificate, case))
    codes = verdicts_on(tmp_path, [(certificate, case), *given])
    assert codes[0] == 0
    assert is_true(certificate, case)
    held = [one for one, code in zip(given, codes[1:], strict=True) if code == 0]
    for one in held:
        assert is_true(*one), one
    kinds = {claim["claim"] for claim in certificate["claims"]}
    changed_claims = [one for one in held if one[0]["claims"] != certificate["claims"]]
    assert len(kinds) >= 3 and len(changed_claims) < len(given) / 10
    assert len(held) < len(given) / 3


@pytest.mark.parametrize("name", GIVEN)
def test_no_scale_of_a_claim_may_be_another(tmp_path: Path, name: str) -> None:
    """The scales of a claim, with those of its step, told wider by a little or a lot, or with an
    end that it has not: refused, unless it is true."""
    certificate, case = GIVEN[name]
    confirmation = PathConfirmation(json.dumps(case))
    given, false = [], 0
    for number, claim in enumerate(certificate["claims"]):
        for scales in wider(claim["scales"]):
            value = copy.deepcopy(certificate)
            told = value["claims"][number]
            told["scales"] = scales
            if "step" in claim:
                value["steps"][claim["step"]]["scales"] = scales
            if "claims" in claim:
                continue  # the claims that it refers to have other scales
            false += not confirmation.holds(told)
            value["claims"] = [told]
            used = [0, 1, *([claim["step"]] if "step" in claim else [])]
            value["steps"] = [value["steps"][k] for k in used]
            if "step" in claim:
                told["step"] = 2
            given.append((value, case, told))
    codes = verdicts_on(tmp_path, [(value, where) for value, where, _ in given])
    assert false >= 5
    for (_, _, told), code in zip(given, codes, strict=True):
        assert code != 0 or confirmation.holds(told), told


def wider(scales: Value) -> Iterator[Value]:
    near = Fraction(1, 1 << 40)
    if scales["from"] != "0":
        yield {**scales, "from_in": True}
        yield {**scales, "from": "0", "from_in": False}
        yield {**scales, "from": str(Fraction(scales["from"]) * (1 - near))}
    if scales["to"] is not None:
        yield {**scales, "to_in": True}
        yield {**scales, "to": None, "to_in": False}
        yield {**scales, "to": str(Fraction(scales["to"]) * (1 + near))}
