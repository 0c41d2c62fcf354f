"""The proved checker takes what the others take, as far as it has theorems, and nothing false."""

from __future__ import annotations

import copy
import gzip
import json
import random
import subprocess
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
import squares
import touching
from minkref import _core
from minkref.certify.plane.certificate import Certificate
from minkref.fuzz.judges.plane.certified_claims import Confirmation
from minkref.fuzz.plane.families.catalogue import FAMILIES
from minkref.reports.evidence.certificates.certified_cases import written
from minkref.reports.evidence.certificates.mutants import is_changed, mutants
from named_cases import named

SEED = 11
VERIFIED, REFUTED, MALFORMED, OUT_OF_BUDGET, DECLINED = 0, 1, 2, 4, 5
POINT = {"claim": "point", "scale": "1", "point": ["3/2", "1"], "p": ["1", "1/2"],
         "q": ["1/2", "1/2"], "by": [0, 1], "pieces": [0, 0]}  # fmt: skip
SIGN = {"claim": "sign", "of": ["orientation", [[0, 0], [1, 0], [2, 0]]], "from": "1/2",
        "to": "2", "sign": 1}  # fmt: skip
HOLED = "POLYGON((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 1 3, 3 3, 3 1, 1 1))"
THIN = ["POINT(1/3 2)", "LINESTRING(0 0, 1 1)", "LINESTRING(0 0, 0 5)", "POLYGON EMPTY"]


def set_of(text: str) -> _core.PolygonSet:
    return _core.read_text(text, "wkt", "a test")


def test_a_sum_and_a_point(check_value: Any) -> None:
    value = squares.certificate()
    value["claims"][0]["polygons"] = squares.SUM
    value["claims"].append(POINT)
    code, said = check_value(value, squares.CASE)
    assert code == VERIFIED, said
    assert squares.CLAIM["digest"] in said and "(3/2, 1)" in said


@pytest.mark.parametrize("family", FAMILIES)
def test_sums_of_all_families(check: Any, tmp_path: Path, family: str) -> None:
    for index in range(3):
        case = named(f"{family}:{SEED}:{index}")
        if not any(o.is_region or o.is_empty for o in (case.P, case.Q)):
            continue
        certificate = Certificate(case.P, case.Q)
        certificate.sum(case.scale, passages=True)
        code, said = check(written(certificate, tmp_path, "it"))
        assert code == VERIFIED, (case.name.text, said)


@pytest.mark.parametrize("thin", THIN)
@pytest.mark.parametrize("first", [True, False])
def test_points_segments_and_the_empty_set(
    check: Any, tmp_path: Path, thin: str, first: bool
) -> None:
    operands = (set_of(thin), set_of(HOLED))
    certificate = Certificate(*(operands if first else operands[::-1]))
    certificate.sum("3/2")
    code, said = check(written(certificate, tmp_path, "it"))
    assert code == VERIFIED, said


COMB = "POLYGON((0 0, 9 0, 9 3, 8 3, 8 1, 5 1, 5 3, 4 3, 4 1, 1 1, 1 3, 0 3, 0 0))"
APART = "MULTIPOLYGON(((0 0, 1 0, 1 1, 0 1, 0 0)), ((5 0, 6 0, 6 1, 5 1, 5 0)))"
TOUCHING = "MULTIPOLYGON(((0 0, 2 0, 2 2, 0 2, 0 0)), ((2 2, 4 2, 4 4, 2 4, 2 2)))"
ISLAND = (
    "MULTIPOLYGON(((0 0, 9 0, 9 9, 0 9, 0 0), (1 1, 1 8, 8 8, 8 1, 1 1)), "
    "((3 3, 6 3, 6 6, 3 6, 3 3), (4 4, 4 5, 5 5, 5 4, 4 4)))"
)
PINCHED = "POLYGON((0 0, 6 0, 6 4, 0 4, 0 0), (1 2, 2 3, 3 2, 2 1, 1 2), (3 2, 4 3, 5 2, 4 1, 3 2))"
RINGED = "POLYGON((0 0, 4 0, 4 4, 0 4, 0 0), (0 2, 2 4, 4 2, 2 0, 0 2))"


@pytest.mark.parametrize(
    ("P", "Q", "scale", "counts"),
    [
        (APART, HOLED, "1/10", (1, 1)),
        (HOLED, APART, "1/10", (2, 0)),
        (TOUCHING, "POINT(1 1)", "1", (2, 0)),
        (TOUCHING, "LINESTRING(0 0, 1 -1)", "1", (1, 0)),
        (APART, "LINESTRING(0 0, 0 1)", "3", (2, 0)),
        (COMB, APART, "1/3", (2, 0)),
        (TOUCHING, "POLYGON EMPTY", "1", (0, 0)),
        (ISLAND, "POINT(0 0)", "1", (2, 2)),
        (APART, ISLAND, "1/8", (2, 2)),
        (APART, ISLAND, "1/2", (1, 6)),
        (PINCHED, "POINT(0 0)", "1", (1, 2)),
        (PINCHED, "LINESTRING(0 0, 1/3 0)", "2", (1, 2)),
        (RINGED, "POINT(0 0)", "1", (4, 1)),
        (RINGED, HOLED, "1/20", (1, 1)),
    ],
)
def test_components_and_holes(
    check: Any, tmp_path: Path, P: str, Q: str, scale: str, counts: tuple[int, int]
) -> None:
    """A hole pinched at a point is two; one that touches the outer ring bounds components."""
    certificate = Certificate(set_of(P), set_of(Q))
    certificate.sum(scale)
    claim = certificate.claims[0]
    assert (claim["components"], claim["holes"]) == counts
    path = written(certificate, tmp_path, "it")
    code, said = check(path)
    assert code == VERIFIED, said
    assert "in canonical form, of {} components and {} holes".format(*counts) in said
    value = json.loads(path.read_text(encoding="utf-8"))
    for member in ("components", "holes"):
        for by in (-1, 1, 7):
            other = copy.deepcopy(value)
            other["claims"][0][member] += by
            path.write_text(json.dumps(other), encoding="utf-8")
            assert check(path)[0] in (REFUTED, MALFORMED), (member, by)


def test_unions_are_declined(check_value: Any) -> None:
    code, said = check_value(touching.certificate(), touching.CASE)
    assert (code, "no theorem about unions" in said) == (DECLINED, True)


WHOLE = [{**squares.CLAIM, "polygons": squares.SUM}, POINT, SIGN]


def test_no_mutant_with_a_changed_claim_is_accepted(check_value: Any) -> None:
    value = squares.certificate()
    value["claims"][0]["polygons"] = squares.SUM
    value["claims"] += [POINT, SIGN]
    assert not is_changed(value["claims"], WHOLE)
    count = 0
    confirmation = Confirmation(json.dumps(squares.CASE))
    for mutant in mutants(value, 3, random.Random(SEED)):
        if mutant.path[0] != "claims" or not is_changed(mutant.value["claims"], WHOLE):
            continue
        count += 1
        if check_value(mutant.value, squares.CASE)[0] == VERIFIED:
            # A sign that is one between other scales or of other points too
            others = [claim for claim in mutant.value["claims"] if claim not in value["claims"]]
            assert [claim["claim"] for claim in others] == ["sign"], (SEED, mutant)
            assert confirmation.all_hold(others), (SEED, mutant)
    assert count >= 60


@pytest.mark.parametrize("by", ["1", "-1", "1/1000"])
def test_a_result_that_is_moved_is_refuted(check_value: Any, by: str) -> None:
    """Though the digest is that of what is claimed: the steps cannot prove it."""
    value = squares.certificate()
    step = value["steps"][2]
    claim = value["claims"][0]
    moved = copy.deepcopy(squares.SUM)
    moved[0]["outer"][2][0] = str(Fraction(2) + Fraction(by))
    claim["polygons"], claim["digest"] = moved, squares.digest_of_polygons(moved)
    assert check_value(value, squares.CASE)[0] == REFUTED
    # And with a ring of the step that is the one claimed: corner 10 is elsewhere.
    step["elements"].append(["meet", 5, 3])
    step["polygons"] = [[[8, 9, 8 + len(step["elements"]) - 5, 11]]]
    spoilt = [["0", "0"], ["2", "0"], ["2", "3"], ["0", "2"]]
    claim["polygons"] = [{"holes": [], "outer": spoilt}]
    claim["digest"] = squares.digest_of_polygons(claim["polygons"])
    assert check_value(value, squares.CASE)[0] == REFUTED


@pytest.mark.parametrize(
    ("spoil", "code"),
    [
        (lambda c: c["steps"][2]["proofs"].__setitem__(1, ["cov", 0, 0]), REFUTED),
        (lambda c: c["steps"][2]["proofs"].__setitem__(0, ["sep", 0]), REFUTED),
        (lambda c: c["steps"][2]["proofs"].__setitem__(1, ["sep"]), REFUTED),
        (lambda c: c["steps"][2]["cells"].pop(), MALFORMED),
        (lambda c: c["steps"][0].__setitem__("pieces", [[0, 1, 2]]), REFUTED),
        (lambda c: c["steps"][2].__setitem__("box", ["0", "0", "1", "1"]), REFUTED),
        (lambda c: c["claims"][0].__setitem__("components", 2), REFUTED),
        (lambda c: c["claims"][0].__setitem__("components", 0), REFUTED),
        (lambda c: c["claims"][0].__setitem__("holes", 1), REFUTED),
        (lambda c: c["claims"][0].__setitem__("holes", -1), REFUTED),
        (lambda c: c["steps"][2].__setitem__("box", ["0", "0", "2", "2"]), REFUTED),
        (lambda c: c["steps"][2].__setitem__("polygons", []), REFUTED),
        (lambda c: c["claims"][0].__setitem__("claim", "total"), MALFORMED),
        (lambda c: c["claims"][0].pop("digest"), MALFORMED),
        (lambda c: c.__setitem__("claims", []), MALFORMED),
        (lambda c: c["claims"].append(c["claims"][0]), MALFORMED),
        (lambda c: c["steps"].append(c["steps"][0]), MALFORMED),
        (lambda c: c.__setitem__("certificate", "solid-certificate-v1"), DECLINED),
    ],
)
def test_false_certificates(check_value: Any, spoil: Any, code: int) -> None:
    value = squares.certificate()
    spoil(value)
    assert check_value(value, squares.CASE)[0] == code


def test_a_tree_that_would_be_too_large_is_declined(check_value: Any) -> None:
    """Groups of the two before: as many leaves as Fibonacci's 200th number. (The other checkers do
    not open them.)"""
    value = squares.certificate()
    step = value["steps"][0]
    step["pieces"] = [[0, 1, 2], [0, 2, 3]]
    step["groups"] = [[n, n + 1] for n in range(200)]
    assert check_value(value, squares.CASE)[0] == DECLINED


def test_another_case(check_value: Any) -> None:
    case = copy.deepcopy(squares.CASE)
    case["Q"]["polygons"][0]["outer"][2] = ["2", "1"]
    assert check_value(squares.certificate(), case)[0] == REFUTED
    value = squares.certificate()
    value["case"]["sha256"] = squares.digest_of_case(case)
    assert check_value(value, case)[0] == REFUTED


def test_what_is_compressed_is_refused(check_value: Any, check: Any, tmp_path: Path) -> None:
    assert check_value(squares.certificate(), squares.CASE)[0] == VERIFIED
    file = tmp_path / "it.cert.json"
    file.write_bytes(gzip.compress(file.read_bytes()))
    code, said = check(file)
    assert code == MALFORMED
    assert "gzip -dc FILE | minkref-check-proved -, or minkref check FILE" in said
    assert check(file, "--bytes", "20")[0] == OUT_OF_BUDGET


def test_standard_input(check_value: Any, proved: list[str], tmp_path: Path) -> None:
    assert check_value(squares.certificate(), squares.CASE)[0] == VERIFIED
    text = (tmp_path / "it.cert.json").read_bytes()
    for given, options, code in (
        (text, [], VERIFIED),
        (text, ["--bytes", str(len(text) - 1)], OUT_OF_BUDGET),
        (text[:-1], [], MALFORMED),
        (gzip.compress(text), [], MALFORMED),
    ):
        command = [*proved, *options, "-"]
        ran = subprocess.run(command, cwd=tmp_path, input=given, capture_output=True)
        assert (ran.returncode, ran.stderr) == (code, b""), ran.stdout


@pytest.mark.parametrize(
    ("options", "code"),
    [
        (["--case", "nowhere.json"], MALFORMED),
        (["--seconds", "0"], OUT_OF_BUDGET),
        (["--tests", "10"], OUT_OF_BUDGET),
        (["--bytes", "100"], OUT_OF_BUDGET),
    ],
)
def test_limits_and_missing_files(
    check_value: Any, check: Any, tmp_path: Path, options: list[str], code: int
) -> None:
    assert check_value(squares.certificate(), squares.CASE)[0] == VERIFIED
    assert check(tmp_path / "it.cert.json", *options)[0] == code
    assert check(tmp_path / "nowhere.cert.json")[0] == MALFORMED


@pytest.mark.parametrize(
    "text",
    ["", "{", "[]", "7", '{"certificate": 1}', '{"a": 1, "a": 2}', "[" * 100_000, '"\ud800"',
     "NaN", '{"certificate": "certificate-v1"} x', "\ufeff{}", '"\\ud83d"'],
)  # fmt: skip
def test_what_is_no_certificate_is_malformed(check: Any, tmp_path: Path, text: str) -> None:
    (tmp_path / "it.cert.json").write_bytes(text.encode("utf-8", "surrogatepass"))
    assert check(tmp_path / "it.cert.json")[0] == MALFORMED
