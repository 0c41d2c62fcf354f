"""Ways out that move with the scale: both checkers take true ones and refuse false ones; the
producer proves traps whose doors just shut, and stops where it finds no proof."""

from __future__ import annotations

import time
from fractions import Fraction
from functools import reduce
from operator import getitem
from pathlib import Path
from typing import Any

import minkref
import pytest
import walls
from minkref.certify.motion import moving_ways, trap_cover
from minkref.certify.motion.moving_cells import Linear, Station, moving, steady
from minkref.certify.motion.path_certificate import PathCertificate
from minkref.certify.motion.scale_cells import document
from minkref.certify.plane.certificate import NoProof
from minkref.fuzz.judges.motion.trap_cases import KINDS, trap_case
from walls import scales

SEED = 46
REFUTED, MALFORMED = 1, 2
SQUARE = minkref.PolygonSet([(0, 0), (1, 0), (1, 1), (0, 1)])
ROOM = minkref.PolygonSet(
    [(-2, -2), (6, -2), (6, 0), (5, 0), (5, -1), (-1, -1), (-1, 5), (5, 5), (5, 1), (6, 1), (6, 6),
     (-2, 6)]
)  # fmt: skip


def test_a_way_that_moves_is_verified(check_value: Any) -> None:
    code, said = check_value(walls.door(), walls.DOOR_CASE)
    assert (code, "escapes: at (0, 1), contact forbidden" in said) == (0, True), said


def told(low: str, high: str | None, is_in: str) -> list[tuple[list[Any], Any]]:
    value = scales(low, high, is_in)
    return [(["steps", 2, "scales"], value), (["claims", 0, "scales"], value)]


PATH = ["steps", 2, "path"]


@pytest.mark.parametrize(
    ("changes", "code", "why"),
    [
        (told("0", "1", "(]"), REFUTED, "ends too early"),  # it touches where the door shuts
        (told("0", "3/2", "()"), REFUTED, "turns"),  # the first segment would point down
        (told("0", None, "()"), REFUTED, "turns"),
        (told("1/2", "1", "[)"), 0, ""),
        ([([*PATH, 0], ["-2", "1", "0", "0"])], REFUTED, "begins elsewhere|turns"),
        ([([*PATH, 0], ["-2", "0", "0", "0"])], 0, ""),  # it stays
        ([([*PATH, 1], ["-2", "1", "1/2", "-1/2"])], REFUTED, "turns"),
        ([([*PATH, 1], ["-2", "0", "1/2"])], MALFORMED, "entries"),
        ([([*PATH, 1], ["-2"])], MALFORMED, "entries"),
        ([([*PATH, 1], ["-2", "0", "1/2", "-1/2", "0"])], MALFORMED, "entries"),
        ([(PATH, [])], MALFORMED, "no place"),
        ([([*PATH, 2], ["2", "0", "1/2", "-1/3"])], REFUTED, "turns"),
        ([([*PATH, 2], ["-3", "0", "1/2", "-1/2"])], REFUTED, "not beyond"),
        ([([*PATH, 1, 2], "1/4"), ([*PATH, 2, 2], "1/4")], REFUTED, "ends too early|turns"),
        ([([*PATH, k, 3], "-1/3") for k in (1, 2)], REFUTED, "ends too early"),
        ([([*PATH, k, 3], "-1") for k in (1, 2)], REFUTED, "ends too early|turns"),
        ([([*PATH, 2, 1], "-3/2")], REFUTED, "not beyond|ends too early|turns"),
        ([(["steps", 2, "codes"], [[0], [-2, -3, 1, 1, 2]])], 0, ""),  # cut in the middle
        ([(["claims", 0, "contact"], "allowed")], REFUTED, "another contact"),
    ],
)  # fmt: skip
def test_a_false_way_is_not(
    check_value: Any, changes: list[tuple[list[Any], Any]], code: int, why: str
) -> None:
    value = walls.door()
    for (*way, last), new in changes:
        reduce(getitem, way, value)[last] = new
    got, said = check_value(value, walls.DOOR_CASE)
    assert got == code, said
    assert any(part in said for part in why.split("|")), said


def proven(certificate: PathCertificate, folder: Path, check: Any) -> None:
    (folder / "it.case.json").write_text(certificate.case(), encoding="utf-8")
    file = folder / "it.cert.json"
    file.write_text(certificate.text("it.case.json"), encoding="utf-8")
    code, said = check(file)
    assert code == 0, said


@pytest.mark.parametrize("contact", ["allowed", "forbidden"])
@pytest.mark.parametrize(
    ("part", "obstacles", "at", "end"),
    [
        (SQUARE, ROOM, (2, 2), "1"),  # at a door of its width
        (SQUARE.translated("2", "3"), ROOM, ("1/2", 0), "1"),  # its origin is far off
        (ROOM.translated("1", "1"), SQUARE.translated("2", "2"), (0, 0), "1/2"),  # the room grows
        (minkref.PolygonSet([(3, 0), (4, 2)]), ROOM, (-1, 0), None),  # a segment
    ],
)
def test_what_gets_out_until_a_door_shuts_is_proven(
    tmp_path: Path, check: Any, part: Any, obstacles: Any, at: Any, end: str | None, contact: str
) -> None:
    certificate = PathCertificate(part, obstacles, [at])
    if not part.is_region and contact == "allowed":
        with pytest.raises(NoProof, match="seam"):
            certificate.trap(contact)
        return
    certificate.trap(contact)
    found = minkref.trapped_scales(part, obstacles, at, contact)
    assert certificate.claims[-1]["trapped"] == [document(one) for one in found.ranges]
    assert end is None or found.smallest == Fraction(end)
    assert len(certificate.claims) < 10
    proven(certificate, tmp_path, check)


@pytest.mark.parametrize("index", range(len(KINDS)))
def test_a_room_of_each_kind_is_proven(tmp_path: Path, check: Any, index: int) -> None:
    case = trap_case(SEED, index)
    certificate = PathCertificate(case.part, case.obstacles, [case.at])
    certificate.trap("forbidden")
    proven(certificate, tmp_path, check)


def test_a_search_without_end_is_refused_and_says_how_far(monkeypatch: pytest.MonkeyPatch) -> None:
    """Without ways that move there are more and more that stay, shorter and shorter."""
    monkeypatch.setattr(moving_ways.MovingWays, "up_to", lambda *_: None)
    monkeypatch.setattr(moving_ways.MovingWays, "on_from", lambda *_: None)
    monkeypatch.setattr(trap_cover, "MOST_CLAIMS", 6)
    certificate = PathCertificate(SQUARE, ROOM, [(2, 2)])
    with pytest.raises(NoProof, match="at all scales just below 1, in 20 s") as refused:
        certificate.trap("forbidden")
    assert refused.value.mend is not None
    most = refused.value.mend.split()[2].rstrip(",")
    assert refused.value.mend.startswith("give --to") and len(most) < 12
    again = PathCertificate(SQUARE, ROOM, [(2, 2)])
    again.trap("forbidden", to_scale=most)
    assert again.claims[-1]["trapped"] == []


def test_a_search_ends_in_its_time(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(trap_cover, "SECONDS", 0.0)
    began = time.process_time()
    with pytest.raises(NoProof, match="above 0") as refused:
        PathCertificate(SQUARE, ROOM, [(2, 2)]).trap("forbidden")
    assert time.process_time() - began < 5
    assert refused.value.mend == "leave out --certify"


def test_numbers_that_meet_last_are_neighbours() -> None:
    """Takes 0, s, 2 - s and 3 - 2s: going down from 2, they first meet at 3/2, then at 1."""
    numbers = [Linear(Fraction(a), Fraction(b)) for a, b in ((0, 0), (0, 1), (2, -1), (3, -2))]
    assert steady(numbers, Fraction(0), Fraction(2), True) == (Fraction(3, 2), 2)
    assert steady(numbers, Fraction(0), Fraction(2), False) == (0, 1)
    assert steady(numbers, Fraction(0), None, True) == (2, None)
    assert steady(numbers[:1], Fraction(0), None, True) == (0, None)


def test_a_segment_that_would_turn_leads_through_one_more_place() -> None:
    places = [(Fraction(x), Fraction(y)) for x, y in ((0, 0), (1, 1), (3, 0), (3, 5))]
    start, end = Station(places[0], places[1], False), Station(places[2], places[3], True)
    path = moving([start, end], Fraction(1), Fraction(2))
    assert [(x + u, y + v) for x, u, y, v in path] == [places[0], places[2], places[2]]
    assert [(x + 2 * u, y + 2 * v) for x, u, y, v in path] == [places[1], places[1], places[3]]
