"""Certificates of sums of solids that break one rule each (docs/certificates-solid_pairs.md)."""

from __future__ import annotations

import copy
import json
from collections.abc import Callable
from itertools import product
from pathlib import Path
from typing import Any

import cubes
import pytest
import solid_pairs
from file_alone import alone, laid
from minkref.fuzz.space.cells import surface_of

Value = Any
CERTIFICATE, CASE = solid_pairs.values(solid_pairs.L, solid_pairs.brick(1, 1, 1), [solid_pairs.ONE])
TREES = {
    (tuple(normal), offset): n
    for n, (normal, offset, _) in enumerate(CERTIFICATE["proof"]["sums"][0]["planes"])
}
STEP = ((0, 1, 0), "2")  # ["cut", 1, 0, 0, 2], ["above", 1, 0], ["face", 0, 0]
TOP = ((0, 0, 1), "2")  # a cut, a face, a cut, a face, ["none"]


def planes(value: Value) -> list[Value]:
    found: list[Value] = value["proof"]["sums"][0]["planes"]
    return found


def set_tree(of: tuple[tuple[int, ...], str], *entries: Value) -> Callable[[Value], None]:
    def spoil(value: Value) -> None:
        planes(value)[TREES[of]][2] = list(entries)

    return spoil


def set_hulls(of: str, *hulls: list[int]) -> Callable[[Value], None]:
    def spoil(value: Value) -> None:
        value["proof"][of]["hulls"] = list(hulls)

    return spoil


def drop_plane(value: Value) -> None:
    del planes(value)[TREES[STEP]]


def add_plane(value: Value) -> None:
    planes(value).append([[1, 1, 1], "9", [["none"]]])


def swap_planes(value: Value) -> None:
    planes(value)[0], planes(value)[1] = planes(value)[1], planes(value)[0]


def add_point(value: Value) -> None:
    value["proof"]["P"]["points"].append(["5", "5", "5"])


def add_flat_point(value: Value) -> None:
    value["proof"]["Q"]["points"].append(["1/2", "1/2", "1"])
    value["proof"]["Q"]["hulls"] = [[*range(9)]]


def one_more(name: str) -> Callable[[Value], None]:
    def spoil(value: Value) -> None:
        value["claims"][0][name] += 1

    return spoil


def set_volume(value: Value) -> None:
    value["claims"][0]["volume"] = "17"


def claim_twice(value: Value) -> None:
    value["claims"] *= 2


def prove_twice(value: Value) -> None:
    value["proof"]["sums"] *= 2


def forget_claim(value: Value) -> None:
    value["claims"] = []


def repeat_pieces(value: Value) -> None:
    for name in "PQ":
        value["proof"][name]["hulls"] *= 150


CUT = ["cut", 1, 0, 0, 2]
SPOILT: dict[str, tuple[Callable[[Value], Any], int, str]] = {
    "a plane is not there": (drop_plane, 1, "more planes, or fewer"),
    "a plane too many": (add_plane, 1, "more planes, or fewer"),
    "planes in another order": (swap_planes, 1, "another is expected"),
    "a face that is covered": (set_tree(STEP, ["face", 0, 0]), 1, "a sum of two pieces is above"),
    "no cut": (set_tree(STEP, ["above", 1, 0]), 1, "does not lie in the sum"),
    "covered by what ends here": (
        set_tree(STEP, CUT, ["above", 0, 0], ["face", 0, 0]), 1, "is not above it",
    ),
    "no face where there is one": (
        set_tree(STEP, CUT, ["above", 1, 0], ["none"]), 1, "a sum of two pieces is below",
    ),
    "a face of another pair": (
        set_tree(STEP, CUT, ["above", 1, 0], ["face", 1, 0]), 1, "does not lie in the sum",
    ),
    "a face where there is none": (
        set_tree(TOP, ["cut", 0, 1, 0, 2], ["face", 0, 0], ["face", 1, 0]), 1,
        "does not lie in the sum",
    ),
    "a cut beside": (set_tree(STEP, ["cut", 1, 0, 0, 3], ["none"]), 1, "does not cut"),
    "a cut along the plane": (set_tree(STEP, ["cut", 0, 1, 0, 2], ["none"]), 1, "does not cut"),
    "a cut by nothing": (set_tree(STEP, ["cut", 0, 0, 0, 0], ["none"]), 1, "does not cut"),
    "a tree that ends too early": (set_tree(STEP, CUT, ["above", 1, 0]), 2, "entries are missing"),
    "a tree that goes on": (
        set_tree(STEP, CUT, ["above", 1, 0], ["face", 0, 0], ["none"]), 2, "nothing is left",
    ),
    "no entry": (set_tree(STEP, []), 2, "a list is empty"),
    "a cut of numbers without end": (
        set_tree(STEP, ["cut", 7**5000, 0, 0, 3**9000], ["none"]), 1, "does not cut",
    ),
    "a scaling without end": (
        lambda value: value["proof"]["sums"][0].update(scaling=["7" * 2000, "1", "1/3"]), 1, ": ",
    ),
    "an unknown entry": (set_tree(STEP, ["below", 0, 0]), 2, "there is no entry"),
    "a piece that is not there": (set_tree(STEP, ["above", 2, 0]), 2, "no number 2"),
    "a piece left out": (set_hulls("P", [0, 1, 2, 6, 7, 8, 12, 13]), 1, "do not tile"),
    "a piece too small": (
        set_hulls("P", [0, 1, 2, 6, 7, 8, 12, 13], [3, 4, 5, 9, 10, 12, 13]), 1, "do not tile",
    ),
    "a piece twice": (set_hulls("Q", [*range(8)], [*range(8)]), 1, "do not tile"),
    "the hull of all": (set_hulls("P", [0, 1, 4, 5, 6, 7, 10, 11]), 2, "a point is in no piece"),
    "too many pairs": (repeat_pieces, 4, "too many pairs of pieces"),
    "a flat piece": (set_hulls("Q", [0, 1, 2, 3]), 2, "its points lie in a plane"),
    "too few points": (set_hulls("Q", [0, 1, 2]), 2, "under 4"),
    "no pieces": (set_hulls("Q"), 2, "has no pieces"),
    "points that do not ascend": (set_hulls("Q", [1, 0, *range(2, 8)]), 2, "do not ascend"),
    "a point in no piece": (add_point, 2, "a point is in no piece"),
    "a point that is no corner": (add_flat_point, 2, "no corner"),
    "another number of planes": (one_more("planes"), 1, "not so many"),
    "another number of polygons": (one_more("polygons"), 1, "not so many"),
    "another volume": (set_volume, 1, "the volume is another"),
    "another number of components": (one_more("components"), 1, "not so many"),
    "another number of cavities": (one_more("cavities"), 1, "not so many"),
    "another number of tunnels": (one_more("tunnels"), 1, "not so many"),
    "no number of tunnels": (lambda value: value["claims"][0].pop("tunnels"), 2, "no integer"),
    "cavities in words": (lambda value: value["claims"][0].update(cavities="0"), 2, "no integer"),
    "a claim twice": (claim_twice, 2, "a claim is made twice"),
    "a sum twice": (prove_twice, 2, "two sums are at one scaling"),
    "nothing claimed": (forget_claim, 2, "nothing is claimed"),
}  # fmt: skip


def test_it_is_verified_as_it_is(check_value: Any) -> None:
    code, said = check_value(CERTIFICATE, CASE)
    assert code == 0 and "sum: at (1, 1, 1), 8 planes, 1 components" in said
    assert ", 0 cavities, 0 tunnels, volume 16, " in said


@pytest.mark.parametrize("what", SPOILT)
def test_what_breaks_a_rule_is_refused(expect_refused: Any, what: str) -> None:
    spoil, code, why = SPOILT[what]
    expect_refused(copy.deepcopy(CERTIFICATE), CASE, spoil, code, why)


def test_a_hole_in_an_operand_is_no_part_of_it(check_value: Any) -> None:
    """The pieces of the full box tile no box with a cavity, nor the other way round."""
    hollow = surface_of(set(product(range(3), repeat=3)) - {(1, 1, 1)})
    full = surface_of(set(product(range(3), repeat=3)))
    cube = solid_pairs.brick(1, 1, 1)
    for one, other in ((hollow, full), (full, hollow)):
        certificate, _ = solid_pairs.values(one, cube, [solid_pairs.ONE])
        _, case = solid_pairs.values(other, cube, [solid_pairs.ONE])
        certificate["case"]["sha256"] = cubes.digest_of_case(case)
        code, said = check_value(certificate, case)
        assert code in (1, 2), said


def test_an_operand_turned_inside_out_is_refused(check_value: Any) -> None:
    case = copy.deepcopy(CASE)
    case["P"]["faces"] = [face[::-1] for face in case["P"]["faces"]]
    certificate = copy.deepcopy(CERTIFICATE)
    certificate["case"]["sha256"] = cubes.digest_of_case(case)
    code, said = check_value(certificate, case)
    assert code == 1 and "the pieces of P do not tile it" in said


def test_what_abuts_from_above_has_no_face_below(check_value: Any) -> None:
    """Two cells, one apart, each plus a cell: the sums abut in the plane x = 2."""
    cells = surface_of({(0, 0, 0), (2, 0, 0)})
    certificate, case = solid_pairs.values(cells, solid_pairs.brick(1, 1, 1), [solid_pairs.ONE])
    (tree,) = (plane[2] for plane in planes(certificate) if plane[:2] == [[1, 0, 0], "2"])
    (entry,) = tree
    assert entry[0] == "above"
    entry[0] = "face"
    code, said = check_value(certificate, case)
    assert code == 1 and "the sum of these pieces is not below it" in said


def test_components_may_be_left_out(check_value: Any) -> None:
    certificate = copy.deepcopy(CERTIFICATE)
    for name in ("components", "cavities", "tunnels"):
        del certificate["claims"][0][name]
    code, said = check_value(certificate, CASE)
    assert code == 0 and "8 planes, volume 16, " in said, said


def test_another_way_to_cut_is_as_good(check_value: Any) -> None:
    certificate = copy.deepcopy(CERTIFICATE)
    tree = [["cut", -2, 0, 0, -3], ["cut", -1, 0, 0, -2], ["face", 0, 0], ["above", 1, 0]]
    set_tree(STEP, *tree, ["above", 1, 0])(certificate)
    code, said = check_value(certificate, CASE)
    assert code == 0, said


def test_the_file_alone_follows_it(tmp_path: Path) -> None:
    ran = alone(laid(tmp_path, CASE, CERTIFICATE), "it.cert.json")
    assert (ran.returncode, ran.stderr) == (0, "") and ": verified" in ran.stdout


def test_both_count_the_same_tests(check: Any, tmp_path: Path) -> None:
    path = laid(tmp_path, CASE, CERTIFICATE) / "it.cert.json"

    def verified(tests: int) -> bool:
        code, said = check(path, "--tests", str(tests))
        assert code in (0, 4), said
        return bool(code == 0)

    few, enough = 0, 1 << 20
    assert verified(enough) and not verified(few)
    while enough - few > 1:
        middle = (few + enough) // 2
        few, enough = (few, middle) if verified(middle) else (middle, enough)
    assert 1000 < enough < 100_000


def test_texts_without_effect(check_value: Any) -> None:
    told = {**CERTIFICATE, "title": "a title", "comment": "a comment"}
    assert check_value(told, CASE)[0] == 0
    assert check_value({**told, "title": 1}, CASE)[0] == 2
    assert json.dumps(CERTIFICATE["claims"]) in json.dumps(told)
