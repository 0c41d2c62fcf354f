"""Sums of convex polyhedra: whatever is changed in a certificate or its case, both checkers give
one verdict, and what they still verify is true by the independent hull."""

from __future__ import annotations

import random
from collections.abc import Iterator
from fractions import Fraction
from pathlib import Path

import cubes
import pytest
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.space.generators.convex import random_hull
from minkref.fuzz.space.hull import convex_hull, is_convex
from replacing import Change, Value, changed, replaced, sample, verdicts_on

SCALINGS = [cubes.whole_scaling(1, 1, 1), cubes.whole_scaling("1/2", 3, "7/5")]


def flat_top() -> Polyhedron:
    """A cube whose top is in four triangles."""
    vertices = [*cubes.CUBE["vertices"], ["1/2", "1/2", "1"]]
    faces = [*cubes.RINGS[:3], *cubes.RINGS[4:], [1, 5, 8], [5, 7, 8], [7, 3, 8], [3, 1, 8]]
    return Polyhedron.from_document({"vertices": vertices, "faces": faces})


def tetrahedron() -> Polyhedron:
    corners = [(0, 0, 0), (2, 0, 0), (0, 1, 0), (1, 1, 3)]
    return convex_hull(cubes.whole_scaling(*corner) for corner in corners)


def random_pair(number: int) -> tuple[Polyhedron, Polyhedron]:
    dice = random.Random(number)
    return random_hull(dice, 5, 2), random_hull(dice, 6, 3)


PAIRS = {
    "flat vertex": (flat_top(), tetrahedron()),
    "cubes": (cubes.polyhedron(cubes.CUBE), cubes.polyhedron(cubes.CUBE)),
    "random 1": random_pair(1),
    "random 2": random_pair(2),
}


def changes(certificate: Value, case: Value) -> Iterator[Change]:
    """Changes the certificate, and the case with its old digest and with its new one."""
    for value in changed(certificate):
        yield value, case
    for value in changed(case):
        yield certificate, value
        digest = digest_if_it_has_one(value)
        if digest is not None and digest != certificate["case"]["sha256"]:
            yield replaced(certificate, ("case", "sha256"), digest), value


def digest_if_it_has_one(case: Value) -> str | None:
    try:
        return cubes.digest_of_case(case)
    except (KeyError, TypeError, ValueError, ZeroDivisionError):
        return None


def is_true(certificate: Value, case: Value) -> bool:
    """By the independent hull: the operands are hulls, and this is the certificate of their sums,
    whichever way its numbers are written and its claims are ordered."""
    operands = [cubes.polyhedron(case[name]) for name in "PQ"]
    if any(o.fault() or not is_convex(o) for o in operands):
        return False
    if any(o.volume != convex_hull(o.vertices).volume for o in operands):
        return False
    scalings = [cubes.whole_scaling(*one["scaling"]) for one in certificate["sums"]]
    true = cubes.certificate_of(*operands, scalings)
    return all(
        [in_numbers(one) for one in true[part]]
        == sorted((in_numbers(one) for one in certificate[part]), key=lambda one: one.get("sum", 0))
        for part in ("sums", "claims")
    )


def in_numbers(entry: Value) -> Value:
    result = {**entry, "scaling": list(map(Fraction, entry["scaling"]))}
    return result | ({"volume": Fraction(entry["volume"])} if "volume" in entry else {})


@pytest.mark.parametrize("name", PAIRS)
def test_every_change_is_refused_or_true(tmp_path: Path, name: str) -> None:
    P, Q = PAIRS[name]
    certificate = cubes.certificate_of(P, Q, SCALINGS if name == "cubes" else SCALINGS[1:])
    case = cubes.case_of(P, Q)
    given = sample(changes(certificate, case))
    if name == "flat vertex":  # which may be moved in its plane
        moved = replaced(case, ("P", "vertices", 8, 0), "1/4")
        digest = cubes.digest_of_case(moved)
        given.append((replaced(certificate, ("case", "sha256"), digest), moved))
    codes = verdicts_on(tmp_path, [(certificate, case), *given])
    assert codes[0] == 0
    held = [one for one, code in zip(given, codes[1:], strict=True) if code == 0]
    assert all(is_true(*one) for one in held)
    of_certificate = [one for one in held if one[1] == case]
    assert all(same_numbers(one[0], certificate) for one in of_certificate)
    if name == "flat vertex":
        assert any(cubes.digest_of_case(one[1]) != certificate["case"]["sha256"] for one in held)
    assert len(held) < len(given) / 20


def same_numbers(one: Value, other: Value) -> bool:
    return all(
        sorted(map(str, map(in_numbers, one[part])))
        == sorted(map(str, map(in_numbers, other[part])))
        for part in ("sums", "claims")
    )
