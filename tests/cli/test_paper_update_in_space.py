"""`minkref sum|sweep --route paper-update` for polyhedra (Section 5): readings, arithmetics, and
the exact sum beside each answer."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any, ClassVar

import jsonschema
import pytest
from minkref import _core
from minkref.cli.progress import Steps, Tell, told_on
from minkref.schemas import schema
from minkref.space.commands.paper_update import SpaceWalk
from minkref.space.operand import read_summand
from written_solids import L, prism

Minkref = Callable[..., Any]
ROUTE = ("--route", "paper-update")
CORRECTED = (*ROUTE, "--form", "corrected")
CHOSEN = {name: value for name, _, value, _ in _core.space_update_readings()}

#: A tetrahedron none of whose sides is parallel to a face of the angle.
SLANTED = """OFF
4 4 0
0 0 0
3.1 1.2 1.7
0.9 4.3 1.1
-1.3 0.8 5.2
3 0 2 1
3 0 1 3
3 1 2 3
3 2 0 3
"""


@pytest.fixture
def solids(tmp_path: Path) -> tuple[str, str]:
    for name, text in (("slanted.off", SLANTED), ("angle.off", prism(L))):
        (tmp_path / name).write_text(text, encoding="utf-8")
    return str(tmp_path / "slanted.off"), str(tmp_path / "angle.off")


def test_all_corrected_in_rational_numbers_it_is_the_exact_sum(
    minkref: Minkref, solids: tuple[str, str]
) -> None:
    value = minkref("sum", *solids, "--scale", "2/3", *CORRECTED, "--json").json
    jsonschema.validate(value, schema("sum"))
    assert value["route"] == "paper-update"
    assert value["paper"]["exact"] == {"same_structure": True, "ulps": 0, "witness": None}
    exact = minkref("sum", *solids, "--scale", "2/3", "--json").json
    assert exact["paper"] is None
    assert value["digest"] == exact["digest"]
    assert value["paper"]["crossings"] > 0 and value["paper"]["events"] > 0


def test_in_doubles_the_corners_are_a_little_off(minkref: Minkref, solids: tuple[str, str]) -> None:
    options = (*CORRECTED, "--scale", "2/3", "--arithmetic", "double")
    found = minkref("sum", *solids, *options, "--json").json["paper"]["exact"]
    assert found["same_structure"] and 0 < found["ulps"] < 100
    assert "the same structure, up to" in minkref("sum", *solids, *options).out


def test_a_sweep_goes_up_and_down(
    minkref: Minkref, solids: tuple[str, str], tmp_path: Path
) -> None:
    scales = tmp_path / "scales.txt"
    scales.write_text("1\n3\n1/5\n3\n", encoding="utf-8")
    options = ("--scales", scales, *CORRECTED, "--arithmetic", "mpfr:100")
    value = minkref("sweep", *solids, *options, "--json").json
    jsonschema.validate(value, schema("sweep"))
    rows = value["rows"]
    assert all(row["exact"]["same_structure"] for row in rows)
    assert rows[1]["exposed_facets"] == rows[3]["exposed_facets"]
    assert rows[1]["updated"] == rows[3]["updated"]
    assert rows[2]["insertions"] + rows[2]["deletions"] > 0
    assert "the same structure" in minkref("sweep", *solids, *options).out


def test_as_printed_a_witness_refutes_the_answer(minkref: Minkref, solids: tuple[str, str]) -> None:
    """With rounded numbers the printed text finds hardly a consistent system."""
    options = (*ROUTE, "--scale", "1/7", "--arithmetic", "mpfr:100")
    value = minkref("sum", *solids, *options, "--json").json
    assert value["paper"]["readings"]["solve"] == "printed"
    found = value["paper"]["exact"]
    assert not found["same_structure"]
    assert found["witness"] is not None
    assert "another structure: (" in minkref("sum", *solids, *options).out


@pytest.mark.parametrize(
    ("options", "told"),
    [
        (("--scale", "2,1,1", *ROUTE), "uniform scales only"),
        ((*ROUTE, "-o", "sum.off"), "no mesh to write"),
        ((*ROUTE, "--reading", "bounds=loose"), "bounds=checked|joint"),
        (("--arithmetic", "double"), "add --route paper-update"),
        (("--reading", "bounds=joint"), "add --route paper-update"),
        ((*ROUTE, "--arithmetic", "float"), "float"),
    ],
)
def test_what_it_does_not_do_is_refused(
    minkref: Minkref, solids: tuple[str, str], options: tuple[str, ...], told: str
) -> None:
    ran = minkref("sum", *solids, *options)
    assert ran.code == 2 and told in ran.err


def test_each_long_piece_of_work_is_told_to_its_end(solids: tuple[str, str]) -> None:
    reports: dict[str, list[tuple[int, int]]] = {}

    @contextmanager
    def telling(work: str) -> Iterator[Tell]:
        reports[work] = []
        yield lambda done, total: reports[work].append((done, total))

    first, second = map(read_summand, solids)
    walk = SpaceWalk(first, second, "2/3", "double", CHOSEN, telling)
    assert walk.answer()["exact"]["same_structure"]
    assert len(reports) == 3
    for work, told in reports.items():
        assert len(told) >= 2 and told[-1][0] == told[-1][1] > 0, work
        assert all(done <= total for done, total in told), work


def test_a_sweep_tells_how_much_of_a_step_is_done() -> None:
    class Line(Steps):
        texts: ClassVar[list[str]] = []

        def now(self, text: str) -> None:
            self.texts.append(text)

    with told_on(Line(None, 3))("cells") as tell:
        tell(0, 8)
        tell(3, 8)
        tell(8, 8)
    assert Line.texts == ["cells, 0 %", "cells, 37 %", "cells, 100 %"]


def test_operands_without_volume_are_refused(minkref: Minkref, tmp_path: Path) -> None:
    flat = tmp_path / "flat.off"
    flat.write_text("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n", encoding="utf-8")
    ran = minkref("sum", flat, "gs3", *ROUTE)
    assert ran.code == 2 and "faces of solids" in ran.err


def test_a_sweep_refuses_options_of_the_repair(
    minkref: Minkref, solids: tuple[str, str], tmp_path: Path
) -> None:
    scales = tmp_path / "scales.txt"
    scales.write_text("1\n2,1,1\n", encoding="utf-8")
    for options, told in (
        ((*ROUTE, "--repair", "literal"), "no such option"),
        (("--route", "dynamic"), "paper-update"),
        (ROUTE, "uniform scales only"),
    ):
        ran = minkref("sweep", *solids, "--scales", scales, *options)
        assert ran.code == 2 and told in ran.err, options
