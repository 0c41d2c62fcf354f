"""`minkref sum` with a disc."""

from __future__ import annotations

import json
import math
from collections.abc import Mapping, Sequence
from pathlib import Path
from typing import TYPE_CHECKING, Any

from minkref import _core
from minkref.certain_digits import between, root
from minkref.cli.memory import SIMPLER, memory_wall
from minkref.cli.output import give, print_lines, written_row
from minkref.cli.paper_words import in_words
from minkref.cli.readings import ROUTE as PAPER_UPDATE
from minkref.disc.commands.index_file import from_places
from minkref.disc.commands.indexed_sum import IndexedSum
from minkref.disc.commands.sum_proof import check_points, proved_sum
from minkref.disc.disc import Disc, is_disc, read_disc
from minkref.disc.polygons import sum_near
from minkref.errors import Refusal, refusing
from minkref.exact import digest
from minkref.output.documents import Stopwatch, document, refuse_overwriting, write_together
from minkref.output.output_target import Target, target_of
from minkref.plane.commands.scale_index import chosen_route, cores, refuse_overwriting_index
from minkref.plane.commands.sum_table import passage_rows
from minkref.plane.operand import Operand, read_operand
from minkref.verbs.proof_option import proof_document, proof_files, proof_rows
from minkref.verbs.sum import SumWithDisc

if TYPE_CHECKING:
    from minkref.verbs.erode_request import ErodeWithDisc, MorphologyWithDisc

FORMATS = ("json", "svg", "dxf", "wkt", "geojson", "poly")
WITH_ARCS = ("json", "svg", "dxf")
EXACT = "rational"
DISC_ROUTES = ("definition", "paper", "index", PAPER_UPDATE)


def run(request: SumWithDisc) -> None:
    watch = Stopwatch()
    P, Q, factor, index, output = (
        request.P, request.Q, request.scale, request.index, request.output,
    )  # fmt: skip
    route = chosen_route(index, request.route, DISC_ROUTES)
    if route == PAPER_UPDATE or request.as_read or request.reading or request.arithmetic != EXACT:
        _run_paper(request, route, watch)
        return
    if index is not None and factor != 1:
        mend = "leave out the scale, or the index"
        raise Refusal("the index is that of P as it is", f"--scale {factor}", mend)
    offered = FORMATS if request.tolerance is not None else WITH_ARCS
    target = target_of(output, request.form, FORMATS, "json", request.json, offered=offered)
    check_polygon(request, target)
    check_points(request.certify, request.points)
    if request.measures and not request.json:
        raise Refusal("the terms are in the document only", "--measures", "add --json")
    if is_disc(P) and is_disc(Q):
        raise Refusal("the sum of two discs is one", f"{P} and {Q}", "add their radii")
    disc = read_disc(P).scaled(factor) if is_disc(P) else read_disc(Q)
    with memory_wall(request.memory, "the sum with a disc", f"{P} and {Q}", SIMPLER):
        operand = read_operand(Q if is_disc(P) else P, lines=True)
        if output is not None:
            refuse_overwriting(output, [operand.file])
            refuse_overwriting_index(output, index)
        files = proof_files(request.certify, [operand.file], output)
        other = operand.set if is_disc(P) else operand.set.scaled(str(factor))
        found = _found(operand, other, str(disc.squared_radius), route, index)
        canonical = found.canonical_json()
        written, proof = None, None
        if files is not None:
            known = found.holes, canonical
            what = f"{P} and {Q}", other, disc.squared_radius
            proof = proved_sum(files, *what, known, request.points or ())
            write_together(dict(proof[0].contents()))
        if target is not None:
            written = _written(target, found, other, disc, canonical, request)
        if target is not None and written is not None and target.write(*written):
            return
        passages = found.tight_passages(cores())
        terms = found.exact_measures() if request.measures else None
    value = document(
        "sum",
        watch,
        P=P if is_disc(P) else operand.name,
        Q=Q if is_disc(Q) else operand.name,
        scale=str(factor),
        warnings=operand.warnings,
        output=str(output) if output else None,
        output_exact=written[1] if written else None,
        tolerance=None if request.tolerance is None else str(request.tolerance),
        radius=disc.radius,
        squared_radius=str(disc.squared_radius),
        route=route,
        compute_seconds=found.seconds,
        **described(found, canonical),
        tight_passages=[passage_document(*row) for row in passages],
        measures=None if terms is None else _measures(*terms),
        arithmetic=EXACT,
        readings=None,
        exact=None,
        comparison=None,
        certificate=proof_document(proof),
    )
    give(value, request.json, lambda value: _print(value, operand))


def _run_paper(request: SumWithDisc, route: str, watch: Stopwatch) -> None:
    """The answer of the Appendix's own program, with the exact sum beside it."""
    from minkref.disc.commands.paper_update import disc_readings, sum_by_paper

    P, Q = request.P, request.Q
    readings = disc_readings(route, request.arithmetic, request.as_read, request.reading)
    assert readings is not None
    target = target_of(request.output, request.form, ("json",), "json", request.json)
    for option, given in (("--tolerance", request.tolerance is not None),
                          ("--outside", request.outside), ("--measures", request.measures),
                          ("--certify", request.certify), ("--point", request.points),
                          ("--only-sum", request.only_sum)):  # fmt: skip
        if given:
            raise Refusal("that is of exact sums only", option, "leave it out")
    if is_disc(P) and is_disc(Q):
        raise Refusal("the sum of two discs is one", f"{P} and {Q}", "add their radii")
    unit = read_disc(P if is_disc(P) else Q)
    disc = unit.scaled(request.scale) if is_disc(P) else unit
    with memory_wall(request.memory, f"route {route}", f"{P} and {Q}", SIMPLER):
        operand = read_operand(Q if is_disc(P) else P)
        if request.output is not None:
            refuse_overwriting(request.output, [operand.file])
        other = operand.set if is_disc(P) else operand.set.scaled(str(request.scale))
        found, canonical = sum_by_paper(operand, other, unit, disc, request.arithmetic, readings)
        if target is not None and target.write(canonical + "\n", True):
            return
    value = document(
        "sum",
        watch,
        P=P if is_disc(P) else operand.name,
        Q=Q if is_disc(Q) else operand.name,
        scale=str(request.scale),
        warnings=operand.warnings,
        output=str(request.output) if request.output else None,
        output_exact=None if target is None else True,
        tolerance=None,
        radius=disc.radius,
        squared_radius=str(disc.squared_radius),
        route=route,
        tight_passages=None,
        measures=None,
        arithmetic=request.arithmetic,
        readings=readings,
        certificate=None,
        **found,
    )
    give(value, request.json, lambda value: _print(value, operand))


def _found(
    operand: Operand, other: _core.PolygonSet, square: str, route: str, index: Path | None
) -> _core.Offset | IndexedSum:
    """`other`: the operand, scaled."""
    if route != "index":
        return refusing(operand.name, lambda: _core.offset(other, square, cores(), route))
    built = from_places(index, operand, lambda places: _core.disc_index(other, cores(), places))
    return IndexedSum(built, other, square)


def described(found: _core.Offset | IndexedSum, canonical: str) -> dict[str, Any]:
    """The fields of a document for a sum with a disc."""
    return {
        "digest": digest(canonical),
        "components": found.components,
        "holes": found.holes,
        "curves": found.curves,
        "area": enclosed(found.area),
        "length": enclosed(found.length),
        "result": json.loads(canonical),
        "statistics": dict(found.statistics),
    }


def passage_document(
    points: Sequence[tuple[str, str]],
    near: Sequence[tuple[float, float]],
    contacts: Sequence[Sequence[str]],
) -> dict[str, Any]:
    return {
        "points": [list(point) for point in points],
        "near": [[_finite(x) for x in point] for point in near],
        "contacts": [list(curve) for curve in contacts],
    }


def term_rows(factors: Mapping[str, object]) -> list[dict[str, str]]:
    """A sum of factors times products of roots."""
    return [{"factor": str(factor), "root": root or "1"} for root, factor in factors.items()]


def _measures(
    length: dict[str, str],
    area: dict[str, str],
    angles: Sequence[tuple[tuple[str, str], tuple[str, str]]],
) -> dict[str, Any]:
    return {
        "length": term_rows(length),
        "area": term_rows(area),
        "angles": [{"from": list(start), "to": list(end)} for start, end in angles],
    }


def _finite(x: float) -> float | None:
    return x if math.isfinite(x) else None


def enclosed(bounds: tuple[float, float]) -> dict[str, float | None]:
    """Two doubles with a number between; beyond doubles: None."""
    low, high = map(_finite, bounds)
    return {"low": low, "high": high}


def check_polygon(
    request: SumWithDisc | ErodeWithDisc | MorphologyWithDisc, target: Target | None
) -> None:
    """Refuses a polygon without a tolerance, and a tolerance without a polygon."""
    given = {"--tolerance": request.tolerance is not None, "--outside": request.outside}
    if target is not None and target.form not in WITH_ARCS:
        if request.tolerance is None:
            raise Refusal(
                "this format has no arcs",
                target.name,
                "say how far a polygon may be off, as --tolerance 1/1000; .json, .svg and .dxf "
                "have arcs",
                "no-arcs",
            )
        return
    for option, is_given in given.items():
        if is_given:
            mend = "write a polygon: -o FILE.wkt, .geojson or .poly"
            raise Refusal("no arc is replaced", option, mend)


def _written(
    target: Target,
    found: _core.Offset | IndexedSum,
    other: _core.PolygonSet,
    disc: Disc,
    canonical: str,
    request: SumWithDisc,
) -> tuple[str, bool]:
    """The text of the output, and whether it is exact."""
    if target.form == "json":
        return canonical + "\n", True
    if target.form == "dxf":
        from minkref.output.dxf import dxf_text

        return dxf_text(_drawn(found), target.name), False
    if target.form == "svg":
        from minkref.offset_picture import offset_picture

        caption = f"the sum with a disc of radius {root(disc.squared_radius, 6)}"
        passages = [points for _, points, _ in found.tight_passages(cores())]
        own = None if request.only_sum else other
        return offset_picture(_drawn(found), own, caption, passages), False
    assert request.tolerance is not None
    near = sum_near(other, disc, request.tolerance, request.outside)
    return refusing(target.name, lambda: _core.write(near, target.form)), False


def _drawn(found: _core.Offset | IndexedSum) -> _core.Offset:
    return found.static if isinstance(found, IndexedSum) else found


def _told(value: dict[str, Any]) -> list[tuple[str, str]]:
    """Rows for an exact sum, or for an answer from the paper's program."""
    if value["route"] != PAPER_UPDATE:
        return [
            ("area", between(**value["area"])),
            ("length of the boundary", between(**value["length"])),
            ("digest", value["digest"]),
            *passage_rows(value["tight_passages"], "segment"),
        ]
    exact = value["exact"]
    return [
        ("route, arithmetic", f"{value['route']}, {value['arithmetic']}"),
        ("digest", value["digest"]),
        ("exact", in_words(value["comparison"])),
        ("  components, holes", f"{exact['components']:,}, {exact['holes']:,}"),
    ]


def _print(value: dict[str, Any], operand: Operand) -> None:
    scaled = "" if value["scale"] == "1" else f"{value['scale']} "
    rows = [
        ("sum", f"{scaled}{value['P']} + {value['Q']}"),
        ("radius of the disc", value["radius"]),
        ("components, holes", f"{value['components']:,}, {value['holes']:,}"),
        ("curves", f"{value['curves']:,}"),
        *_told(value),
        ("seconds", f"{value['seconds']:.3f}"),
    ]
    print_lines(rows + written_row(value) + proof_rows(value), value)
