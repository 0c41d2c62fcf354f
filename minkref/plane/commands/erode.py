"""`minkref erode`, `opening`, `closing`, `nofit` and `innerfit` in the plane."""

from __future__ import annotations

import json
import sys
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from minkref import _core
from minkref.cli.memory import SIMPLER, memory_wall
from minkref.cli.output import print_lines, written_row
from minkref.cli.plot_option import check_plot, print_plot
from minkref.errors import Refusal, refusing
from minkref.output.documents import Stopwatch, as_text, document, refuse_overwriting
from minkref.output.output_target import Target, target_of
from minkref.plane.commands.scale_index import chosen_route, refuse_overwriting_index
from minkref.plane.commands.sum import compute
from minkref.plane.commands.sum_fields import set_fields
from minkref.plane.commands.sum_table import described, passage_rows
from minkref.plane.commands.written_set import FORMS, written_set
from minkref.plane.eroded import eroding_pair, has_room, refuse_empty
from minkref.plane.operand import Operand, read_operand
from minkref.plane.operand_text import STANDARD_INPUT
from minkref.plane.parents import parents, passages_of
from minkref.plane.scaling import PlaneScale, document_of, refuse_axes, shown_scale, text_of
from minkref.verbs.erode_request import (
    DEFAULT,
    ROUTES,
    ErodeInPlane,
    InnerFitRequest,
    MorphologyRequest,
    NoFitRequest,
)

ExactFits = list[dict[str, Any]]


@dataclass(frozen=True)
class Found:
    """A region, and exact fits without area."""

    region: _core.PolygonSet
    components: int
    holes: int
    exact_fits: ExactFits
    seconds: float


@dataclass(frozen=True)
class Question:
    """A command's question. `operands`: both document fields; `fits`: the field for exact fits;
    `told`: a phrase for people; `around`: whether P surrounds the result."""

    command: str
    operands: tuple[str, str]
    names: tuple[str, str]
    request: Any
    find: Callable[[Operand, Operand, PlaneScale], Found]
    fits: str
    told: str
    around: bool
    route: str | None = None
    index: Path | None = None


def run_erode(request: ErodeInPlane) -> None:
    route = chosen_route(request.index, request.route, ROUTES, DEFAULT)
    if request.index is not None:
        mend = "leave it out; the route index without a file takes a factor for each axis"
        refuse_axes(request.scale, "an index has uniform scales", f"--index {request.index}", mend)

    def find(P: Operand, Q: Operand, scale: PlaneScale) -> Found:
        return eroded(P, Q, scale, route, request.index)

    names = request.P, request.Q
    told = "{} less {}"
    _answer(
        Question(
            "erode", ("P", "Q"), names, request, find, "remnants", told, True, route, request.index
        )
    )


def run_opening(request: MorphologyRequest) -> None:
    names = request.P, request.Q
    find = _by(_core.opening)
    _answer(Question("opening", ("P", "Q"), names, request, find, "remnants", "{} by {}", True))


def run_closing(request: MorphologyRequest) -> None:
    names = request.P, request.Q
    find = _by(_core.closing)
    _answer(Question("closing", ("P", "Q"), names, request, find, "remnants", "{} by {}", False))


def run_nofit(request: NoFitRequest) -> None:
    def find(A: Operand, B: Operand, scale: PlaneScale) -> Found:
        made = _core.negated(B.set)
        return _found(
            refusing(
                f"{A.name} and {B.name}",
                lambda: _core.minkowski_sum(A.set, made, text_of(scale), "paper", "rational", True),
            )
        )

    names = request.A, request.B
    _answer(Question("nofit", ("A", "B"), names, request, find, "exact_fits", "{} and {}", False))


def run_innerfit(request: InnerFitRequest) -> None:
    def find(P: Operand, Q: Operand, scale: PlaneScale) -> Found:
        return eroded(P, Q, scale, DEFAULT)

    names = request.container, request.part
    keys = ("container", "part")
    _answer(Question("innerfit", keys, names, request, find, "exact_fits", "{1} in {0}", True))


def eroded(
    P: Operand, Q: Operand, scale: PlaneScale, route: str, index: Path | None = None
) -> Found:
    """Erode by any route."""
    refuse_empty(Q)
    where = f"{P.name} and {Q.name}"
    if not P.set.is_region or not has_room(P, Q, scale):
        return _found(refusing(where, lambda: _core.erosion(P.set, Q.set, text_of(scale))))
    pair = eroding_pair(P, Q)
    found = compute(pair.P, pair.Q, scale, route, "rational", index)
    region, components, holes = _core.inside_out(found["region"])
    fits = [in_operands(passage, pair.outside) for passage in found["tight_passages"]]
    return Found(region, components, holes, fits, found["compute_seconds"])


def in_operands(passage: dict[str, Any], outside: _core.Outside) -> dict[str, Any]:
    """Name a tight passage's contacts by P's features, not by the outside's."""

    def renamed(parent: dict[str, Any]) -> dict[str, Any]:
        row = (parent["kind"], 1, *parent["edge"], *parent["vertex"])
        return parents(outside.in_operands(row))

    contacts = [
        sorted((renamed(parent) for parent in edges), key=_order) for edges in passage["contacts"]
    ]
    return {"points": passage["points"], "contacts": contacts}


def _order(parent: dict[str, Any]) -> tuple[str, list[int], list[int]]:
    return parent["kind"], parent["edge"], parent["vertex"]


def _by(
    operation: Callable[[_core.PolygonSet, _core.PolygonSet, str], _core.Sum],
) -> Callable[[Operand, Operand, PlaneScale], Found]:
    def find(P: Operand, Q: Operand, scale: PlaneScale) -> Found:
        refuse_empty(Q)
        where = f"{P.name} and {Q.name}"
        return _found(refusing(where, lambda: operation(P.set, Q.set, text_of(scale))))

    return find


def _found(answer: _core.Sum) -> Found:
    fits = passages_of(answer.passage_rows())
    return Found(answer.region, answer.components, answer.holes, fits, answer.seconds)


def _answer(asked: Question) -> None:
    watch = Stopwatch()
    request, names = asked.request, asked.names
    if names[0] == names[1] == STANDARD_INPUT:
        what = f"{asked.operands[0]} and {asked.operands[1]}"
        raise Refusal("standard input is one operand", what, "name a file for the other")
    target = target_of(request.output, request.form, FORMS, "wkt", request.json)
    if request.only_region and (target is None or target.form != "svg"):
        raise Refusal("no picture is written", "--only-region", "add -o FILE.svg")
    check_plot(request.plot, request.json, target)
    with memory_wall(request.memory, asked.command, f"{names[0]} and {names[1]}", SIMPLER):
        first, second = (read_operand(name) for name in names)
        if request.output is not None:
            refuse_overwriting(request.output, [first.file, second.file])
            refuse_overwriting_index(request.output, asked.index)
        found = asked.find(first, second, request.scale)
    written = _written(asked, first, second, found, target) if target is not None else None
    if target is not None and written is not None:
        if target.write(*written):
            return
    value = document(
        asked.command,
        watch,
        **dict(zip(asked.operands, (first.name, second.name), strict=True)),
        scale=document_of(request.scale),
        warnings=first.warnings + second.warnings,
        output=str(request.output) if request.output else None,
        output_exact=written[1] if written else None,
        compute_seconds=found.seconds,
        **({"route": asked.route} if asked.route is not None else {}),
        **set_fields(found.region, found.components, found.holes),
        result=json.loads(found.region.canonical_json()),
        **{asked.fits: found.exact_fits},
    )
    if request.json:
        sys.stdout.write(as_text(value))
        return
    _print(asked, value)
    print_plot(request.plot, found.region)


def _written(
    asked: Question, P: Operand, Q: Operand, found: Found, target: Target
) -> tuple[str, bool]:
    """Write the output text; tell whether it is exact."""
    if target.form == "svg" and not asked.request.only_region:
        from minkref.reports.sum_picture import sum_picture

        scale = text_of(asked.request.scale)
        return sum_picture(
            P,
            Q,
            scale,
            found.region,
            found.components,
            found.holes,
            passages=[passage["points"] for passage in found.exact_fits],
            words=(asked.command, _words(asked).removesuffix("s")),
            beneath=P.set.scaled(scale) if asked.around else None,
        ), False
    return written_set(found.region, target)


def _words(asked: Question) -> str:
    return asked.fits.replace("_", " ")


def _print(asked: Question, value: dict[str, Any]) -> None:
    first, second = (value[key] for key in asked.operands)
    scale = shown_scale(value["scale"])
    told = asked.told.format(first if scale == "1" else f"{scale} {first}", second)
    rows = [(asked.command, told)]
    if asked.route is not None:
        rows.append(("route", asked.route))
    rows += described(value)
    rows += passage_rows(value[asked.fits], "polyline", _words(asked))
    rows.append(("seconds", f"{value['seconds']:.3f}"))
    print_lines(rows + written_row(value), value)
