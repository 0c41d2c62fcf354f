"""The general solutions: a new derivation gives the stored solutions, and they solve the
contact."""

from __future__ import annotations

import json
import random
from pathlib import Path

import pytest
import sympy as sp
from minkref.oracle.symbolic import derive_plane, solutions
from thoroughness import THOROUGH, draws

KINDS = ("SS", "ST", "TS", "TT")


@pytest.fixture(scope="module")
def kept() -> dict[str, dict[str, object]]:
    return solutions.read()


def test_some_solutions_are_derived_again(kept: dict[str, dict[str, object]]) -> None:
    found = derive_plane.solutions()
    assert found and found.items() <= kept.items()


@pytest.mark.thorough
def test_deleted_solutions_are_derived_again(tmp_path: Path) -> None:
    """Derives all solutions, unlike test_some_solutions_are_derived_again."""
    again = tmp_path / "solutions.json"
    solutions.write(solutions.derive(), again)
    assert again.read_bytes() == solutions.FILE.read_bytes()


def test_solutions_of_other_code_are_refused(tmp_path: Path) -> None:
    stale = json.loads(solutions.FILE.read_text())
    stale["code"] = "0" * 64
    path = tmp_path / "solutions.json"
    path.write_text(json.dumps(stale))
    with pytest.raises(solutions.SolutionsError, match="symbolic derive"):
        solutions.read(path)
    with pytest.raises(solutions.SolutionsError, match="symbolic derive"):
        solutions.read(tmp_path / "absent.json")


@pytest.mark.parametrize("text", ["__import__('os')", "a0.real", "a0 / 2", "x", "2.5 * a0"])
def test_only_integer_polynomials_are_compiled(text: str) -> None:
    with pytest.raises(solutions.SolutionsError):
        solutions.compiled([text], ["a0"])


@pytest.mark.parametrize(
    ("kinds", "condition"),
    [
        (kinds, condition)
        for i, kinds in enumerate(KINDS)
        for j, condition in enumerate(derive_plane.CONDITIONS)
        if THOROUGH or (i + j) % 2 == 0
    ],
)
def test_solved_conditions_satisfy_the_definition(
    kept: dict[str, dict[str, object]], kinds: str, condition: str
) -> None:
    """X(s, t) - Y(s, u) vanishes identically once the scale and the other unknown are put in."""
    found = kept[f"pair {kinds} {condition}"]
    other = found["other"]
    assert isinstance(other, dict)
    s = derive_plane.s
    names = {str(x): x for letter in "ab" for x in derive_plane.data_symbols(letter)} | {"s": s}

    def read(text: object) -> sp.Expr:
        return sp.sympify(text, locals=names)

    scale = read(found["numerator"]) / read(found["denominator"])
    unknown = read(other["numerator"]) / read(other["denominator"])
    fixed = sp.Integer(condition[2])
    t, u = (fixed, unknown) if condition[0] == "t" else (unknown, fixed)
    A, B = derive_plane.data_symbols("a"), derive_plane.data_symbols("b")
    gap = derive_plane.moving_point(kinds[0], A, t) - derive_plane.moving_point(kinds[1], B, u)
    # Two data stay free: the identity holds between rational functions in them.
    rng = random.Random(kinds + condition)
    for _ in range(draws(1, 2)):
        some = {x: sp.Integer(rng.randint(-(10**6), 10**6)) for x in (*A, *B[:4])}
        for component in gap:
            assert sp.cancel(sp.together(component.subs(s, scale).subs(some))) == 0


def test_all_plane_conditions_are_linear_in_s(kept: dict[str, dict[str, object]]) -> None:
    plane = {n: x for n, x in kept.items() if n.split()[0] in ("pair", "ends", "triple")}
    assert len(plane) == 16 + 16 + 4
    assert {x["degree"] for x in plane.values()} == {1}
    # Two S-edges: all of s P is a factor of the condition, and has no positive root.
    assert kept["pair SS t=0"]["power_of_s"] == 1
