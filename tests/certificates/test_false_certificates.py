"""A true certificate written by hand is verified; each rule refuses a false one."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
import squares

Spoil = Callable[[dict[str, Any]], object]
REFUTED, MALFORMED = 1, 2
POINT = {"claim": "point", "scale": "1", "point": ["3/2", "1"], "p": ["1", "1/2"],
         "q": ["1/2", "1/2"], "by": [0, 1], "pieces": [0, 0]}  # fmt: skip
TURN = ["orientation", [[0, 0], [1, 0], [2, 0]]]
SIGN = {"claim": "sign", "of": TURN, "from": "1/2", "to": "2", "sign": 1}


def test_a_true_one_is_verified(check_value: Any) -> None:
    value = squares.certificate()
    value["claims"][0]["polygons"] = squares.SUM
    value["claims"] += [POINT, SIGN]
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
def test_a_false_one_is_not(check_value: Any, spoil: Spoil, code: int, why: str) -> None:
    value = squares.certificate()
    spoil(value)
    got, said = check_value(value, squares.CASE)
    assert got == code, said
    assert why in said


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
        (interval("to", "3"), REFUTED, "from end to end"),
        (interval("from", "1/2"), REFUTED, "from end to end"),
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
def test_a_false_move_is_not(check_value: Any, spoil: Spoil, code: int, why: str) -> None:
    value = squares.moving_certificate()
    spoil(value)
    got, said = check_value(value, squares.CASE)
    assert got == code, said
    assert why in said
