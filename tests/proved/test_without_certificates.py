"""Points, sums and sets that are combined, by the extracted programs, without certificates: they
answer like the reference, and take no operand that is not legal."""

from __future__ import annotations

import json
import random
import subprocess
from collections.abc import Callable
from typing import Any

import jsonschema
import pytest
from minkref import _core, proved_program
from minkref.cli.cli import run
from minkref.exact import digest
from minkref.fuzz.judges import checks
from minkref.fuzz.judges.plane import proved_sums
from minkref.fuzz.judges.plane.slow_points import points_of
from minkref.fuzz.plane.families.catalogue import FAMILIES
from minkref.fuzz.verdicts.verdict import Verdict
from minkref.reports.evidence.proved_checker import legality
from minkref.schemas import schema
from named_cases import named

pytestmark = pytest.mark.usefixtures("proved")
SEED = 1131
Ask = Callable[..., tuple[int, Any]]
Ring = list[tuple[int, int]]
SQUARE: Ring = [(0, 0), (4, 0), (4, 4), (0, 4)]
HOLE: Ring = [(1, 1), (1, 3), (3, 3), (3, 1)]
TWICE: Ring = [(0, 0), (6, 0), (6, 6), (0, 6), (1, 1), (5, 1), (5, 5), (-1, 7), (-1, -1)]
BOW: Ring = [(0, 0), (4, 0), (2, 2), (4, 4), (0, 4), (2, 2)]


@pytest.fixture
def ask(proved: list[str]) -> Ask:
    """Exit code and JSON of the program alone, of a question as a value."""

    def call(verb: str, question: dict[str, Any], *options: str) -> tuple[int, Any]:
        command = [*proved, verb, "--json", *options, "-"]
        ran = subprocess.run(command, input=json.dumps(question), capture_output=True, text=True)
        assert ran.stderr == "", ran.stderr
        return ran.returncode, json.loads(ran.stdout)

    return call


def operand(*polygons: tuple[Ring, ...]) -> dict[str, Any]:
    def ring(given: Ring) -> list[list[str]]:
        return [[str(x), str(y)] for x, y in given]

    return {
        "polygons": [
            {"outer": ring(outer), "holes": [ring(hole) for hole in holes]}
            for outer, *holes in polygons
        ]
    }


ORIGIN = operand(([(0, 0)],))


@pytest.mark.parametrize("family", FAMILIES)
def test_points_and_sums_are_those_of_the_reference(family: str) -> None:
    case = named(f"{family}:{SEED}:0")
    if case.vertex_pairs > 400 or not case.is_uniform:
        return
    points = [(str(x), str(y)) for x, y in points_of(case)]
    if points:
        found = proved_program.points(case.P_json, case.Q_json, case.scale, points)
        contacts = [_core.decide(case.P, case.Q, case.scale, *x)["contact"] for x in points]
        assert found == [contact != "empty" for contact in contacts], (case.name.text, points)
    if case.vertex_pairs <= 150 and (case.P.is_region or case.Q.is_region):
        ours = _core.minkowski_sum(case.P, case.Q, case.scale)
        theirs = proved_program.whole_sum(case.P_json, case.Q_json, case.scale)
        assert theirs["digest"] == digest(ours.region.canonical_json()), case.name.text
        assert (theirs["components"], theirs["holes"]) == (ours.components, ours.holes)


@pytest.mark.parametrize(
    ("what", "set"),
    [
        ("a ring that crosses itself", operand(([(0, 0), (4, 0), (0, 3), (4, 4)],))),
        ("a vertex twice in a row", operand(([(0, 0), (4, 0), (4, 0), (0, 4)],))),
        ("a spike", operand(([(0, 0), (4, 0), (6, 0), (4, 0), (0, 4)],))),
        ("two polygons that cross", operand((SQUARE,), ([(2, 2), (6, 2), (6, 6), (2, 6)],))),
        ("polygons that share an edge", operand((SQUARE,), ([(4, 0), (8, 0), (8, 4), (4, 4)],))),
        ("a polygon twice", operand((SQUARE,), (SQUARE,))),
        ("a polygon within another", operand((SQUARE,), (HOLE[::-1],))),
        ("a hole twice", operand((SQUARE, HOLE, HOLE))),
        ("a hole within a hole", operand((SQUARE, HOLE, [(2, 2), (2, 3), (3, 2)]))),
        ("a hole outside", operand(([(9, 0), (10, 0), (10, 1)], HOLE))),
        ("a ring that winds twice", operand((TWICE,))),
        ("a segment that is a point", operand(([(1, 1), (1, 1)],))),
        ("a ring that touches itself", operand((BOW,))),
    ],
)  # fmt: skip
@pytest.mark.parametrize("first", [True, False])
def test_no_illegal_operand_is_taken(ask: Ask, what: str, set: dict[str, Any], first: bool) -> None:
    P, Q = (set, ORIGIN) if first else (ORIGIN, set)
    code, said = ask("--points", {"P": P, "Q": Q, "scale": "1", "points": [["1", "1"]]})
    assert (code, said["verdict"]) == (2, "malformed") and "points" not in said, (what, said)
    code, said = ask("--sum", {"P": P, "Q": Q, "scale": "1"})
    assert (code, said["verdict"]) == (2, "malformed") and "polygons" not in said, (what, said)
    sets = [set, operand((SQUARE,))][:: 1 if first else -1]
    code, said = ask("--combination", {"operation": "union", "sets": sets})
    assert (code, said["verdict"]) == (2, "malformed") and "polygons" not in said, (what, said)
    assert f"set {0 if first else 1} " in said["why"]


def test_legal_is_what_the_reference_finds_legal(ask: Ask) -> None:
    """Random rings on a small lattice, outer ones and holes."""
    dice = random.Random(SEED)
    legal = refused = 0
    for _ in range(120):
        polygons = []
        for _ in range(dice.choice((1, 1, 2))):
            count = dice.choice((1, 1, 2))
            rings = [_turned(dice, sign) for sign in (1, -1)[:count]]
            polygons.append(tuple(rings))
        set = operand(*polygons)
        try:
            _core.read_text(json.dumps(set), "json", "a test").validate("a test", False)
            is_legal = True
        except _core.BadInput:
            is_legal = False
        question = {"P": set, "Q": ORIGIN, "scale": "1", "points": [["1", "1"]]}
        is_taken = ask("--points", question)[0] == 0
        assert is_taken == is_legal, (SEED, set)
        legal += is_legal
        refused += not is_taken
    assert legal >= 20 and refused >= 20


@pytest.mark.parametrize("takes", [True, False])
def test_the_evidence_finds_a_program_that_takes_or_refuses_all(
    monkeypatch: pytest.MonkeyPatch, takes: bool
) -> None:
    said = {"verdict": "computed", "polygons": []} if takes else {"verdict": "malformed"}
    monkeypatch.setattr(legality, "answers", lambda verb, asked: [said for _ in asked])
    found = legality.judge([*(("lists", k) for k in range(40)), ("invalid", 3)])
    legal = found["tally"]["legal"]
    assert legal >= 10
    assert len(found["faults"]) == (41 if takes else legal)


def _turned(dice: random.Random, sign: int) -> Ring:
    """A ring of three to five points with an area of this sign."""
    while True:
        ring = [(dice.randrange(5), dice.randrange(5)) for _ in range(dice.choice((3, 3, 4, 5)))]
        pairs = zip(ring, [*ring[1:], ring[0]], strict=True)
        area = sum(a * d - b * c for (a, b), (c, d) in pairs)
        if area:
            return ring if area * sign > 0 else ring[::-1]


def test_the_command_says_what_is_proved_and_what_is_trusted(capsys: Any) -> None:
    words = [
        "point",
        "g1",
        "LINESTRING (0 0, 1 1)",
        "--scale",
        "2,1/3",
        "--at",
        "1/2,1",
        "--proved",
    ]
    assert run([*words, "--at", "1e9,0", "--json"]) == 0
    value = json.loads(capsys.readouterr().out)
    jsonschema.validate(value, schema("point"))
    assert [row["in_sum"] for row in value["points"]] == [True, False]
    assert value["points"][0]["point"] == ["1/2", "1"] and value["points"][0]["p"] is None
    assert value["proof"]["proved"] and len(value["proof"]["trusted"]) == 2
    assert run(words) == 0
    said = capsys.readouterr().out
    assert "in the sum" in said and "proved" in said and said.count("trusted") == 2


def test_the_route(capsys: Any) -> None:
    P = "POLYGON((0 0,1 0,1 1,0 0))"
    Q = "POLYGON((0 0,9 0,10 7,0 8,0 0),(3 2,9 3,1 1,9 7,3 2))"
    digests = []
    for route in ("proved", "paper"):
        assert run(["sum", P, Q, "--scale", "7/12", "--route", route, "--json"]) == 0
        value = json.loads(capsys.readouterr().out)
        jsonschema.validate(value, schema("sum"))
        assert value["route"] == route
        digests.append((value["digest"], value["holes"], len(value["tight_passages"])))
    assert digests[0] == digests[1]


OPERATIONS = ("union", "intersection", "difference")


def test_sets_are_combined_as_by_the_reference() -> None:
    """Polygons on a small lattice, where edges overlap and vertices are in common, and holes."""
    dice = random.Random(SEED)
    seen = {"holes": 0, "components": 0, "empty": 0}
    for _ in range(40):
        sets = [_drawn_set(dice) for _ in range(dice.choice((1, 2, 2, 3)))]
        for operation in OPERATIONS:
            region, components, holes = _core.combined(operation, sets)
            theirs = proved_program.combination(operation, [each.to_json() for each in sets])
            ours = (digest(region.canonical_json()), components, holes)
            found = (theirs["digest"], theirs["components"], theirs["holes"])
            assert found == ours, (SEED, operation, [each.to_json() for each in sets])
            seen["holes"] += holes > 0
            seen["components"] += components > 1
            seen["empty"] += components == 0
    assert min(seen.values()) >= 3, seen


def _drawn_set(dice: random.Random) -> _core.PolygonSet:
    """A union, or a set without others, of one to five triangles and quadrilaterals."""
    parts: list[_core.PolygonSet] = []
    count = dice.choice((1, 3, 5))
    while len(parts) < count:
        text = json.dumps(operand((_turned(dice, 1),)))
        part = _core.read_text(text, "json", "a test")
        try:
            part.validate("a test")
        except _core.BadInput:
            continue
        parts.append(part)
    return _core.combined(dice.choice(("union", "difference")), parts)[0]


@pytest.mark.parametrize("operation", OPERATIONS)
def test_the_commands_combine_by_the_program(operation: str, capsys: Any) -> None:
    """Parcels that share an edge too, which the program unites first."""
    parcels = "MULTIPOLYGON (((0 0, 1 0, 1 1, 0 1, 0 0)), ((1 0, 2 0, 2 1, 1 1, 1 0)))"
    words = [operation, parcels, "POLYGON ((1/2 0, 3 1/3, 1/2 1/2, 1/2 0))"]
    values = []
    for proved in ([], ["--proved"]):
        assert run([*words, *proved, "--json"]) == 0
        values.append(json.loads(capsys.readouterr().out))
        jsonschema.validate(values[-1], schema(operation))
        assert values[-1]["operands"][0]["united"] is True
    assert values[0]["digest"] == values[1]["digest"]
    assert values[0]["proof"] is None and len(values[1]["proof"]["trusted"]) == 2
    assert run([*words, "--proved"]) == 0
    said = capsys.readouterr().out
    assert "proved" in said and said.count("trusted") == 2


def test_two_points_or_segments_have_no_theorem(ask: Ask, capsys: Any) -> None:
    segment = operand(([(0, 0), (1, 2)],))
    code, said = ask("--sum", {"P": segment, "Q": ORIGIN, "scale": "1"})
    assert (code, said["verdict"]) == (5, "declined") and "polygons" not in said
    words = ("sum", "LINESTRING (0 0, 1 1)", "POINT (1 1)", "--route", "proved")
    assert run(words) == 2
    assert "no theorem" in capsys.readouterr().err


def test_limits_and_questions_that_are_none(ask: Ask, proved: list[str]) -> None:
    question = {"P": operand((SQUARE,)), "Q": operand((SQUARE,)), "scale": "1"}
    assert ask("--points", {**question, "points": [["1", "1"]]}, "--tests=0")[0] == 4
    assert ask("--sum", question, "--seconds=0")[0] == 4
    for verb, other in (
        ("--points", question),
        ("--points", {**question, "points": []}),
        ("--points", {**question, "points": [["1", "1/0"]]}),
        ("--sum", {**question, "points": [["1", "1"]]}),
        ("--sum", {**question, "scale": "0"}),
        ("--sum", {**question, "scale": ["1", "-1"]}),
        ("--sum", {**question, "other": 1}),
    ):
        assert ask(verb, other)[0] == 2, (verb, other)
    combining: dict[str, Any] = {"operation": "union", "sets": [operand((SQUARE,))]}
    assert ask("--combination", combining, "--tests=0")[0] == 4
    assert ask("--combination", combining, "--seconds=0")[0] == 4
    for wrong in (question, {**combining, "operation": "sum"}, {**combining, "sets": []}):
        assert ask("--combination", wrong)[0] == 2, wrong
    for words in (
        ["--points", "--sum"],
        ["--combination", "--sum"],
        ["--sum", "--full"],
        ["--points", "--theorem=it.v"],
    ):
        ran = subprocess.run([*proved, *words, "-"], input="{}", capture_output=True, text=True)
        assert ran.returncode == 2 and ran.stderr.startswith("usage:"), words


def test_the_judge_finds_a_wrong_sum_and_a_wrong_decision(monkeypatch: pytest.MonkeyPatch) -> None:
    """With a witness that the proved program decides."""
    case = named(f"holes:{SEED}:1")
    assert checks.Check("minkref@proved-sums").rule(case).verdict is Verdict.PASS
    true_sum, decide = _core.minkowski_sum, _core.decide
    monkeypatch.setattr(_core, "minkowski_sum", lambda P, Q, s, *more: true_sum(P, P, s, *more))
    ruling = proved_sums.judge(case)
    assert ruling.messages and ruling.witness is not None
    assert ruling.witness.in_truth == (ruling.witness.p is not None)
    monkeypatch.setattr(_core, "minkowski_sum", true_sum)
    monkeypatch.setattr(
        _core, "decide", lambda P, Q, s, x, y: {**decide(P, Q, s, x, y), "contact": "empty"}
    )
    assert any("is in the sum" in message for message in proved_sums.judge(case).messages)
