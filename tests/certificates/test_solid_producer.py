"""Sums of polyhedra of any shape: what the producer writes is verified, and says what the slow
engine says, which shares nothing with it."""

from __future__ import annotations

import hashlib
import json
import random
from itertools import product
from pathlib import Path
from typing import Any

import cubes
import pytest
import solid_pairs
from minkref import _core
from minkref.certify.space import solid_certificate, tiled_solids
from minkref.certify.space.convex_certificate import convex_certificate
from minkref.errors import Refusal
from minkref.fuzz.judges.space.certified_solids import SolidConfirmation
from minkref.fuzz.space.general_pairs import FAMILIES, pair_of_family
from thoroughness import THOROUGH, draws

SEED = 11


def turn_of(name: str, scalings: list[solid_pairs.Scaling]) -> list[solid_pairs.Scaling]:
    """The first of one pair, the last of the next, where few are drawn."""
    return scalings if THOROUGH else [scalings[-(list(solid_pairs.PAIRS).index(name) % 2)]]


@pytest.mark.parametrize("name", solid_pairs.PAIRS)
def test_all_are_verified_and_say_what_the_slow_engine_says(
    check: Any, tmp_path: Path, name: str
) -> None:
    P, Q, every = solid_pairs.PAIRS[name]
    scalings = turn_of(name, every)
    certificate = solid_pairs.certified(P, Q, scalings)
    code, said = check(solid_pairs.written(certificate, tmp_path))
    assert code == 0, said
    assert said.count("sum: at (") == len(scalings)
    assert SolidConfirmation(json.loads(certificate.case())).all_hold(certificate.claims)


def test_a_convex_sum_has_the_digest_of_a_convex_polyhedron() -> None:
    P, Q, scalings = solid_pairs.PAIRS["convex"]
    texts = convex_certificate(solid_pairs.given(P), solid_pairs.given(Q), scalings, "case.json")
    convex = [claim["digest"] for claim in json.loads(texts.certificate)["claims"]]
    assert [claim["digest"] for claim in solid_pairs.certified(P, Q, scalings).claims] == convex


def test_a_hole_that_is_filled_leaves_a_box(check: Any, tmp_path: Path) -> None:
    P, Q, scalings = solid_pairs.PAIRS["ring and what fills its hole"]
    certificate = solid_pairs.certified(P, Q, scalings)
    assert check(solid_pairs.written(certificate, tmp_path))[0] == 0
    whole = _core.PolyhedralSet(solid_pairs.given(solid_pairs.brick(7, 6, 2)))
    found = whole.convex()
    assert found is not None
    digest = hashlib.sha256(found.surface().canonical_json().encode()).hexdigest()
    assert certificate.claims[0]["digest"] == digest


Cells = set[tuple[int, ...]]


def voxel_numbers(cells: Cells) -> list[int]:
    """Components, cavities and tunnels of a set of unit cells, by the Euler characteristic of its
    inside: of cells, and of squares, edges and points around which all cells are in the set. Where
    the outside is pinched to a point, with the inside around it, the inside goes on through it."""
    size = range(-1, max(c for cell in cells for c in cell) + 2)
    rest = set(product(size, repeat=3)) - cells
    ways = list(product((-1, 0, 1), repeat=3))
    beside, around = ([w for w in ways if 0 < sum(map(abs, w)) <= n] for n in (1, 2))
    characteristic = 0
    for spread in product((0, 1), repeat=3):
        block = list(product(*(range(n + 1) for n in spread)))
        inner = sum({moved(cell, w) for w in block} <= cells for cell in cells)
        characteristic += (-1) ** sum(spread) * inner
    for corner in product(size, repeat=3):
        block = {moved(corner, w) for w in product((0, 1), repeat=3)}
        for part in parts(block & cells, beside):
            characteristic += len(parts(block - part, around)) - 1 if part != block else 0
    components = len(parts(cells, beside))
    shells = components + len(parts(rest, around)) - 1
    return [components, len(parts(rest, beside)) - 1, shells - characteristic]


def moved(cell: tuple[int, ...], way: tuple[int, ...]) -> tuple[int, ...]:
    return tuple(map(sum, zip(cell, way, strict=True)))


def parts(cells: Cells, ways: list[tuple[int, ...]]) -> list[Cells]:
    """The cells that hang together along these ways."""
    left, found = set(cells), []
    while left:
        stack = [left.pop()]
        found.append(set(stack))
        while stack:
            near = {moved(stack[-1], way) for way in ways} & left
            stack[-1:] = near
            left -= near
            found[-1] |= near
    return found


def test_components_cavities_and_tunnels_of_cells(check: Any, tmp_path: Path) -> None:
    """Cells apart grow until they touch: sides, edges and corners that meet by chance."""
    print(f"seed {SEED}")
    dice, found = random.Random(SEED), set()
    every = list(product((0, 2, 4), repeat=3))
    for count in range(3, 27) if THOROUGH else (7, 14, 23):
        P = dice.sample(every, count)
        certificate = solid_pairs.certified(
            solid_pairs.apart(*P), solid_pairs.brick(1, 1, 1), [solid_pairs.ONE]
        )
        claim = certificate.claims[0]
        numbers = [claim[name] for name in ("components", "cavities", "tunnels")]
        assert numbers == voxel_numbers({moved(p, e) for p in P for e in product((0, 1), repeat=3)})
        code, said = check(solid_pairs.written(certificate, tmp_path))
        assert code == 0, said
        found.add(tuple(numbers))
    assert len(found) > 2, found


@pytest.mark.parametrize("family", sorted(set(FAMILIES) - {"knot", "thin"}))
def test_random_pairs(check: Any, tmp_path: Path, family: str) -> None:
    for index in range(draws(1, 3)):
        pair = pair_of_family(family, SEED, index)
        scale = str(pair.scale)
        certificate = solid_pairs.certified(pair.P, pair.Q, [(scale, scale, scale)])
        code, said = check(solid_pairs.written(certificate, tmp_path))
        assert code == 0, (pair.name, said)


def test_a_scaling_is_claimed_once(check: Any, tmp_path: Path) -> None:
    cube = solid_pairs.brick(1, 1, 1)
    certificate = solid_pairs.certified(solid_pairs.L, cube, [("1", "2", "3"), ("2/2", "2", "6/2")])
    certificate.sum(("1", "1", "1"))
    assert [claim["scaling"] for claim in certificate.claims] == [("1", "2", "3"), ("1", "1", "1")]
    assert check(solid_pairs.written(certificate, tmp_path))[0] == 0


@pytest.mark.parametrize("scaling", [("1", "0", "1"), ("1", "1", "-2")])
def test_bad_scalings_are_refused(scaling: solid_pairs.Scaling) -> None:
    with pytest.raises(_core.BadInput):
        solid_pairs.certified(solid_pairs.L, solid_pairs.brick(1, 1, 1), [scaling])


def test_operands_that_are_no_solids_are_refused() -> None:
    cube = solid_pairs.given(solid_pairs.brick(1, 1, 1))
    open_ = _core.Polyhedron(cube.points(), cube.rings()[1:])
    point = _core.Polyhedron([("0", "0", "0")], [])
    for other in (open_, point):
        with pytest.raises(_core.BadInput):
            solid_certificate.SolidCertificate(cube, other)
        with pytest.raises(_core.BadInput):
            solid_certificate.SolidCertificate(other, cube)


def test_what_is_too_large_is_refused(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(tiled_solids, "MOST_PAIRS", 3)
    with pytest.raises(Refusal) as pairs:
        solid_pairs.certified(solid_pairs.L, solid_pairs.L, [solid_pairs.ONE])
    assert pairs.value.code == "too-large" and "4 pairs" in pairs.value.what
    monkeypatch.setattr(solid_certificate, "MOST_ENTRIES", 10)
    with pytest.raises(Refusal) as entries:
        solid_pairs.certified(solid_pairs.L, solid_pairs.brick(1, 1, 1), [solid_pairs.ONE])
    assert entries.value.code == "too-large" and "10 entries" in entries.value.what


def test_the_case_is_that_of_the_convex_form() -> None:
    cube = solid_pairs.given(solid_pairs.brick(1, 1, 1))
    made = solid_certificate.SolidCertificate(cube, cube)
    assert made.case_digest() == cubes.digest_of_case(json.loads(made.case()))
