"""Degenerate paths and traps: each member keeps its family's promise, decided from the case file
alone by pairs of triangles; certificates prove the expected answers."""

from __future__ import annotations

import json
from fractions import Fraction
from pathlib import Path
from typing import Any

import minkref
import pytest
from members import assert_made_again, faults_of_spoilt
from minkref.degeneracies import lint
from minkref.degeneracies.catalogue import ALL_FAMILIES, DISC_FAMILIES, PATH_FAMILIES, made_member
from minkref.degeneracies.make_corpus import SEED as CORPUS_SEED
from minkref.degeneracies.motion.case_document import DegeneratePath
from minkref.degeneracies.motion.outline import MOTION
from minkref.fuzz.judges.motion.path_traps import enclosing_ring, way_out
from minkref.fuzz.motion.path_collisions import Collisions, by_triangles
from minkref.reports.evidence.certificates.checkers import in_cpp, in_python, verdicts
from thoroughness import THOROUGH

SEED = 31
COUNT = 3
HAIR = Fraction(1, 1 << 30)
CONTACTS = ("allowed", "forbidden")
PATHS = [name for name, family in PATH_FAMILIES.items() if not family.is_trap]
TRAPS = [name for name, family in PATH_FAMILIES.items() if family.is_trap]
_MADE: dict[str, list[DegeneratePath]] = {}


def made(name: str) -> list[DegeneratePath]:
    if name not in _MADE:
        print(f"seed {SEED}")
        _MADE[name] = [DegeneratePath.of(PATH_FAMILIES[name], SEED, k) for k in range(COUNT)]
    return _MADE[name]


def values(name: str) -> list[dict[str, Any]]:
    """Case documents of a family: the corpus's first if few are drawn."""
    texts = [one.case_text for one in made(name)] if THOROUGH else [cases(name)[0].read_text()]
    return list(map(json.loads, texts))


def cases(name: str) -> list[Path]:
    """The family's case files of the corpus."""
    files = (MOTION.corpus / name).iterdir()
    return sorted(file for file in files if not file.name.endswith(".cert.json"))


class Asked:
    """Whether the part collides, at a scale, along the path or a part of it."""

    def __init__(self, value: dict[str, Any]) -> None:
        self.sets = [minkref.read_text(json.dumps(value[name]), "json") for name in "RO"]
        self.path = [(Fraction(x), Fraction(y)) for x, y in value["path"]]
        self.decide = by_triangles(*self.sets)

    def collides(self, scale: Fraction, contact: str, path: Any = None) -> bool:
        way = Collisions(*self.sets, self.path if path is None else path)
        return way.collides(scale, contact, self.decide)


def holds(ranges: list[dict[str, Any]], scale: Fraction) -> bool:
    def begins(one: dict[str, Any]) -> bool:
        low = Fraction(one["from"])
        return low < scale or (low == scale and one["from_in"])

    def ends(one: dict[str, Any]) -> bool:
        if one["to"] is None:
            return True
        return scale < Fraction(one["to"]) or (scale == Fraction(one["to"]) and one["to_in"])

    return any(begins(one) and ends(one) for one in ranges)


@pytest.mark.parametrize("name", PATHS)
def test_valid_scales_are_what_is_expected(name: str) -> None:
    """At each end, just beside it, and at the scale of the case."""
    for value in values(name):
        asked = Asked(value)
        for contact in CONTACTS:
            ranges = value["expected"]["valid"][contact]
            ends = {Fraction(one[end]) for one in ranges for end in ("from", "to") if one[end]}
            scales = {Fraction(value["degeneracy"]["at"])} | {
                end * (1 + by) for end in ends if end for by in (-HAIR, 0, HAIR)
            }
            for scale in scales:
                assert asked.collides(scale, contact) != holds(ranges, scale), (scale, contact)


@pytest.mark.parametrize("name", TRAPS)
def test_traps_are_what_is_expected(name: str) -> None:
    """Checks a ring around the place just on one side of the scale, and a way out on the other. (At
    the scale itself, which has no clearance, the certificates prove both.)"""
    for value in values(name):
        asked, s = Asked(value), Fraction(value["degeneracy"]["at"])
        expected = value["expected"]["trapped"]
        (place,) = asked.path
        held, out = s * (1 + HAIR), s * (1 - HAIR)
        if name == "trap-opens":
            held, out = out, held
        for contact in CONTACTS:
            assert holds(expected[contact], held) and not holds(expected[contact], out)
        assert [holds(expected[contact], s) for contact in CONTACTS] == [False, True]
        assert enclosing_ring(*asked.sets, place, held) is not None
        assert way_out(*asked.sets, place, out) is not None
        assert not asked.collides(s, "forbidden")


def test_families_show_what_their_titles_say() -> None:
    for value in values("path-isolated-scale"):
        at = value["degeneracy"]["at"]
        alone = {"from": at, "to": at, "from_in": True, "to_in": True}
        valid = value["expected"]["valid"]
        assert alone in valid["allowed"] and alone not in valid["forbidden"]
    for name in ("path-touches-for-an-instant", "path-along-an-edge", "path-corner-touches"):
        for value in values(name):
            asked, s = Asked(value), Fraction(value["degeneracy"]["at"])
            assert [asked.collides(s, contact) for contact in CONTACTS] == [False, True]
            ends = [asked.collides(s, "forbidden", [p]) for p in (asked.path[0], asked.path[1])]
            corner = name == "path-corner-touches"
            assert ends == {"path-along-an-edge": [True, True]}.get(name, [False, corner])
    for value in values("path-beside-its-origin"):
        assert not minkref.valid_scales(*Asked(value).sets, [(0, 0)]).star_shaped
        assert len(value["expected"]["valid"]["allowed"]) >= 3


def test_certificates_prove_what_is_expected(tmp_path: Path) -> None:
    """Takes the last case of each family from the corpus; a thorough run adds made members."""
    asked = {}
    for name, family in PATH_FAMILIES.items():
        files = cases(name)[-1:]
        if THOROUGH:
            rows = [made_member(family, SEED, k).write(tmp_path) for k in range(COUNT)]
            files += [Path(row["case"]) for row in rows]
        asked |= dict.fromkeys(files, "trapped" if family.is_trap else "valid")
    certificates = [file.with_name(f"{file.stem}.cert.json") for file in asked]
    for command in (in_python(), in_cpp()):
        found = verdicts(command, certificates)
        assert [verdict.why for verdict in found if verdict.code] == []
    for (file, what), certificate in zip(asked.items(), certificates, strict=True):
        claims = json.loads(certificate.read_text(encoding="utf-8"))["claims"]
        told = {one["contact"]: one[what] for one in claims if what in one}
        assert told == json.loads(file.read_text(encoding="utf-8"))["expected"][what]
    assert not list(lint.faults(tmp_path))


@pytest.mark.parametrize("name", PATH_FAMILIES)
def test_the_members_of_the_corpus_are_made_again(name: str) -> None:
    family, folder = PATH_FAMILIES[name], MOTION.corpus / name
    assert_made_again(folder, MOTION.count, lambda k: made_member(family, CORPUS_SEED, k))


def test_the_corpus_is_in_form() -> None:
    assert not list(lint.faults(MOTION.corpus, again=False))
    assert {path.name for path in MOTION.corpus.iterdir()} == set(PATH_FAMILIES)
    assert not set(PATH_FAMILIES) & (set(ALL_FAMILIES) | set(DISC_FAMILIES))


def test_lint_finds_nothing_wrong_in_what_is_made(tmp_path: Path) -> None:
    made_member(PATH_FAMILIES["path-isolated-scale"], SEED, 0).write(tmp_path)
    assert not list(lint.faults(tmp_path))


@pytest.mark.parametrize(
    ("spoil", "fault"),
    [
        (lambda v: v.pop("path"), "'path' is a required property"),
        (lambda v: v.__setitem__("more", 1), "Additional properties"),
        (lambda v: v["expected"]["valid"]["allowed"].pop(), "the scales are not claimed"),
        (lambda v: v["path"].append(["7", "7"]), "id is not"),
        (lambda v: v["path"].append(["7", "7"]), "the certificate of another case"),
        (lambda v: v["degeneracy"].__setitem__("at", "77"), "degeneracy is not what"),
        (lambda v: v["R"]["polygons"][0]["outer"].reverse(), "orientation"),
        (lambda v: v.__setitem__("source", "minkref generate nothing"), "makes nothing"),
        (lambda v: v.__setitem__("certificate", "no.cert.json"), "is missing"),
    ],
)
def test_lint_finds_what_is_wrong(tmp_path: Path, spoil: Any, fault: str) -> None:
    family = PATH_FAMILIES["path-isolated-scale"]
    found = faults_of_spoilt(tmp_path, family, SEED, spoil)
    assert any(fault in line for line in found), found
