"""Paths and traps: true certificates by hand are verified; each rule refuses a false one, and says
why."""

from __future__ import annotations

from collections.abc import Callable
from functools import reduce
from operator import getitem
from typing import Any

import pytest
import walls
from walls import scales

Spoil = Callable[[dict[str, Any]], object]
REFUTED, MALFORMED = 1, 2


def test_true_ones_are_verified(check_value: Any) -> None:
    code, said = check_value(walls.certificate(), walls.CASE)
    assert code == 0, said
    assert "valid: of (0, inf), contact allowed: (0, 1/3], [2, 2], [9/2, inf)" in said
    code, said = check_value(walls.room(), walls.ROOM_CASE)
    assert code == 0, said
    assert "trap: of (0, inf), contact allowed: (1, 4]" in said


def put(*path: Any) -> Spoil:
    """Another value, the last, at a place."""
    *way, last, value = path
    return lambda c: reduce(getitem, way, c).__setitem__(last, value)


def also(*spoils: Spoil) -> Spoil:
    return lambda c: [spoil(c) for spoil in spoils]


def told(step: int, claim: int, value: Any) -> Spoil:
    """Claim and step name different scales."""
    return also(put("steps", step, "scales", value), put("claims", claim, "scales", value))


def without_answer(c: dict[str, Any]) -> None:
    c["claims"].pop()


@pytest.mark.parametrize(
    ("spoil", "code", "why"),
    [
        (put("steps", 2, "codes", [[]]), REFUTED, "ends too early"),
        (put("steps", 2, "codes", [[0, 0]]), REFUTED, "goes on after its end"),
        (put("steps", 2, "codes", [[-1]]), REFUTED, "splits a piece"),
        (put("steps", 2, "codes", [[1]]), MALFORMED, "no number 1"),
        (put("steps", 2, "codes", [[-4]]), MALFORMED, "no number -4"),
        (put("steps", 2, "codes", [["0"]]), MALFORMED, "integer"),
        (put("steps", 2, "codes", []), MALFORMED, "entries"),
        (put("steps", 2, "codes", [[0], [0]]), MALFORMED, "entries"),
        (put("steps", 2, "normals", [[1, 0]]), REFUTED, "ends too early"),
        (put("steps", 2, "normals", [[0, 0]]), MALFORMED, "zero"),
        (put("steps", 2, "normals", [["-1/2", 0]]), MALFORMED, "whole number"),
        (put("steps", 2, "contact", "forbidden"), REFUTED, "ends too early"),
        (put("steps", 2, "contact", "never"), MALFORMED, "contact"),
        (put("steps", 2, "by", [1, 0]), MALFORMED, "not of R and O"),
        (put("steps", 2, "by", [0, 2]), MALFORMED, ""),
        (put("steps", 2, "path", [["0", "0"]] * 3), MALFORMED, "entries"),
        (put("steps", 2, "path", [["0", "0"]] * 2), REFUTED, "another path"),
        (put("steps", 2, "path", [["0", "1"]]), REFUTED, "another path"),
        (put("steps", 2, "path", []), MALFORMED, "no place"),
        (put("steps", 0, "of", "P"), MALFORMED, "operand"),
        (put("steps", 0, "rule", "eq"), MALFORMED, "rule"),
        (put("steps", 2, "more", 1), MALFORMED, "more members"),
        (put("claims", 0, "scales", scales("0", "1/4", "(]")), REFUTED, "other scales"),
        (put("claims", 0, "contact", "forbidden"), REFUTED, "another contact"),
        (put("claims", 0, "step", 0), MALFORMED, ""),
        (put("claims", 0, "claim", "sum"), MALFORMED, "no "),
        (told(2, 0, scales("0", "1/2", "(]")), REFUTED, "ends too early"),
        (told(2, 0, scales("0", None, "()")), REFUTED, "ends too early"),
        (told(3, 2, scales("2", "3", "[]")), REFUTED, "ends too early"),
        (told(3, 2, scales("2", "2", "(]")), MALFORMED, "no scales"),
        (told(3, 2, scales("3", "2", "[]")), MALFORMED, "no scales"),
        (told(2, 0, scales("0", "1/3", "[]")), MALFORMED, "no scales"),
        (told(2, 0, scales("-1", "1/3", "(]")), MALFORMED, "no scales"),
        (told(4, 4, scales("9/2", None, "[]")), MALFORMED, "no scales"),
        (told(2, 0, {**scales("0", "1", "()"), "to_in": 0}), MALFORMED, "true or false"),
        (put("claims", 1, "scales", "to_in", True), REFUTED, "do not reach"),
        (put("claims", 1, "scales", "from_in", True), REFUTED, "leaves out"),
        (put("claims", 1, "scales", scales("1/4", "2", "()")), REFUTED, "leaves out"),
        (put("claims", 1, "scales", scales("1/3", "3", "()")), REFUTED, "do not reach"),
        (put("claims", 1, "hits", []), REFUTED, "do not reach"),
        (put("claims", 1, "hits", walls.CLAIMS[1]["hits"] * 2), REFUTED, "adds none"),
        (put("claims", 1, "hits", 0, "segment", 1), MALFORMED, "no number 1"),
        (put("claims", 1, "hits", 0, "nodes", [0, 1]), REFUTED, "not in its piece"),
        (put("claims", 1, "hits", 0, "nodes", [0, 2]), REFUTED, "not convex"),
        (put("claims", 1, "hits", 0, "points", 1, ["0", "1", ["7/2", "1/2"]]), REFUTED, "not in"),
        (put("claims", 1, "hits", 0, "points", 1, ["0", "1", ["3", "1/2"]]), REFUTED, "interior"),
        (put("claims", 1, "hits", 0, "points", 1, ["0", "1/3", ["1", "1/6"]]), MALFORMED, "ascend"),
        (put("claims", 1, "hits", 0, "points", 0, 1, "-1"), MALFORMED, "no scale"),
        (put("claims", 1, "hits", 0, "points", 1, 0, "2"), MALFORMED, "no place"),
        (put("claims", 1, "hits", 0, "points", ["up"]), MALFORMED, "no point"),
        (put("claims", 1, "hits", 0, "points", []), MALFORMED, "no point"),
        (put("claims", 1, "hits", 0, "points", 2, "up"), REFUTED, "not in its piece"),
        (put("claims", 5, "claims", [0, 1, 2, 3]), REFUTED, ""),
        (put("claims", 5, "claims", [0, 2, 3, 4]), REFUTED, ""),
        (put("claims", 5, "claims", [0, 1, 2, 3, 5]), MALFORMED, "no number 5"),
        (put("claims", 5, "claims", []), REFUTED, ""),
        (put("claims", 5, "valid", [walls.LOW, walls.HIGH]), REFUTED, "scales are others"),
        (put("claims", 5, "scales", scales("1", None, "()")), REFUTED, ""),
        (put("claims", 5, "contact", "forbidden"), REFUTED, "contact"),
        (also(put("claims", 5, "claim", "trap"), lambda c: c["claims"][5].update(
            trapped=c["claims"][5].pop("valid"))), MALFORMED, "another kind"),
        (lambda c: c["steps"].append(c["steps"][2]), MALFORMED, "not used"),
        (lambda c: c["claims"].append(c["claims"][0]), MALFORMED, "twice"),
        (lambda c: c["claims"].clear(), MALFORMED, "nothing is claimed"),
        (put("case", "sha256", "0" * 64), REFUTED, "not the case"),
    ],
)  # fmt: skip
def test_a_false_one_about_a_path_is_not(
    expect_refused: Any, spoil: Spoil, code: int, why: str
) -> None:
    expect_refused(walls.certificate(), walls.CASE, spoil, code, why)


@pytest.mark.parametrize(
    ("spoil", "code", "why"),
    [
        (put("steps", 2, "path", [["2", "1"], ["6", "2"]]), REFUTED, ""),
        (put("steps", 2, "path", [["2", "2"], ["3", "2"]]), REFUTED, "not beyond"),
        (put("steps", 2, "path", [["2", "2"], ["11/2", "2"]]), 0, ""),
        (put("steps", 2, "path", [["2", "2"], ["54/10", "2"]]), REFUTED, "not beyond"),
        (put("steps", 2, "path", [["2", "2"], ["6", "21/10"]]), REFUTED, "ends too early"),
        (put("steps", 2, "path", None), REFUTED, "not beyond"),
        (put("claims", 0, "normal", [-1, 0]), REFUTED, "not beyond"),
        (put("claims", 0, "normal", [0, 0]), MALFORMED, "zero"),
        (put("claims", 0, "step", 3), REFUTED, "other scales"),
        (told(2, 0, scales("0", "2", "(]")), REFUTED, "ends too early"),
        (told(3, 1, scales("1", "4", "[]")), REFUTED, "inside|in the sum"),
        (told(3, 1, scales("1/2", "4", "(]")), REFUTED, "in the sum"),
        (told(3, 1, scales("1", "5", "(]")), REFUTED, "ends too early"),
        (also(without_answer, told(3, 1, scales("1", "4", "()"))), 0, ""),
        (put("claims", 1, "ring", 0, ["9/2", "0", "-1", "0"]), REFUTED, "in the sum"),
        (put("claims", 1, "ring", 1, ["9/2", "0", "5/2", "0"]), REFUTED, "in the sum"),
        (put("claims", 1, "ring", 1, ["9/2", "1", "2", "0"]), REFUTED, "in the sum"),
        (put("claims", 1, "ring", 1, ["9/2", "1/10", "2", "0"]), 0, ""),
        (put("claims", 1, "ring", 1, ["9/2", "0", "2"]), MALFORMED, "entries"),
        (put("claims", 1, "pairs", [[0, 3], [0, 4], [0, 2], [0, 1]]), MALFORMED, "entries"),
        (put("claims", 1, "pairs", 0, [0, 0]), REFUTED, "in the sum"),
        (put("claims", 1, "pairs", 0, [0, 5]), REFUTED, "convex"),
        (also(put("claims", 1, "ring", []), put("claims", 1, "pairs", [])), REFUTED, "around"),
        (also(put("claims", 1, "ring", [walls.RING[3], walls.RING[4]]),
              put("claims", 1, "pairs", [[0, 1], [0, 1]])), REFUTED, "around"),
        (put("claims", 1, "step", 2), REFUTED, ""),
        (put("claims", 2, "hits", 0, "points", 2, ["0", "6", ["2", "-1/4"]]), REFUTED, "reach"),
        (put("claims", 3, "trapped", [walls.OUT]), REFUTED, "scales are others"),
        (put("claims", 3, "claims", [1, 2]), REFUTED, ""),
    ],
)  # fmt: skip
def test_a_false_one_about_a_trap_is_not(
    check_value: Any, spoil: Spoil, code: int, why: str
) -> None:
    value = walls.room()
    spoil(value)
    got, said = check_value(value, walls.ROOM_CASE)
    assert got == code, said
    assert any(part in said for part in why.split("|")), said


def test_ranges_that_follow_each_other_are_one(check_value: Any) -> None:
    """Holds for a trap as for a path."""
    value = walls.room()
    first, second = scales("1", "2", "(]"), scales("2", "4", "(]")
    value["steps"][3]["scales"] = first
    value["steps"].append({**value["steps"][3], "scales": second})
    value["claims"][1]["scales"] = first
    value["claims"].insert(2, {**value["claims"][1], "scales": second, "step": 4})
    value["claims"][4]["claims"] = [0, 1, 2, 3]
    code, said = check_value(value, walls.ROOM_CASE)
    assert code == 0, said
    value["claims"][4]["trapped"] = [first, second]
    code, said = check_value(value, walls.ROOM_CASE)
    assert (code, "scales are others" in said) == (REFUTED, True)


def test_a_trap_is_about_one_place(check_value: Any) -> None:
    case = {**walls.ROOM_CASE, "path": [["2", "2"], ["2", "2"]]}
    value = walls.room()
    value["case"]["sha256"] = walls.digest_of_case(case)
    value["steps"][3]["path"] = [["2", "2"]]
    code, said = check_value(value, case)
    assert (code, "not one place" in said) == (MALFORMED, True), said


def test_a_path_that_collides_is_no_answer_about_a_place(check_value: Any) -> None:
    """Some place of a path may collide at all scales, and another one be a trap."""
    case = {**walls.CASE, "path": [["0", "0"], ["-1", "0"]]}
    value = walls.certificate()
    value["case"]["sha256"] = walls.digest_of_case(case)
    value["steps"] = walls.PIECES
    told = walls.CLAIMS[1]["scales"]
    value["claims"] = [walls.CLAIMS[1], {"claim": "trap", "contact": "allowed", "scales": told,
                                         "trapped": [], "claims": [0]}]  # fmt: skip
    code, said = check_value(value, case)
    assert (code, "not one place" in said) == (MALFORMED, True), said
    value["claims"].pop()
    assert check_value(value, case)[0] == 0


@pytest.mark.parametrize("name", ["R", "O"])
def test_a_thin_operand_may_not_touch(check_value: Any, name: str) -> None:
    """It may pass in the interior of the other, along a seam of its pieces."""
    case = {**walls.CASE, name: walls.polygons([["0", "0"], ["1", "0"]])}
    value = walls.certificate()
    value["case"]["sha256"] = walls.digest_of_case(case)
    value["steps"][name == "O"] |= {"pieces": [[0, 1]], "groups": []}
    code, said = check_value(value, case)
    assert (code, "a point or a segment" in said) == (MALFORMED, True), said


def forbidden(thin: list[list[str]], told: Any, code: list[int], hit: Any) -> dict[str, Any]:
    """A part that is a point or a segment, with a path through the walls."""
    value = walls.certificate()
    pieces = {**walls.PIECES[0], "pieces": [list(range(len(thin)))]}
    clear = walls.clear(told[0], [[1, 0], [-1, 0], [0, 1], [0, -1]], code, contact="forbidden")
    value["steps"] = [pieces, walls.PIECES[1], clear]
    value["claims"] = [
        walls.free(told[0], 2, "forbidden"), walls.hit(told[1], 0, hit, "forbidden"),
        {"claim": "valid", "contact": "forbidden", "scales": scales("0", None, "()"),
         "valid": [told[0]], "claims": [0, 1]},
    ]  # fmt: skip
    return value


def test_a_thin_operand_that_may_not_touch_is_held_apart_strictly(check_value: Any) -> None:
    """The segment from (1/2, 0) to (1, 0): it touches the first wall from the scale 1 on."""
    thin = [["1", "0"], ["1/2", "0"]]
    case = {**walls.CASE, "R": walls.polygons(thin)}
    told = scales("0", "1", "()"), scales("1", None, "[)")
    value = forbidden(thin, told, [-2, 1, 1], [["0", "1", ["1", "0"]], ["0", "2", ["2", "0"]]])
    value["case"]["sha256"] = walls.digest_of_case(case)
    value["claims"][1]["scales"] = scales("1", "2", "[]")
    value["claims"].pop()
    code, said = check_value(value, case)
    assert code == 0, said
    for point in (["21/10", "0"], ["9/10", "0"], ["2", "1/10"]):  # not on the segment
        value["claims"][1]["hits"][0]["points"][1][2] = point
        code, said = check_value(value, case)
        assert (code, "not in its piece" in said) == (REFUTED, True), said
    value["claims"].pop()
    for spoilt in (scales("0", "1", "(]"), scales("0", "2", "()")):
        value["steps"][2]["scales"] = value["claims"][0]["scales"] = spoilt
        code, said = check_value(value, case)
        assert (code, "ends too early" in said) == (REFUTED, True), said


def test_a_segment_without_length_is_a_point(check_value: Any) -> None:
    """It collides where it is, and nowhere else: its edges have no directions."""
    thin = [["1", "0"], ["1", "0"]]
    case = {**walls.CASE, "R": walls.polygons(thin)}
    for point, verdict in ((["2", "0"], 0), (["3", "1/2"], REFUTED), (["2", "1/2"], REFUTED)):
        value = walls.certificate()
        value["case"]["sha256"] = walls.digest_of_case(case)
        value["steps"] = [{**walls.PIECES[0], "pieces": [[0, 1]]}, walls.PIECES[1]]
        told = scales("2", "2", "[]")
        value["claims"] = [walls.hit(told, 0, [["0", "2", point]], "forbidden")]
        code, said = check_value(value, case)
        assert code == verdict, said


def test_an_empty_set_collides_nowhere(check_value: Any) -> None:
    case = {**walls.CASE, "O": {"polygons": []}}
    value = walls.certificate()
    every = scales("0", None, "()")
    value["case"]["sha256"] = walls.digest_of_case(case)
    value["steps"] = [walls.PIECES[0], {**walls.PIECES[1], "pieces": [], "groups": []},
                      walls.clear(every, [], [])]  # fmt: skip
    value["claims"] = [walls.free(every, 2)]
    assert check_value(value, case)[0] == 0
    value["steps"][2]["codes"] = [[-1]]
    assert check_value(value, case)[0] == REFUTED


def test_a_cell_is_cut_in_the_middle_of_its_places(check_value: Any) -> None:
    """A way around a corner of the wall is clear in halves: -3 puts the earlier half on top."""
    case = {**walls.CASE, "O": walls.polygons(walls.box(1, 0, 4, 1)),
            "path": [["-4", "-2"], ["0", "-2"]]}  # fmt: skip
    value = walls.certificate()
    value["case"]["sha256"] = walls.digest_of_case(case)
    told = scales("0", "1", "(]")
    normals = [[-1, 0], [0, -1]]
    pieces = {**walls.PIECES[1], "pieces": [[0, 1, 2, 3]], "groups": []}
    for code, verdict in (([-3, 0, 1], 0), ([-3, 1, 0], REFUTED), ([-3, 0, 0], REFUTED), ([1], 0)):
        value["steps"] = [walls.PIECES[0], pieces, walls.clear(told, normals, code)]
        value["claims"] = [walls.free(told, 2)]
        got, said = check_value(value, case)
        assert got == verdict, (code, said)
