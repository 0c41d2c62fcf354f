"""The canonical form: the same set in another form is refused, by what Coq computes."""

from __future__ import annotations

import re
import shutil
import subprocess
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import pytest
from minkref import _core
from minkref.certify.plane.certificate import Certificate
from minkref.reports.evidence.certificates.certified_cases import written
from minkref.reports.evidence.certificates.checkers import ROOT

# A frame with two holes, and a square in the first; a frame with two holes that touch.
TWO = (
    "MULTIPOLYGON(((0 0, 9 0, 9 9, 0 9, 0 0), (1 1, 1 8, 4 8, 4 1, 1 1), "
    "(5 1, 5 8, 8 8, 8 1, 5 1)), ((2 2, 3 2, 3 3, 2 3, 2 2)))"
)
TOUCHING = (
    "POLYGON((0 0, 4 0, 4 4, 0 4, 0 0), (1 1, 1 2, 2 2, 2 1, 1 1), (2 2, 2 3, 3 3, 3 2, 2 2))"
)
USED = "From Proved Require Import Numbers Checker Figures.\n"
# Polygons as [outer, holes], and for each ring its rows of stretches
Form = tuple[list[Any], list[Any]]


def as_it_is(polygons: list[Any], rows: list[Any]) -> Form:
    return polygons, rows


def from_another_vertex(polygons: list[Any], rows: list[Any]) -> Form:
    outer = polygons[0][0]
    outer.append(outer.pop(0))
    rows[0][0].append(rows[0][0].pop(0))
    return polygons, rows


def with_a_straight_vertex(polygons: list[Any], rows: list[Any]) -> Form:
    row = next(row for row in rows[0][0] if len(row) > 1)
    at = rows[0][0].index(row)
    polygons[0][0].insert(at + 1, row[0][2].vertex)
    rows[0][0][at : at + 1] = [row[:1], row[1:]]
    return polygons, rows


def with_holes_swapped(polygons: list[Any], rows: list[Any]) -> Form:
    polygons[0][1].reverse()
    rows[0][1:] = rows[0][:0:-1]
    return polygons, rows


def with_a_hole_as_the_outer_ring(polygons: list[Any], rows: list[Any]) -> Form:
    outer, holes = polygons[0]
    polygons[0] = [holes[0], [outer, *holes[1:]]]
    rows[0][:2] = rows[0][1::-1]
    return polygons, rows


def with_a_hole_in_the_other_polygon(polygons: list[Any], rows: list[Any]) -> Form:
    polygons[1][1].append(polygons[0][1].pop())
    rows[1].append(rows[0].pop())
    return polygons, rows


def with_both_holes_in_one_ring(polygons: list[Any], rows: list[Any]) -> Form:
    """It passes the point where they touch, the second's first vertex, twice."""
    first, second = polygons[0][1]
    at = first.index(second[0])
    polygons[0][1] = [first[:at] + second + first[at:]]
    rows[0][1:] = [rows[0][1][:at] + rows[0][2] + rows[0][1][at:]]
    return polygons, rows


def with_a_stretch_less(polygons: list[Any], rows: list[Any]) -> Form:
    rows[0][0][0].pop()
    return polygons, rows


def with_cells_exchanged(polygons: list[Any], rows: list[Any]) -> Form:
    row = rows[0][0][0]
    row[0] = (row[0][1], row[0][0], row[0][2])
    return polygons, rows


@dataclass(frozen=True)
class Corner:
    """A vertex as the checker has it"""

    vertex: tuple[str, str]


def in_coq(value: Any) -> str:
    if isinstance(value, Corner):
        return f"fixed {in_coq(value.vertex)}"
    if isinstance(value, list):
        return f"[{'; '.join(map(in_coq, value))}]"
    if isinstance(value, tuple):
        return f"({', '.join(map(in_coq, value))})"
    return str(value) if isinstance(value, str) else f"{value}%nat"


def definitions_of(theorem: str) -> str:
    """What a theorem's statement and its proof name, as definitions."""
    stated, _, proof = theorem.partition("Proof.")
    found = re.findall(r"^  let (\S+)((?: : [^\n]*)?) :=\s(.*?) in$", stated, re.DOTALL | re.M)
    posed = re.findall(r"^pose \((\S+) :=\s(.*?)( : [^\n]*)\)\.$", proof, re.DOTALL | re.M)
    found += [(name, kind, value) for name, value, kind in posed]
    return "".join(f"Definition {name}{kind} :=\n{value}.\n" for name, kind, value in found)


def from_coq(text: str, name: str) -> Any:
    """A definition of the file of Coq as lists and tuples, with fractions as texts."""
    found = re.search(rf"Definition {name} : [^\n]* :=\n(.*?)\.\n", text, re.DOTALL)
    assert found is not None
    plain = re.sub(r"(\(-\d+\)|\d+)#(\d+)", r"'\1#\2'", found[1]).replace("%nat", "")
    names = {"__builtins__": {}, "fixed": lambda x, y: Corner((x, y))}
    return eval(plain.replace(";", ","), names)


@pytest.mark.parametrize(
    ("P", "change", "is_taken"),
    [
        (TWO, as_it_is, True),
        (TOUCHING, as_it_is, True),
        (TWO, from_another_vertex, False),
        (TWO, with_a_straight_vertex, False),
        (TWO, with_holes_swapped, False),
        (TWO, with_a_hole_as_the_outer_ring, False),
        (TWO, with_a_hole_in_the_other_polygon, False),
        (TOUCHING, with_both_holes_in_one_ring, False),
        (TWO, with_a_stretch_less, False),
        (TWO, with_cells_exchanged, False),
    ],
)
def test_other_forms_of_a_set(
    proved: list[str], tmp_path: Path, P: str, change: Callable[..., Form], is_taken: bool
) -> None:
    """The rings are still those of the sum, which is proved; but they are not its form."""
    coqc = shutil.which("coqc")
    if coqc is None or not (ROOT / "build" / "proofs" / "Canonical.vo").exists():
        pytest.skip("coqc or the compiled proofs are absent: make proofs")
    operands = (_core.read_text(text, "wkt", "a test") for text in (P, "POINT(0 0)"))
    certificate = Certificate(*operands)
    certificate.sum("1")
    theorem = tmp_path / "it.v"
    subprocess.run(
        [*proved, f"--theorem={theorem}", str(written(certificate, tmp_path, "it"))],
        check=True, stdout=subprocess.DEVNULL,
    )  # fmt: skip
    head, _, rest = theorem.read_text(encoding="utf-8").partition("Theorem this_is_the_sum")
    text = head + USED + definitions_of(rest)
    polygons = [list(each) for each in from_coq(text, "R'")]
    changed, rows = change(polygons, from_coq(text, "rows"))
    text += f"""
Definition other : list (polygon vertex) := {in_coq([tuple(each) for each in changed])}.
Definition others : list (list (list (list stretch))) := {in_coq(rows)}.
Definition given : derivation := {{|
  region_of := proof_of_region; components_of := components; outside_of := outside;
  holes_of := holes; rows_of := others |}}.
Eval vm_compute in check_holes (Fixed s) (fixed_rings P) (fixed_rings Q')
  (fixed_rings (rings_of other)) proof_of_region components outside holes.
Eval vm_compute in check_form s P Q' other given.
"""
    theorem.write_text(text, encoding="utf-8")
    ran = subprocess.run(
        [coqc, "-q", "-Q", str(ROOT / "build" / "proofs"), "Proved", "it.v"],
        cwd=tmp_path, capture_output=True, text=True,
    )  # fmt: skip
    assert ran.returncode == 0, ran.stderr
    assert re.findall(r"= (true|false)", ran.stdout) == ["true", str(is_taken).lower()]
