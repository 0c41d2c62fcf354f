"""`minkref point P Q --at X,Y`: whether points are in the sum, exact."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

from minkref import _core, proved_program
from minkref.cli.memory import SIMPLER, memory_wall
from minkref.cli.output import print_lines
from minkref.errors import Refusal, refusing
from minkref.exact import read_point
from minkref.file_text import LONGEST, decoded, text_of_file
from minkref.output.documents import Stopwatch, as_text, document
from minkref.output.terminal import escaped
from minkref.plane.operand import Operand, read_operand
from minkref.plane.operand_text import STANDARD_INPUT
from minkref.plane.scaling import PlaneScale, document_of, shown_scale, text_of
from minkref.verbs.point import PointsInPlane

SHOWN = 20  # points that people see
#: The theorem `decided_points_are_right`, and all that it does not speak about (docs/proved.md).
PROVED = "where the program answers about points, it says yes exactly of those in the sum"
TRUSTED = (
    "that the program was asked about these operands, this scale and these points",
    proved_program.BELIEVED,
)
CONTACTS = {"empty": "not in it", "touching": "the sets touch", "overlapping": "the interiors meet"}


def run(request: PointsInPlane) -> None:
    P, Q = request.P, request.Q
    given = [P, Q, *([str(request.points)] if request.points else [])]
    if given.count(STANDARD_INPUT) > 1:
        what = "standard input can be read for one of these"
        raise Refusal(what, "P, Q and --points", "name files for the others")
    watch = Stopwatch()
    if request.proved:
        proved_program.program()
    points = [*(request.at or ()), *_points_of(request.points)]
    if not points:
        raise Refusal("no point is asked about", "minkref point", "give --at X,Y or --points FILE")
    work = "the proved program" if request.proved else "the decision of a point"
    with memory_wall(request.memory, work, f"{P} and {Q}", SIMPLER):
        first, second = read_operand(P), read_operand(Q)
        decide = _proved if request.proved else _decided
        rows = decide(first, second, request.scale, points)
    value = document(
        "point",
        watch,
        P=first.name,
        Q=second.name,
        scale=document_of(request.scale),
        warnings=first.warnings + second.warnings,
        points=rows,
        proof={"proved": PROVED, "trusted": list(TRUSTED)} if request.proved else None,
    )
    if request.json:
        sys.stdout.write(as_text(value))
    else:
        _print(value)


def _points_of(file: Path | None) -> Iterator[tuple[str, str]]:
    if file is None:
        return
    name = escaped(str(file))
    if str(file) == STANDARD_INPUT:
        text = decoded(sys.stdin.buffer.read(LONGEST + 1), "standard input")
    else:
        text = text_of_file(file, name, "name a file with X,Y in each line")
    for number, line in enumerate(text.splitlines(), 1):
        if line.strip():
            yield read_point(line.strip(), f"{name}, line {number}:")


def _decided(
    P: Operand, Q: Operand, scale: PlaneScale, points: list[tuple[str, str]]
) -> list[dict[str, Any]]:
    """By the reference: with the contact, and p and q."""

    def decide(point: tuple[str, str]) -> dict[str, Any]:
        found = _core.decide(P.set, Q.set, text_of(scale), *point)
        row = {name: found[name] or None for name in ("contact", "p", "q")}
        return {"point": list(point), "in_sum": found["contact"] != "empty", **row}

    return refusing(f"{P.name} and {Q.name}", lambda: [decide(point) for point in points])


def _proved(
    P: Operand, Q: Operand, scale: PlaneScale, points: list[tuple[str, str]]
) -> list[dict[str, Any]]:
    answers = proved_program.points(P.set.to_json(), Q.set.to_json(), document_of(scale), points)
    nothing = dict.fromkeys(("contact", "p", "q"))
    return [
        {"point": list(point), "in_sum": is_in, **nothing}
        for point, is_in in zip(points, answers, strict=True)
    ]


def _print(value: dict[str, Any]) -> None:
    rows = [("sum", f"{shown_scale(value['scale'])} {value['P']} + {value['Q']}")]
    for row in value["points"][:SHOWN]:
        said = "in the sum" if row["in_sum"] else "not in the sum"
        if row["in_sum"] and row["contact"]:
            p, q = (f"({', '.join(row[name])})" for name in "pq")
            said += f", {CONTACTS[row['contact']]}: p = {p}, q = {q}"
        rows.append((f"({', '.join(row['point'])})", said))
    points = value["points"]
    if len(points) > SHOWN:
        rows.append(("", f"{len(points) - SHOWN:,} more with --json"))
    if len(points) > 1:
        rows.append(("in the sum", f"{sum(row['in_sum'] for row in points):,} of {len(points):,}"))
    if value["proof"] is not None:
        rows.append(("proved", value["proof"]["proved"]))
        rows += [("trusted", each) for each in value["proof"]["trusted"]]
    rows.append(("seconds", f"{value['seconds']:.3f}"))
    print_lines(rows, value)
