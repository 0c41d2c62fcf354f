"""A true certificate written by hand is verified; each rule refuses a false one."""

from __future__ import annotations

import json
from collections.abc import Callable
from typing import Any

import pytest
import squares

Spoil = Callable[[dict[str, Any]], object]
REFUTED, MALFORMED = 1, 2
POINT = {"claim": "point", "scale": "1", "point": ["3/2", "1"], "p": ["1", "1/2"],
         "q": ["1/2", "1/2"], "by": [0, 1], "pieces": [0, 0]}  # fmt: skip
OUTSIDE = {"claim": "outside", "scale": "1", "point": ["21/10", "1"], "by": [0, 1],
           "normals": [[1, 0]], "code": [0]}  # fmt: skip
TURN = ["orientation", [[0, 0], [1, 0], [2, 0]]]
SIGN = {"claim": "sign", "of": TURN, "from": "1/2", "to": "2", "sign": 1}


def test_a_true_one_is_verified(check_value: Any) -> None:
    value = squares.certificate()
    value["claims"][0]["polygons"] = squares.SUM
    value["claims"] += [POINT, OUTSIDE, SIGN]
    code, said = check_value(value, squares.CASE)
    assert code == 0, said


def step(n: int, member: str, value: Any) -> Spoil:
    return lambda c: c["steps"][n].__setitem__(member, value)


def entry(n: int, member: str, at: int, value: Any) -> Spoil:
    return lambda c: c["steps"][n][member].__setitem__(at, value)


def claim(member: str, value: Any) -> Spoil:
    return lambda c: c["claims"][0].__setitem__(member, value)


def another(value: dict[str, Any]) -> Spoil:
    return lambda c: c["claims"].append(value)


@pytest.mark.parametrize(
    ("spoil", "code", "why"),
    [
        (step(0, "pieces", [[0, 1, 2]]), REFUTED, "do not add up to P"),
        (step(0, "pieces", [[0, 1, 2, 3], [0, 1, 2], [2, 1, 0]]), REFUTED, "not convex"),
        (step(0, "pieces", [[0, 1, 2], [0, 2, 3]]), REFUTED, "does not hold all pieces"),
        (step(0, "pieces", [[0, 1, 2, 4]]), MALFORMED, "no number 4"),
        (step(0, "groups", [[1]]), MALFORMED, "no number 1"),
        (step(0, "of", "Q"), MALFORMED, "not of P and Q"),
        (entry(2, "proofs", 1, ["cov", 0, 0]), REFUTED, "is not in the sum"),
        (entry(2, "proofs", 0, ["sep", 0]), REFUTED, "does not separate"),
        (entry(2, "proofs", 1, ["sep", 1]), REFUTED, "does not separate"),
        (entry(2, "proofs", 1, ["sep"]), REFUTED, "ends too early"),
        (entry(2, "proofs", 1, ["sep", 0, 0]), REFUTED, "goes on after its end"),
        (entry(2, "proofs", 1, ["sep", -1]), REFUTED, "splits a piece"),
        (entry(2, "normals", 0, [0, 0]), MALFORMED, "a normal is zero"),
        (entry(2, "cells", 0, [8, 9, 10]), REFUTED, "no cell on its other side"),
        (entry(2, "cells", 0, [8, 11, 10, 9]), REFUTED, "not convex"),
        (entry(2, "cells", 1, [12, 13, 9, 9, 8]), REFUTED, "without length"),
        (lambda c: (c["steps"][2]["cells"].pop(), c["steps"][2]["proofs"].pop()), REFUTED, "side"),
        (step(2, "box", ["-1", "-1", "2", "3"]), REFUTED, ""),
        (entry(2, "elements", 4, ["meet", 7, 5]), REFUTED, "parallel"),
        (entry(2, "elements", 1, ["P", 1, 2, 0]), REFUTED, ""),
        (entry(2, "elements", 1, ["P", 1, 1, 1]), REFUTED, "no direction"),
        (entry(2, "elements", 1, ["P", 1, 1, 4]), MALFORMED, "no number 4"),
        (entry(2, "elements", 8, ["meet", 0, 99]), MALFORMED, ""),
        (step(2, "polygons", [[[11, 10, 9, 8]]]), REFUTED, "not on the boundary"),
        (entry(2, "elements", 8, []), MALFORMED, "a list is empty"),
        (entry(2, "proofs", 0, []), MALFORMED, "a list is empty"),
        (step(2, "contacts", [[]]), MALFORMED, "a list is empty"),
        (step(2, "polygons", []), REFUTED, "not the boundary"),
        (step(2, "polygons", [[]]), MALFORMED, "no ring"),
        (step(2, "scales", ["1", "2"]), MALFORMED, ""),
        (step(2, "scales", ["2"]), REFUTED, ""),
        (step(2, "comment", "?"), MALFORMED, "more members"),
        (claim("holes", 1), REFUTED, "components or holes"),
        (claim("components", 2), REFUTED, "components or holes"),
        (claim("components", True), MALFORMED, "no integer" ),
        (claim("digest", "0" * 64), REFUTED, "the digest is another"),
        (claim("scale", "2"), REFUTED, "another scale"),
        (claim("scale", "-1"), MALFORMED, "not positive"),
        (claim("polygons", []), REFUTED, "the polygons are others"),
        (claim("step", 1), MALFORMED, ""),
        (lambda c: c["claims"].clear(), MALFORMED, "nothing is claimed"),
        (lambda c: c["steps"].append(squares.PIECES), MALFORMED, "not used"),
        (lambda c: c["case"].__setitem__("sha256", "0" * 64), REFUTED, "not the case"),
        (another(POINT | {"point": ["3", "1"]}), REFUTED, "s p + q is another"),
        (another(POINT | {"p": ["2", "1/2"], "point": ["5/2", "1"]}), REFUTED, "not in"),
        (lambda c: (c["steps"][0].update(pieces=[[0, 1, 2], [0, 2, 3]], groups=[[0, 1]]),
                    entry(2, "proofs", 0, ["cov", 2, 0])(c),
                    another(POINT | {"pieces": [2, 0]})(c)), MALFORMED, "no number 2"),
        (another(OUTSIDE | {"point": ["2", "1"]}), REFUTED, "does not separate"),
        (another(OUTSIDE | {"point": ["1", "1"]}), REFUTED, "does not separate"),
        (another(OUTSIDE | {"scale": "2"}), REFUTED, "does not separate"),
        (another(OUTSIDE | {"normals": [[-1, 0]]}), REFUTED, "does not separate"),
        (another(OUTSIDE | {"normals": [[0, 0]]}), MALFORMED, "a normal is zero"),
        (another(OUTSIDE | {"normals": [["1/2", 0]]}), MALFORMED, ""),
        (another(OUTSIDE | {"code": []}), REFUTED, "ends too early"),
        (another(OUTSIDE | {"code": [0, 0]}), REFUTED, "goes on after its end"),
        (another(OUTSIDE | {"code": [-1]}), REFUTED, "splits a piece"),
        (another(OUTSIDE | {"code": [1]}), MALFORMED, "no number 1"),
        (another(OUTSIDE | {"by": [1, 0]}), MALFORMED, "not of P and Q"),
        (another(OUTSIDE | {"by": [0, 2]}), MALFORMED, ""),
        (another(SIGN | {"sign": -1}), REFUTED, "sign"),
        (another(SIGN | {"sign": 0}), REFUTED, "sign"),
        (another(SIGN | {"of": ["area", []]}), MALFORMED, "predicate"),
        (another({"claim": "passage", "scale": "1", "step": 2, "points": [["2", "0"]],
                  "path": [9]}), REFUTED, "no contact"),
        (lambda c: (c["steps"][2]["contacts"].append([[9], 0]), another({
            "claim": "passage", "scale": "1", "step": 2, "points": [["2", "0"]], "path": [9]
            })(c)), REFUTED, "not inside"),
        (another({"claim": "passage", "scale": "1", "step": 2, "points": [["1", "0"]],
                  "path": [9]}), REFUTED, "other points"),
        (another({"claim": "event", "scale": "1", "kind": "boundary", "before": 0, "at": 0,
                  "after": 0}), MALFORMED, "another kind"),
        (another({"claim": "truth"}), MALFORMED, "no claim"),
    ],
)  # fmt: skip
def test_a_false_one_is_not(expect_refused: Any, spoil: Spoil, code: int, why: str) -> None:
    expect_refused(squares.certificate(), squares.CASE, spoil, code, why)


def test_a_case_that_has_changed_is_refused(check_value: Any) -> None:
    outer = [["0", "0"], ["1", "0"], ["1", "1"], ["1/1208925819614629174706176", "1"]]
    case = {"P": {"polygons": [{"outer": outer}]}, "Q": squares.SQUARE}
    code, said = check_value(squares.certificate(), case)
    assert (code, "not the case" in said) == (REFUTED, True)


def test_numbers_of_a_case_may_be_written_otherwise(check_value: Any) -> None:
    outer = [[0, 0], ["1.0", "0"], ["2/2", 1], ["0", "10e-1"]]
    case = {"P": {"polygons": [{"outer": outer, "holes": []}]}, "Q": squares.SQUARE, "title": "?"}
    assert check_value(squares.certificate(), case)[0] == 0


def test_a_true_move_is_verified(check_value: Any) -> None:
    """Alone; and with a scale between two moves."""
    value = squares.moving_certificate()
    assert check_value(value, squares.CASE)[0] == 0
    value["steps"].append(squares.BEFORE)
    value["claims"][1] |= {"from": "1/2", "steps": [4, 2, 3]}
    code, said = check_value(value, squares.CASE)
    assert code == 0, said


def interval(member: str, value: Any) -> Spoil:
    return lambda c: c["claims"][1].__setitem__(member, value)


def before(c: dict[str, Any]) -> None:
    """An interval that ends at 1, as claim 2."""
    c["steps"].append(squares.BEFORE)
    c["claims"].append({**squares.INTERVAL, "from": "1/2", "to": "1", "steps": [4]})


EVENT = {"claim": "event", "scale": "1", "kind": "boundary", "before": 2, "at": 0, "after": 1}


@pytest.mark.parametrize(
    ("spoil", "code", "why"),
    [
        (step(3, "scales", ["2", "1"]), MALFORMED, "do not ascend"),
        (step(3, "scales", ["1", "1"]), MALFORMED, "do not ascend"),
        (step(3, "box", ["-1", "-1", "3", "4"]), REFUTED, ""),
        (entry(3, "elements", 1, ["P", 1, 2, 0]), REFUTED, ""),
        (entry(3, "elements", 4 + 3, ["meet", 0, 6]), REFUTED, ""),
        (entry(3, "cells", 0, squares.MOVE["cells"][1]), REFUTED, "two cells have the edge"),
        (entry(3, "proofs", 4, ["sep", 0]), REFUTED, "does not separate"),
        (entry(3, "proofs", 5, ["cov", 0, 0]), REFUTED, "is not in the sum"),
        (step(3, "polygons", [squares.MOVE["polygons"][0][0][::-1]]), MALFORMED, ""),
        (step(3, "polygons", [[squares.MOVE["polygons"][0][0][::-1]]]), REFUTED, "boundary"),
        (lambda c: c["steps"][3].update(cells=squares.EQ["cells"], proofs=squares.EQ["proofs"],
                                        elements=squares.EQ["elements"]), REFUTED, "that turns"),
        (interval("to", "3"), REFUTED, "end to end"),
        (interval("from", "1/2"), REFUTED, "end to end"),
        (interval("steps", [3, 3]), MALFORMED, "scales between"),
        (interval("steps", [2]), MALFORMED, "scales between"),
        (interval("steps", []), MALFORMED, "scales between"),
        (interval("holes", 1), REFUTED, "components or holes"),
        (interval("digest", squares.CLAIM["digest"]), REFUTED, "the digest is another"),
        (lambda c: (before(c), another(EVENT)(c)), REFUTED, "nothing changes"),
        (lambda c: (before(c), another(EVENT | {"kind": "topology"})(c)), REFUTED, "nothing"),
        (lambda c: (before(c), another(EVENT | {"scale": "2"})(c)), REFUTED, "not at one scale"),
        (lambda c: (before(c), another(EVENT | {"before": 1, "after": 2})(c)), REFUTED, "scale"),
        (lambda c: (before(c), another(EVENT | {"kind": "end"})(c)), MALFORMED, "no event"),
    ],
)  # fmt: skip
def test_a_false_move_is_not(expect_refused: Any, spoil: Spoil, code: int, why: str) -> None:
    expect_refused(squares.moving_certificate(), squares.CASE, spoil, code, why)


SEAM = [["0", "0"], ["2", "0"], ["2", "1"], ["2", "2"], ["0", "2"], ["0", "1"]]


@pytest.mark.parametrize("thin", [[["0", "0"]], [["0", "0"], ["1", "0"]]])
def test_a_seam_is_no_passage_where_an_operand_is_thin(check_value: Any, thin: Any) -> None:
    """A square in two pieces moved by a point: the seam touches both, and is inside."""
    case = {"P": {"polygons": [{"outer": thin}]}, "Q": {"polygons": [{"outer": SEAM}]}}
    wide = str(2 + len(thin) - 1)
    value = squares.certificate()
    value["case"]["sha256"] = squares.digest_of_case(case)
    pieces = {
        "rule": "pieces",
        "of": "Q",
        "pieces": [[0, 1, 2, 5], [5, 2, 3, 4]],
        "groups": [[0, 1]],
    }
    value["steps"][:2] = [{**squares.PIECES, "pieces": [list(range(len(thin)))]}, pieces]
    value["steps"][2] |= {
        "box": ["-1", "-1", "4", "4"],
        "elements": [
            ["Q", 0, 1, 0], ["Q", 1, 2, len(thin) - 1], ["Q", 3, 4, 0], ["Q", 4, 0, 0],
            ["Q", 5, 2, 0], *(["meet", a, b] for a, b in (
                (7, 4), (4, 5), (5, 8), (5, 6), (6, 7), (7, 8), (0, 1), (1, 2), (2, 3), (3, 0))),
        ],
        "cells": [[9, 10, 11, 14], [14, 11, 12, 13], [15, 16, 10, 9], [16, 17, 12, 11, 10],
                  [17, 18, 13, 12], [18, 15, 9, 14, 13]],
        "proofs": [["cov", 0, 0], ["cov", 0, 1], ["sep", 0], ["sep", 1], ["sep", 2], ["sep", 3]],
        "contacts": [[[14, 11], -2, 2, 0]],
        "polygons": [[[9, 10, 11, 12, 13, 14]]],
    }  # fmt: skip
    corners = [["0", "0"], [wide, "0"], [wide, "2"], ["0", "2"]]
    value["claims"][0]["digest"] = squares.digest_of_polygons([{"holes": [], "outer": corners}])
    code, said = check_value(value, case)
    assert code == 0, said
    points = [["0", "1"], [wide, "1"]]
    another({"claim": "passage", "scale": "1", "step": 2, "points": points, "path": [14, 11]})(
        value
    )
    code, said = check_value(value, case)
    assert (code, "a point or a segment" in said) == (MALFORMED, True), said


@pytest.mark.parametrize("box", [["0", "0", "0", "0"], ["1", "0", "-1", "2"]])
def test_the_box_of_an_empty_sum_is_a_box(check_value: Any, box: Any) -> None:
    """Without one there would be no cells, and as many holes as one likes to say."""
    value = squares.certificate()
    case = {"P": {"polygons": []}, "Q": squares.SQUARE}
    value["case"]["sha256"] = squares.digest_of_case(case)
    empty: dict[str, Any] = {
        name: [] for name in squares.EQ if name not in ("rule", "scales", "by")
    }
    value["steps"][0] |= {"pieces": []}
    value["steps"][2] |= empty | {"box": box}
    for holes in (-1, 0, 2**64 - 1):
        value["claims"][0] |= {"components": 0, "holes": holes}
        code, said = check_value(value, case)
        assert (code, "the box is empty" in said) == (REFUTED, True), said


def test_rings_run_as_in_a_case(check_value: Any) -> None:
    """A hole that is turned would be filled."""
    hole = [["1/4", "1/4"], ["1/2", "1/4"], ["1/2", "1/2"]]
    case = {"P": {"polygons": [{**squares.SQUARE["polygons"][0], "holes": [hole]}]},
            "Q": squares.SQUARE}  # fmt: skip
    value = squares.certificate()
    value["case"]["sha256"] = squares.digest_of_case(case)
    code, said = check_value(value, case)
    assert (code, "the wrong way" in said) == (MALFORMED, True)


@pytest.mark.parametrize(
    ("text", "code"), [('"\\u0063laims"', 0), ('"\\ud83dlaims"', 2), ('"claims", "x": 1.0', 2)]
)
def test_names_may_be_escaped(check: Any, tmp_path: Any, text: str, code: int) -> None:
    (tmp_path / "case.json").write_text(json.dumps(squares.CASE), encoding="utf-8")
    written = json.dumps(squares.certificate()).replace('"claims"', text, 1)
    if "1.0" in text:
        written = json.dumps(squares.certificate()).replace('"claims"', '"comment": 1.0, "claims"')
    (tmp_path / "it.cert.json").write_text(written, encoding="utf-8")
    assert check(tmp_path / "it.cert.json")[0] == code


@pytest.mark.parametrize(
    ("number", "code"),
    [("1e0", 0), ("+1.", 0), ("1E1000", 1), ("1e1001", 2), ("1/0", 2), ("0x1", 2), (".", 2),
     ("\u0661", 2), ("1" * 70_000, 1), ("1" * 100_001, 2), ("1/" + "3" * 60_000, 1), ("", 2)],
)  # fmt: skip
def test_numbers(check_value: Any, number: str, code: int) -> None:
    value = squares.certificate()
    value["claims"][0]["scale"] = number
    assert check_value(value, squares.CASE)[0] == code


@pytest.mark.parametrize("encoding", ["utf-8-sig", "utf-16", "latin-1"])
def test_other_encodings_are_malformed(check: Any, tmp_path: Any, encoding: str) -> None:
    (tmp_path / "case.json").write_text(json.dumps(squares.CASE), encoding="utf-8")
    value = {**squares.certificate(), "title": "\u00e9"}
    text = json.dumps(value, ensure_ascii=False)
    (tmp_path / "it.cert.json").write_text(text, encoding=encoding)
    assert check(tmp_path / "it.cert.json")[0] == MALFORMED
