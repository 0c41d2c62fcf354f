"""Degenerate sums with a disc: each member keeps its family's promise, by distances computed here
from the case file alone; both routes give the expected answer."""

from __future__ import annotations

import json
from fractions import Fraction
from pathlib import Path
from typing import Any

import pytest
from members import assert_made_again, faults_of_spoilt, turn
from minkref import _core
from minkref.degeneracies import lint
from minkref.degeneracies.catalogue import ALL_FAMILIES, DISC_FAMILIES, made_member
from minkref.degeneracies.disc.case_document import DegenerateWithDisc
from minkref.degeneracies.disc.nearly import PREFIX
from minkref.degeneracies.disc.outline import DISC
from minkref.degeneracies.make_corpus import SEED as CORPUS_SEED
from minkref.disc.disc import read_disc
from minkref.exact import digest
from minkref.fuzz.geometry.plane import read_shape
from minkref.fuzz.judges.disc.disc_places import faults_of, rows_of
from minkref.reports.evidence.certificates.checkers import in_cpp, in_python, verdicts
from thoroughness import THOROUGH

SEED = 23
COUNT = 3
EXACT = [name for name in DISC_FAMILIES if not name.startswith(PREFIX)]
TWINS = [name for name in DISC_FAMILIES if name.startswith(PREFIX)]
Spot = tuple[Fraction, Fraction]
_MADE: dict[str, list[dict[str, Any]]] = {}


def cases(name: str) -> list[Path]:
    """The family's case files of the corpus."""
    files = (DISC.corpus / name).iterdir()
    return sorted(file for file in files if not file.name.endswith(".cert.json"))


def documents(name: str) -> list[dict[str, Any]]:
    """Some case documents of a family: the corpus's first if few are drawn."""
    if name not in _MADE:
        texts = [cases(name)[0].read_text(encoding="utf-8")]
        if THOROUGH:
            print(f"seed {SEED}")
            family = DISC_FAMILIES[name]
            texts = [DegenerateWithDisc.of(family, SEED, k).case_text for k in range(COUNT)]
        _MADE[name] = list(map(json.loads, texts))
    return _MADE[name]


def spot(texts: list[str]) -> Spot:
    return Fraction(texts[0]), Fraction(texts[1])


def edges(value: dict[str, Any]) -> list[tuple[Spot, Spot]]:
    found = []
    for polygon in value["P"]["polygons"]:
        for ring in (polygon["outer"], *polygon.get("holes", [])):
            spots = [spot(p) for p in ring]
            found += list(zip(spots, [*spots[1:], spots[0]], strict=True))
    return found


def nearest(value: dict[str, Any], x: Spot) -> tuple[Fraction, set[Spot]]:
    """The squared distance from P, and P's nearest points: each edge offers its ends and the foot
    of the perpendicular."""
    found: dict[Spot, Fraction] = {}
    for a, b in edges(value):
        dx, dy = b[0] - a[0], b[1] - a[1]
        part = ((x[0] - a[0]) * dx + (x[1] - a[1]) * dy) / (dx * dx + dy * dy)
        candidates = [a, b]
        if 0 < part < 1:
            candidates.append((a[0] + part * dx, a[1] + part * dy))
        for c in candidates:
            found[c] = (x[0] - c[0]) ** 2 + (x[1] - c[1]) ** 2
    least = min(found.values())
    return least, {c for c, square in found.items() if square == least}


@pytest.mark.parametrize("name", DISC_FAMILIES)
def test_what_is_nearest_is_told(name: str) -> None:
    for value in documents(name):
        for row in value["degeneracy"]["nearest"]:
            square, points = nearest(value, spot(row["place"]))
            assert Fraction(row["squared_distance"]) == square
            assert {spot(p) for p in row["points"]} == points
            assert {spot(p) for p in row["joints"]} <= points


@pytest.mark.parametrize("name", DISC_FAMILIES)
def test_sums_are_what_is_expected(name: str) -> None:
    """By both routes, at all radii; and nothing changes on either side."""
    for value in documents(name):
        P = _core.PolygonSet.from_json(json.dumps(value["P"]))
        squares = [Fraction(square) for square in value["squared_radii"]]
        assert read_disc(value["Q"]).squared_radius == squares[0]
        beside = (len(squares) - 1) // 2
        assert all(square < squares[0] for square in squares[1 : 1 + beside])
        assert all(square > squares[0] for square in squares[1 + beside :])
        rings = []
        for row in value["expected"]:
            for route in ("definition", "paper"):
                found = _core.offset(P, row["squared_radius"], 1, route)
                assert digest(found.canonical_json()) == row["digest"]
                told = (found.components, found.holes, found.curves)
                assert told == (row["components"], row["holes"], row["curves"])
            rings.append(json.loads(found.canonical_json())["components"])
        for side in (rings[1 : 1 + beside], rings[1 + beside :]):
            assert all(each == side[0] for each in side)
        counts = [(row["components"], row["holes"]) for row in value["expected"]]
        told = [tuple(each) for each in value["degeneracy"]["below_at_above"]]
        assert told == [counts[1], counts[0], counts[1 + beside]]


@pytest.mark.parametrize("name", EXACT)
def test_something_happens_at_the_radius(name: str) -> None:
    for value in documents(name):
        told = value["degeneracy"]
        at = Fraction(told["at"])
        assert told["events"]
        for row in told["nearest"]:
            assert Fraction(row["squared_distance"]) == at
            assert len(row["points"]) > 1
            x, y = (float(Fraction(c)) for c in row["place"])
            places = [event["place"] for event in told["events"]]
            size = 1 + abs(x) + abs(y)
            on_ridge = name == "disc-flat-ridge"
            assert on_ridge or any(abs(x - u) + abs(y - v) < 1e-9 * size for u, v in places)


def test_families_show_what_their_titles_say() -> None:
    def told(name: str) -> list[dict[str, Any]]:
        return [value["degeneracy"] for value in documents(name)]

    for name in ("disc-tips", "disc-walls", "disc-tips-and-walls"):
        assert all(len(each["nearest"][0]["points"]) >= 4 for each in told(name))
    for each in told("disc-tips"):
        features = max(each["events"], key=lambda event: len(event["features"]))["features"]
        assert sum(kind == "vertex" for kind, *_ in features) >= 4
    for each in told("disc-walls"):
        features = max(each["events"], key=lambda event: len(event["features"]))["features"]
        assert sum(kind == "edge" for kind, *_ in features) >= 4
    for name in ("disc-joint-at-corner", "disc-joint-at-saddle"):
        assert all(each["nearest"][0]["joints"] for each in told(name))
    for each in told("disc-flat-ridge"):
        assert any(len(points) == 2 for points in each["tight_passages"])
        assert any(event["kind"] == "ridge" for event in each["events"])
    for each in told("disc-pinches"):
        below, at, _ = each["below_at_above"]
        assert below == [2, 0] and at[0] == 2 and at[1] >= len(each["nearest"]) - 1 > 0
        assert not each["tight_passages"]


@pytest.mark.parametrize("name", ["disc-doors", "disc-edges-on-one-line"])
def test_events_are_where_and_what_a_judge_finds(name: str) -> None:
    """Births at one radius have separate doors; edges on one line have separate names."""
    for value in documents(name):
        text = json.dumps(value["P"])
        assert faults_of(read_shape(text), rows_of(_core.PolygonSet.from_json(text))) == []


def test_several_holes_are_born_at_the_radius_of_doors() -> None:
    for value in documents("disc-doors"):
        _, changes = rows_of(_core.PolygonSet.from_json(json.dumps(value["P"])))
        at = value["degeneracy"]["at"]
        places = [row["place"] for row in changes if row["squared_radius"] == at
                  for _ in row["changes"]["born"]]  # fmt: skip
        assert len(places) == len({tuple(place) for place in places}) >= 2


def test_an_edge_that_is_not_the_first_on_its_line_is_named() -> None:
    for value in documents("disc-edges-on-one-line"):
        (nearest_to,) = value["degeneracy"]["nearest"]
        x, y = (float(Fraction(c)) for c in nearest_to["place"])
        size = 1 + abs(x) + abs(y)
        (event,) = [
            event for event in value["degeneracy"]["events"]
            if abs(event["place"][0] - x) + abs(event["place"][1] - y) < 1e-9 * size
        ]  # fmt: skip
        points = {spot(p) for p in nearest_to["points"]}
        every = edges(value)
        for kind, ring, number in event["features"]:
            assert kind == "edge" and ring == "0"
            a, b = every[int(number)]
            points -= {p for p in points if is_on(p, a, b)}
        assert not points


def is_on(p: Spot, a: Spot, b: Spot) -> bool:
    u, v = (b[0] - a[0], b[1] - a[1]), (p[0] - a[0], p[1] - a[1])
    return u[0] * v[1] == u[1] * v[0] and 0 <= u[0] * v[0] + u[1] * v[1] <= u[0] ** 2 + u[1] ** 2


@pytest.mark.parametrize("name", TWINS)
def test_twins_are_nearly_so(name: str) -> None:
    """A place is no longer as far from as many points as in the family, and events are near."""
    for value in documents(name):
        told = value["degeneracy"]
        assert told["events_near"]
        at = Fraction(told["at"])
        squares = [Fraction(row["squared_distance"]) for row in told["nearest"]]
        assert all(abs(square - at) < at / 2 for square in squares)


def test_certificates_prove_sums_and_places() -> None:
    """The sum at the disc's radius, and each place as far as distances computed here say."""
    for file in (file for name in DISC_FAMILIES for file in cases(name)):
        value = json.loads(file.read_text(encoding="utf-8"))
        text = file.with_name(value["certificate"]).read_text(encoding="utf-8")
        proof, at = json.loads(text), Fraction(value["squared_radii"][0])
        total, *points = proof["claims"]
        assert (Fraction(proof["square"]), total["digest"]) == (at, value["expected"][0]["digest"])
        assert {spot(one["point"]) for one in points} == {
            spot(row["place"]) for row in value["degeneracy"]["nearest"]
        }
        for one in points:
            square, _ = nearest(value, spot(one["point"]))
            assert one["distance"] == (square > at) - (square < at), file.name


def test_both_checkers_verify_the_corpus() -> None:
    certificates = sorted(DISC.corpus.glob("*/*.cert.json"))
    assert len(certificates) == DISC.count * len(DISC_FAMILIES)
    few = certificates[:: 1 if THOROUGH else 4]
    for command in (in_python(), in_cpp()):
        assert {verdict.code for verdict in verdicts(command, few)} == {0}


@pytest.mark.parametrize("name", turn(DISC_FAMILIES, 0, 2))
def test_the_members_of_the_corpus_are_made_again(name: str) -> None:
    family, folder = DISC_FAMILIES[name], DISC.corpus / name
    assert_made_again(folder, DISC.count, lambda k: made_member(family, CORPUS_SEED, k))


def test_the_corpus_is_in_form() -> None:
    assert not list(lint.faults(DISC.corpus, again=False))
    assert {path.name for path in DISC.corpus.iterdir()} == set(DISC_FAMILIES)
    assert not set(DISC_FAMILIES) & set(ALL_FAMILIES)


def test_lint_finds_nothing_wrong_in_what_is_made(tmp_path: Path) -> None:
    made_member(DISC_FAMILIES["disc-flat-ridge"], SEED, 0).write(tmp_path)
    assert not list(lint.faults(tmp_path))


@pytest.mark.parametrize(
    ("spoil", "fault"),
    [
        (lambda v: v.pop("Q"), "'Q' is a required property"),
        (lambda v: v.__setitem__("more", 1), "Additional properties"),
        (lambda v: v["expected"][0].__setitem__("holes", 99), "expected is not what"),
        (lambda v: v["expected"].reverse(), "not each radius"),
        (lambda v: v["expected"][0].__setitem__("digest", "0" * 64), "is not certified"),
        (lambda v: v["P"]["polygons"].pop(), "the certificate of another case"),
        (lambda v: v["squared_radii"].reverse(), "id is not"),
        (lambda v: v["degeneracy"].__setitem__("tight_passages", []), "degeneracy is not what"),
        (lambda v: v["P"]["polygons"][0]["outer"].reverse(), "orientation"),
        (lambda v: v.__setitem__("source", "minkref generate nothing"), "makes nothing"),
    ],
)
def test_lint_finds_what_is_wrong(tmp_path: Path, spoil: Any, fault: str) -> None:
    family = DISC_FAMILIES["disc-flat-ridge"]
    found = faults_of_spoilt(tmp_path, family, SEED, spoil)
    assert any(fault in line for line in found), found
