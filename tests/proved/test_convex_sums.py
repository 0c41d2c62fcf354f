"""Sums of convex polyhedra: proved as sets of points, in canonical form; nothing false is."""

from __future__ import annotations

import json
import random
from pathlib import Path
from typing import Any

import cubes
import pytest
from minkref.reports.evidence.certificates.mutants import mutants
from test_convex_producer import certified, random_body, triangulated, written

VERIFIED, REFUTED, MALFORMED, OUT_OF_BUDGET = 0, 1, 2, 4
SEED = 5
SCALINGS: list[Any] = [(1, 1, 1), ("1/2", 3, "7/5"), (1000, "1/1000", 1)]


def test_two_cubes(check_value: Any) -> None:
    code, said = check_value(cubes.certificate(), cubes.CASE)
    assert code == VERIFIED, said
    assert f"{cubes.CLAIM['digest']}, of 6 facets, volume 8" in said


@pytest.mark.parametrize("index", range(6))
def test_random_bodies(check: Any, tmp_path: Path, index: int) -> None:
    dice = random.Random(f"{SEED}:{index}")
    print(f"seed {SEED}:{index}")
    P, Q = random_body(dice), triangulated(random_body(dice), dice)
    scalings = [cubes.whole_scaling(*s) for s in SCALINGS]
    for first, second in ((P, Q), (Q, P)):
        code, said = check(written(certified(first, second, scalings), tmp_path))
        assert code == VERIFIED, said
        assert said.count("  sum: at (") == len(SCALINGS)


A, B, C, D, E, F = cubes.RINGS


def of_claim(member: str, value: Any) -> Any:
    return lambda c: c["claims"][0].__setitem__(member, value)


def rings(*found: list[int]) -> Any:
    """Other facets, each with the parents of its plane."""

    def spoil(value: Any) -> None:
        parents = {tuple(ring): sorted(ring) for ring in cubes.RINGS}
        value["sums"][0]["facets"] = [
            [ring, *(2 * [parents.get(tuple(ring), sorted(ring))])] for ring in found
        ]

    return spoil


@pytest.mark.parametrize(
    ("spoil", "code"),
    [
        (of_claim("vertices", 9), REFUTED),
        (of_claim("facets", 7), REFUTED),
        (of_claim("volume", "8.0000001"), REFUTED),
        (of_claim("volume", "-8"), REFUTED),
        (of_claim("digest", "0" * 64), REFUTED),
        (of_claim("scaling", ["1", "1", "2"]), REFUTED),
        (of_claim("sum", 1), MALFORMED),
        (of_claim("claim", "total"), MALFORMED),
        (lambda c: c["sums"][0].__setitem__("scaling", ["1", "1", "2"]), REFUTED),
        (lambda c: c["sums"][0].__setitem__("scaling", ["1", "0", "1"]), MALFORMED),
        (lambda c: c["sums"][0]["vertices"].__setitem__(7, [7, 3]), REFUTED),
        (lambda c: c["sums"][0]["vertices"].append([7, 7]), MALFORMED),
        (lambda c: c["sums"].append(c["sums"][0]), MALFORMED),
        (lambda c: c["claims"].append(c["claims"][0]), MALFORMED),
        (lambda c: c["case"].__setitem__("sha256", "0" * 64), REFUTED),
        (rings(A, B, C, D, E), REFUTED),
        (rings(A, A, B, C, D, E, F), REFUTED),
        (rings(B, A, C, D, E, F), REFUTED),
        (rings([A[1], *A[2:], A[0]], B, C, D, E, F), REFUTED),
    ],
)
def test_false_certificates(check_value: Any, spoil: Any, code: int) -> None:
    value = cubes.certificate()
    spoil(value)
    assert check_value(value, cubes.CASE)[0] == code


def of_case(spoil: Any) -> Any:
    case = json.loads(json.dumps(cubes.CASE))
    spoil(case)
    return case


@pytest.mark.parametrize(
    "case",
    [
        of_case(lambda c: c.__setitem__("dimension", 2)),
        of_case(lambda c: c["P"]["faces"].pop()),
        of_case(lambda c: c["P"]["faces"].append(c["P"]["faces"][0])),
        of_case(lambda c: c["P"]["faces"].__setitem__(0, c["P"]["faces"][0][::-1])),
        of_case(lambda c: c["P"]["vertices"].__setitem__(7, ["1/2", "1/2", "1/2"])),
        of_case(lambda c: c["P"]["vertices"].append(["1/2", "1/2", "1/2"])),
        of_case(lambda c: c["P"]["vertices"].__setitem__(7, ["1", "1", "2"])),
    ],
)
def test_operands_that_are_not_convex(check_value: Any, case: Any) -> None:
    """Even where the certificate is about this case."""
    value = cubes.certificate()
    value["case"]["sha256"] = cubes.digest_of_case(case)
    assert check_value(value, case)[0] in (REFUTED, MALFORMED)


def test_an_empty_list_of_claims_and_a_small_budget(check: Any, tmp_path: Path) -> None:
    cube = cubes.polyhedron(cubes.cube_of("1"))
    texts = certified(cube, cube, [cubes.whole_scaling(1, 1, 1)])
    path = written(texts, tmp_path)
    assert check(path)[0] == VERIFIED
    assert check(path, "--tests", "100")[0] == OUT_OF_BUDGET
    value = json.loads(path.read_text(encoding="utf-8"))
    value["claims"] = []
    path.write_text(json.dumps(value), encoding="utf-8")
    assert check(path)[0] == MALFORMED


def test_no_mutant_with_a_changed_claim_is_accepted(check_value: Any) -> None:
    value = cubes.certificate()
    count = 0
    for mutant in mutants(value, 4, random.Random(SEED)):
        code, said = check_value(mutant.value, cubes.CASE)
        if mutant.path[0] in ("claims", "case", "certificate"):
            count += 1
            assert code != VERIFIED, (SEED, mutant, said)
    assert count >= 30
