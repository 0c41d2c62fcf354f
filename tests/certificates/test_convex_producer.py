"""Sums of convex polyhedra: what the producer writes is verified by both checkers, and says what
the independent hull says."""

from __future__ import annotations

import json
import random
import subprocess
from fractions import Fraction
from itertools import pairwise
from pathlib import Path
from typing import Any

import cubes
import pytest
from minkref import _core
from minkref.certify.space.convex_certificate import ConvexCertificate, Texts, convex_certificate
from minkref.cli.cli import run
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.geometry.space import Point
from minkref.fuzz.space.generators.convex import box, random_hull, sphere
from minkref.fuzz.space.hull import sum_of_convex
from minkref.reports.evidence.certificates.checkers import in_cpp
from thoroughness import draws

SEED = 21
SCALINGS = [(1, 1, 1), ("1/2", 3, "7/5"), (1000, "1/1000", 1)]


def given(body: Polyhedron) -> _core.Polyhedron:
    value = body.document()
    return _core.Polyhedron([tuple(vertex) for vertex in value["vertices"]], value["faces"])


def certified(P: Polyhedron, Q: Polyhedron, scalings: list[Point]) -> Texts:
    texts = [(str(x), str(y), str(z)) for x, y, z in scalings]
    return convex_certificate(given(P), given(Q), texts, "case.json", "a test")


def written(texts: Texts, folder: Path) -> Path:
    (folder / "case.json").write_text(texts.case, encoding="utf-8")
    path = folder / "it.cert.json"
    path.write_text(texts.certificate, encoding="utf-8")
    return path


def triangulated(body: Polyhedron, dice: random.Random, centres: float = 0.5) -> Polyhedron:
    """The same set with fans for faces, so many of them about a vertex inside the face, and with
    vertices numbered in another order."""
    vertices, faces = list(body.vertices), []
    for face in body.faces:
        if dice.random() < centres:
            x, y, z = (
                sum(column) / len(face) for column in zip(*(vertices[i] for i in face), strict=True)
            )
            faces += [(a, b, len(vertices)) for a, b in zip(face, face[1:] + face[:1], strict=True)]
            vertices.append((x, y, z))
        else:
            faces += [(face[0], *edge) for edge in pairwise(face[1:])]
    order = list(range(len(vertices)))
    dice.shuffle(order)
    place = {old: new for new, old in enumerate(order)}
    return Polyhedron(
        tuple(vertices[old] for old in order),
        tuple(tuple(place[i] for i in face) for face in faces),
    )


def with_middles(body: Polyhedron) -> Polyhedron:
    """The same set with a flat vertex inside each edge."""
    vertices, faces, middles = list(body.vertices), [], {}
    for face in body.faces:
        ring: list[int] = []
        for a, b in zip(face, face[1:] + face[:1], strict=True):
            edge = (min(a, b), max(a, b))
            if edge not in middles:
                middles[edge] = len(vertices)
                ends = zip(vertices[a], vertices[b], strict=True)
                x, y, z = ((2 * p + q) / 3 for p, q in ends)
                vertices.append((x, y, z))
            ring += [a, middles[edge]]
        faces.append(tuple(ring))
    return Polyhedron(tuple(vertices), tuple(faces))


def random_body(dice: random.Random) -> Polyhedron:
    kind = dice.randrange(6)
    if kind == 0:
        return sphere(dice, dice.randint(4, 8), Fraction(dice.randint(1, 9), dice.randint(1, 4)))
    if kind == 1:
        low, high = sorted(dice.sample(range(-4, 5), 2))
        return box(cubes.whole_scaling(low, low, -1), cubes.whole_scaling(high, high, 2))
    return random_hull(dice, dice.randint(4, 14), dice.randint(1, 5))


def pairs(count: int) -> list[tuple[Polyhedron, Polyhedron]]:
    dice = random.Random(SEED)
    return [(random_body(dice), random_body(dice)) for _ in range(count)]


@pytest.mark.parametrize("number", range(draws(3, 10)))
def test_all_are_verified_and_say_what_the_hull_says(
    check: Any, tmp_path: Path, number: int
) -> None:
    for P, Q in pairs(60)[number :: draws(20, 10)]:
        scalings = [cubes.whole_scaling(*s) for s in SCALINGS]
        texts = certified(P, Q, scalings)
        value = json.loads(texts.certificate)
        assert value.pop("producer") and value.pop("title") == "a test"
        assert value == cubes.certificate_of(P, Q, scalings)  # there is no other
        code, said = check(written(texts, tmp_path))
        assert code == 0, said
        for scaling in scalings:
            assert cubes.digest_of(sum_of_convex(P, Q, scaling).document()) in said


@pytest.mark.parametrize("number", range(draws(2, 5)))
def test_operands_with_flat_vertices_in_any_order(check: Any, tmp_path: Path, number: int) -> None:
    """Their faces are in parts; the sum is the same."""
    dice = random.Random(number)
    for P, Q in pairs(30)[number :: draws(10, 5)]:
        scaling = [cubes.whole_scaling("1/2", 3, "7/5")]
        plain = json.loads(certified(P, Q, scaling).certificate)["claims"]
        P, Q = triangulated(P, dice), triangulated(with_middles(Q), dice, 1)
        texts = certified(P, Q, scaling)
        assert json.loads(texts.certificate)["claims"] == plain
        code, said = check(written(texts, tmp_path))
        assert code == 0, said
        code, said = check(written(certified(with_middles(P), P, scaling), tmp_path))
        assert code == 0, said


def test_a_sum_that_was_kept_up_to_date(check: Any, tmp_path: Path) -> None:
    P, Q = pairs(1)[0]
    certificate = ConvexCertificate(given(P), given(Q))
    dynamic = _core.DynamicConvexSum(certificate.P.convex, certificate.Q.convex, ("1", "1", "1"))
    for n, at in enumerate([("2", "1", "1/3"), ("9", "1/7", "1"), ("1/8", "1/8", "20")]):
        dynamic.update(at)
        assert certificate.add(at, dynamic.sum()) == n
        assert certificate.sum(at) == n
    texts = Texts(certificate.text("case.json"), certificate.case())
    code, said = check(written(texts, tmp_path))
    assert code == 0, said
    assert said.count("sum: at") == 3


def test_a_scaling_is_claimed_once(check: Any, tmp_path: Path) -> None:
    cube = given(box(cubes.whole_scaling(0, 0, 0), cubes.whole_scaling(1, 1, 1)))
    scalings = [("1", "2", "3"), ("2/2", "2", "6/2"), ("1", "1", "1")]
    texts = convex_certificate(cube, cube, scalings, "case.json")
    value = json.loads(texts.certificate)
    assert [claim["scaling"] for claim in value["claims"]] == [["1", "2", "3"], ["1", "1", "1"]]
    assert check(written(texts, tmp_path))[0] == 0


@pytest.mark.parametrize("scaling", [("1", "0", "1"), ("1", "1", "-2")])
def test_bad_scalings_are_refused(scaling: tuple[str, str, str]) -> None:
    cube = given(box(cubes.whole_scaling(0, 0, 0), cubes.whole_scaling(1, 1, 1)))
    with pytest.raises(_core.BadInput):
        convex_certificate(cube, cube, [scaling], "case.json")


def test_an_operand_that_is_not_convex_is_refused() -> None:
    cube = given(box(cubes.whole_scaling(0, 0, 0), cubes.whole_scaling(1, 1, 1)))
    pit = [*cubes.CUBE["vertices"], ["1/2", "1/2", "1/2"]]
    faces = [*cubes.RINGS[:3], *cubes.RINGS[4:], [1, 5, 8], [5, 7, 8], [7, 3, 8], [3, 1, 8]]
    dented = _core.Polyhedron([tuple(vertex) for vertex in pit], faces)
    with pytest.raises(_core.BadInput):
        convex_certificate(cube, dented, [("1", "1", "1")], "case.json")


def test_both_forms_by_one_command(tmp_path: Path, capfd: pytest.CaptureFixture[str]) -> None:
    """`minkref check` and the checker in C++ follow the form that a file says it has."""
    P, Q = pairs(1)[0]
    path = written(certified(P, Q, [cubes.whole_scaling(1, 1, 1)]), tmp_path)
    value = json.loads(path.read_text(encoding="utf-8"))
    value["claims"][0]["facets"] += 1
    false = tmp_path / "false.cert.json"
    false.write_text(json.dumps(value), encoding="utf-8")
    old = tmp_path / "old.cert.json"
    old.write_text('{"certificate": "certificate-v1"}', encoding="utf-8")
    for files, code in (([path], 0), ([path, false], 1), ([old, path], 2)):
        names = list(map(str, files))
        assert run(["check", *names]) == code
        ours = capfd.readouterr()
        assert subprocess.run([*in_cpp(), *names], check=False).returncode == code
        for said in (ours, capfd.readouterr()):
            assert said.err == "" and "verified\n  case " in said.out
            assert "\n  sum: at (1, 1, 1), " in said.out
