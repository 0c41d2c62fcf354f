"""Families of invalid input: every command refuses each member, for the named reason.

Laws: a refusal has exit code 2, the family's code, and all details of a good message; commands
write nothing; the damage is the only fault, so the operand was valid before; the slow engine, which
shares no reader, refuses the same files.
"""

from __future__ import annotations

import json
from functools import cache
from pathlib import Path
from random import Random

import pytest
from members import LARGE
from minkref import BadInput, _core
from minkref.cli.cli import run
from minkref.degeneracies.invalid.catalogue import INVALID_FAMILIES, invalid_member
from minkref.degeneracies.invalid.commands import COMMANDS, left_out, words, written
from minkref.degeneracies.invalid.geometries import TYPES, WORDS
from minkref.degeneracies.invalid.member import Invalid
from minkref.degeneracies.invalid.operands import region, thin
from minkref.degeneracies.invalid.sheet import FORMS, sheet
from minkref.degeneracies.invalid.writing import of_bytes, text_of
from minkref.errors import Refusal, refusal_text
from minkref.exact import read_scale
from minkref.oracle import slow
from minkref.oracle.slow.command import main as slow_command
from minkref.oracle.slow.exact import positive
from minkref.plane.operand import read_operand
from thoroughness import THOROUGH, draws

SEED = 31
COUNT = draws(8, 30)  # of a family, read only
FEW = draws(1, 3)  # for each of the commands
OF_LARGE = draws(1, 2)
#: Families that the slow engine is asked about: it takes long over large files.
QUICK = [name for name in INVALID_FAMILIES if THOROUGH or name not in LARGE]
#: Each family with each command; with some in turn, where few are drawn.
ASKED = [
    (name, command)
    for place, name in enumerate(INVALID_FAMILIES)
    for other, command in enumerate(COMMANDS)
    if THOROUGH or (place + other) % (len(COMMANDS) if name in LARGE else 4) == 0
]
DOCUMENTED = Path(__file__).parents[2] / "docs" / "formats.md"


@cache
def members(name: str, count: int) -> list[Invalid]:
    family = INVALID_FAMILIES[name]
    return [invalid_member(family, SEED, k) for k in range(OF_LARGE if name in LARGE else count)]


def test_there_is_a_family_for_each_documented_refusal() -> None:
    absent = {
        "cannot-read", "cannot-write", "unknown-format", "not-representable", "file-too-large",
        "too-many-values",
    }  # fmt: skip
    rows = [line for line in DOCUMENTED.read_text(encoding="utf-8").splitlines() if "`" in line]
    table = [line for line in rows if line.startswith("|")]
    codes = {
        word
        for line in table[table.index(next(r for r in table if "`cannot-read`" in r)) :]
        for word in line.split("`")[1::2]
        if "-" in word or word in ("syntax", "truncated")
    } - {"formats/limits.hpp", ".poly"}
    drawn = {family.code for family in INVALID_FAMILIES.values()}
    assert codes - drawn == absent
    assert {code for code in drawn - codes if not code.startswith("scale-")} == {"limit"}


@pytest.mark.parametrize("name", INVALID_FAMILIES)
def test_a_family_has_its_name_its_page_and_many_members(name: str) -> None:
    family = INVALID_FAMILIES[name]
    assert name == family.name == f"invalid-{family.code}"
    assert len(family.why) > 100
    drawn = members(name, COUNT)
    assert all((m.family, m.code) == (name, family.code) for m in drawn)
    assert all(m.place and m.operand in ("P", "Q", "scale") for m in drawn)
    assert len({(m.content, m.scale) for m in drawn}) >= min(draws(3, 6), len(drawn))
    if name not in LARGE:
        assert len({m.file_name for m in drawn}) > 1 or drawn[0].part
        assert max(len(m.content) for m in drawn) < 3_000_000
    assert max(len(m.content) for m in drawn) < 30_000_000


def test_without_damage_both_readers_take_the_operands(tmp_path: Path) -> None:
    dice = Random(f"undamaged {SEED}")
    seen = set()
    for k in range(draws(60, 300)):
        page = sheet(dice, thin(dice) if k % 10 == 0 else region(dice))
        member = of_bytes(page, "none", text_of(dice, page).encode())
        name = written(member, tmp_path)
        vertices = read_operand(name).set.vertices
        if member.slow_reads:
            assert len(slow.read_operand(name).points()) == vertices
        seen.add(page.form)
    assert seen == set(FORMS)


@pytest.mark.parametrize("name", INVALID_FAMILIES)
def test_the_reader_refuses_and_names_the_place(name: str, tmp_path: Path) -> None:
    for k, member in enumerate(members(name, COUNT)):
        argument = written(member, tmp_path)
        with pytest.raises(Refusal) as refused:
            read_operand(argument)
            if member.scale is not None:
                read_scale(member.scale)
        text = refusal_text(refused.value.document())
        assert refused.value.code == member.code, f"{name}:{SEED}:{k} {text}"
        assert refused.value.mend
        assert not left_out(member, text), f"{name}:{SEED}:{k} {text}"


def test_no_geometry_of_the_family_is_one_that_readers_take() -> None:
    """Lines and several points became operands, and stayed among the words: a few members in a
    hundred had another reason, or none."""
    ring = "0 0, 1 0, 0 1, 0 0"
    pairs = "[[0, 0], [1, 0], [0, 1], [0, 0]]"
    texts = [("wkt", f"{word} {body}") for word in WORDS for body in (f"({ring})", f"(({ring}))")]
    texts += [
        ("geojson", f'{{"type": "{name}", "coordinates": {places}}}')
        for name in TYPES
        for places in (pairs, f"[{pairs}]")
    ]
    for form, text in texts:
        with pytest.raises(BadInput) as refused:
            _core.read_text(text, form)
        assert refused.value.code == "unsupported-geometry", text


@pytest.mark.parametrize("name", QUICK)
def test_the_slow_engine_refuses(name: str, tmp_path: Path) -> None:
    for k, member in enumerate(members(name, COUNT)):
        if member.slow_reads:
            argument = written(member, tmp_path)
            with pytest.raises(slow.InputError):
                slow.read_operand(argument)
                if member.scale is not None:
                    positive(member.scale)
                pytest.fail(f"{name}:{SEED}:{k} is taken")


@pytest.mark.parametrize(("name", "command"), ASKED)
def test_every_command_refuses_and_writes_nothing(
    name: str, command: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    for k, member in enumerate(members(name, FEW)[: 1 if name in LARGE else FEW]):
        line = words(command, member, tmp_path)
        before = sorted(tmp_path.rglob("*"))
        code = run([*line, "--json"])
        out, err = capsys.readouterr()
        where = f"{name}:{SEED}:{k} {line} {err}"
        assert code == 2, where
        error = json.loads(out)["error"]
        assert error["code"] == member.code, where
        assert not left_out(member, err), where
        assert not left_out(member, " ".join(str(part) for part in error.values())), where
        assert sorted(tmp_path.rglob("*")) == before, where


@pytest.mark.parametrize("name", QUICK)
def test_the_command_of_the_slow_engine_exits_with_two(
    name: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    for member in members(name, FEW)[: 1 if name in LARGE else FEW]:
        if member.slow_reads:
            assert slow_command(words("sum", member, tmp_path)[:4]) == 2
            out, err = capsys.readouterr()
            assert not out and err.startswith("slow: ")
            assert member.scale is not None or member.file_name in err
