"""Families of invalid meshes: each member is refused for the named reason, and the damage is its
only fault.

Laws: the code is the family's, and a good message holds the place; a command exits with 2 and
writes nothing; a member depends on seed and number alone; the body before the damage is convex.
"""

from __future__ import annotations

import json
from functools import cache
from pathlib import Path
from random import Random

import pytest
from minkref import _core
from minkref.cli.cli import run
from minkref.degeneracies.invalid.catalogue import INVALID_MESH_FAMILIES, invalid_member
from minkref.degeneracies.invalid.commands import left_out
from minkref.degeneracies.invalid.member import Invalid
from minkref.degeneracies.invalid.mesh_sheet import FORMS, MESH, body, sheet
from minkref.errors import Refusal, refusal_text
from minkref.fuzz.space.hull import is_convex
from minkref.space.operand import read_space_operand
from thoroughness import THOROUGH, draws

SEED = 31
COUNT = draws(8, 30)
FEW = draws(1, 3)  # for each of the commands
DOCUMENTED = Path(__file__).parents[2] / "docs" / "formats.md"
COMMANDS = {
    "sum": ("sum", "P", "Q", "-o", "it.json"),
    "convolution": ("convolution", "P", "Q", "-o", "it.json"),
    "sweep": ("sweep", "P", "Q", "--scales", "scales.txt", "-o", "it"),
}
#: Each family with each command; with one of them in turn, where few are drawn.
ASKED = [
    (name, command)
    for place, name in enumerate(INVALID_MESH_FAMILIES)
    for other, command in enumerate(COMMANDS)
    if THOROUGH
    or place % len(COMMANDS) == other
    or INVALID_MESH_FAMILIES[name].code == "not-convex"
]
FEW_FORMS = {"empty-file": draws(2, 3), "too-deep": 3}  # different members


@cache
def members(name: str) -> list[Invalid]:
    return [invalid_member(INVALID_MESH_FAMILIES[name], SEED, k) for k in range(COUNT)]


def written(member: Invalid, folder: Path) -> Path:
    path = folder / member.file_name
    path.write_bytes(member.content)
    return path


def test_there_is_a_family_for_each_documented_refusal() -> None:
    """Checks the table of polyhedra, except limits of a million faces, and four further codes."""
    text = DOCUMENTED.read_text(encoding="utf-8")
    rows = text[text.index("its first byte. Refusals have\nthe codes below, or:") :]
    table = [row for row in rows[: rows.index("## Refusals")].splitlines() if row.startswith("| `")]
    codes = {word for row in table for word in row.split("|")[1].split("`")[1::2]}
    drawn = {family.code for family in INVALID_MESH_FAMILIES.values()}
    assert codes - drawn == {"too-many-faces", "too-many-face-corners"}
    assert {"not-convex", "truncated", "not-a-number", "syntax"} <= drawn - codes


@pytest.mark.parametrize("name", INVALID_MESH_FAMILIES)
def test_a_family_has_its_name_its_page_and_many_members(name: str) -> None:
    family = INVALID_MESH_FAMILIES[name]
    assert name == family.name and name.startswith(MESH)
    assert len(family.why) > 100
    assert all((m.family, m.code) == (name, family.code) for m in members(name))
    assert all(m.place and m.operand in "PQ" for m in members(name))
    wanted = FEW_FORMS.get(name.removeprefix(MESH), COUNT // 2)
    assert len({m.content for m in members(name)}) >= wanted


@pytest.mark.parametrize("name", INVALID_MESH_FAMILIES)
def test_the_reader_refuses_and_names_the_place(name: str, tmp_path: Path) -> None:
    for k, member in enumerate(members(name)):
        with pytest.raises(Refusal) as refused:
            read_space_operand(str(written(member, tmp_path)))
        text = refusal_text(refused.value.document())
        assert refused.value.code == member.code, f"{name}:{SEED}:{k} {text}"
        assert refused.value.mend
        assert not left_out(member, text), f"{name}:{SEED}:{k} {text}"


@pytest.mark.parametrize(("name", "command"), ASKED)
def test_every_command_refuses_and_writes_nothing(
    name: str, command: str, tmp_path: Path, capsys: pytest.CaptureFixture[str]
) -> None:
    for k, member in enumerate(members(name)[:FEW]):
        operands = {member.operand: str(written(member, tmp_path))}
        words = [operands.get(w, "gs3") if w in "PQ" else w for w in COMMANDS[command]]
        words = [str(tmp_path / w) if w.startswith(("it", "scales")) else w for w in words]
        (tmp_path / "scales.txt").write_text("1,2,3\n", encoding="utf-8")
        before = sorted(tmp_path.rglob("*"))
        code = run([*words, "--json"])
        out, err = capsys.readouterr()
        where = f"{name}:{SEED}:{k} {words} {err}"
        if command == "sum" and member.code == "not-convex":  # it takes polyhedra of any shape
            assert code == 0 and json.loads(out)["facets"] > 0, where
            (tmp_path / "it.json").unlink()
            continue
        assert code == 2, where
        # a damaged JSON may not be known for a mesh
        if not member.file_name.endswith(".json"):
            assert json.loads(out)["error"]["code"] == member.code, where
            assert not left_out(member, err), where
        assert sorted(tmp_path.rglob("*")) == before, where


def test_without_damage_the_mesh_is_taken() -> None:
    dice = Random(f"undamaged {SEED}")
    seen = set()
    for k in range(draws(60, 200)):
        mesh = body(dice, 3 + k % 2)
        page = sheet(dice, mesh)
        assert is_convex(mesh) and mesh.fault() is None
        read, warnings = _core.read_mesh_text(page.text().encode(), page.form, page.name)
        taken = _core.ConvexPolyhedron(read, page.name)
        assert not warnings and taken.vertices == len(mesh.vertices)
        seen.add(page.form)
    assert seen == set(FORMS)
