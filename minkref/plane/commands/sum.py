"""`minkref sum P Q` in the plane: the static sum sP + Q, exact."""

from __future__ import annotations

import sys
import time
from fractions import Fraction
from pathlib import Path
from typing import TYPE_CHECKING, Any

from minkref import _core
from minkref.arithmetic import check_arithmetic
from minkref.cli.memory import SIMPLER, memory_wall
from minkref.cli.plot_option import check_plot, print_plot
from minkref.cli.readings import ROUTE as PAPER_UPDATE
from minkref.cli.readings import readings_of, refuse_options
from minkref.errors import Refusal, refusing
from minkref.output.documents import Stopwatch, as_text, document, refuse_overwriting
from minkref.output.output_target import Target, target_of
from minkref.plane.commands.scale_index import chosen_route, index_of, refuse_overwriting_index
from minkref.plane.commands.sum_fields import SUM_FIELDS, sum_fields
from minkref.plane.commands.sum_table import print_table
from minkref.plane.commands.written_set import FORMS, written_set
from minkref.plane.operand import Operand, read_operand
from minkref.plane.operand_text import STANDARD_INPUT
from minkref.plane.parents import PassageRows, passages_of
from minkref.plane.place import placed
from minkref.plane.proved_sum import ROUTE as PROVED
from minkref.plane.proved_sum import ProvedSum, proved_sum
from minkref.plane.scaling import PlaneScale, document_of, refuse_axes, static_pair, text_of
from minkref.verbs.sum import DEFAULT, ROUTES, UPDATING, SumInPlane

if TYPE_CHECKING:
    from minkref.verbs.paper_update import PaperWalk

OR_PAPER = ("definition", "dynamic", "index", PAPER_UPDATE)  # the route paper needs less memory


def run(request: SumInPlane) -> None:
    P, Q, json, output = request.P, request.Q, request.json, request.output
    if P == Q == STANDARD_INPUT:
        raise Refusal("standard input is one operand", "P and Q", "name a file for the other")
    watch = Stopwatch()
    route = chosen_route(request.index, request.route, ROUTES, DEFAULT)
    _refuse_axes(request, route)
    readings = _readings(request, route)
    if request.start is not None and route not in UPDATING:
        what = f"the route {route} does not go from scale to scale"
        raise Refusal(what, f"--from {request.start}", f"add --route {' or '.join(UPDATING)}")
    target = target_of(output, request.form, FORMS, "wkt", json)
    _check_pictures(request, target)
    instead = f"{SIMPLER}, or the route paper" if route in OR_PAPER else SIMPLER
    with memory_wall(request.memory, f"route {route}", f"{P} and {Q}", instead):
        lines = route not in (PAPER_UPDATE, PROVED)
        first, second = read_operand(P, lines), read_operand(Q, lines)
        if output is not None:
            refuse_overwriting(output, [first.file, second.file])
            refuse_overwriting_index(output, request.index)
        result = compute(
            first,
            second,
            request.scale,
            route,
            request.arithmetic,
            request.index,
            readings,
            request.start,
        )
        region, truth = result.pop("region"), result.pop("truth")
    drawn = (first, second, text_of(request.scale), result, truth) if not request.only_sum else None
    written = _written(region, target, drawn) if target is not None else None
    if target is not None and written is not None:
        if target.write(*written):
            return
    value = document(
        "sum",
        watch,
        P=first.name,
        Q=second.name,
        scale=document_of(request.scale),
        warnings=first.warnings + second.warnings,
        output=str(output) if output else None,
        output_exact=written[1] if written else None,
        at=placed(request.at, region),
        **result,
    )
    if json:
        sys.stdout.write(as_text(value))
        return
    print_table(value)
    print_plot(request.plot, region, [each["points"] for each in value["tight_passages"] or ()])


def _refuse_axes(request: SumInPlane, route: str) -> None:
    """Refuses a factor for each axis where the way through the scales knows uniform ones only."""
    if request.index is not None:
        mend = "leave it out; the route index without a file takes a factor for each axis"
        refuse_axes(request.scale, "an index has uniform scales", f"--index {request.index}", mend)
    if request.start is not None:
        what, mend = "a sum goes from scale to scale by uniform ones only", "leave out --from"
        refuse_axes(request.scale, what, f"--from {request.start}", mend)
    if route == PAPER_UPDATE:
        what = "the update of Sec. 4 of the paper is of uniform scales only"
        mend = "give one scale, or take --route dynamic"
        refuse_axes(request.scale, what, f"--route {route}", mend)


def _readings(request: SumInPlane, route: str) -> dict[str, str] | None:
    """How the paper's own program reads the paper; None for the other routes. Refuses options that
    the route does not have."""
    check_arithmetic(request.arithmetic)
    if request.arithmetic != "rational" and route not in ("paper", PAPER_UPDATE):
        raise Refusal(
            f"the route {route} is exact only",
            f"--route {route} --arithmetic {request.arithmetic}",
            "leave out one of the two options",
        )
    refuse_options(route, request.as_read, request.reading)
    return readings_of(request.as_read, request.reading) if route == PAPER_UPDATE else None


def _check_pictures(request: SumInPlane, target: Target | None) -> None:
    if request.only_sum and (target is None or target.form != "svg"):
        raise Refusal("no picture is written", "--only-sum", "add -o FILE.svg")
    check_plot(request.plot, request.json, target)


def _written(
    region: _core.PolygonSet | None,
    target: Target,
    drawn: tuple[Operand, Operand, str, dict[str, Any], _core.PolygonSet | None] | None,
) -> tuple[str, bool]:
    """The output text, and whether exact. `drawn`: what an SVG shows beside the sum."""
    if region is None:
        raise Refusal(
            "the arithmetic could not decide a sign: there is nothing to write",
            target.name,
            "use --arithmetic rational",
            "undecided-sign",
        )
    if target.form == "svg" and drawn is not None:
        P, Q, scale, found, truth = drawn
        from minkref.reports.sum_picture import sum_picture

        counts = (found["components"], found["holes"])
        beside = found["tight_passages"] or found["remnants"] or ()
        passages = [passage["points"] for passage in beside]
        return sum_picture(P, Q, scale, region, *counts, truth, passages), False
    return written_set(region, target)


def compute(
    P: Operand,
    Q: Operand,
    factor: PlaneScale,
    route: str,
    arithmetic: str,
    index: Path | None = None,
    readings: dict[str, str] | None = None,
    start: Fraction | None = None,
) -> dict[str, Any]:
    """The fields of the document that describe the sum, and `region` (None where the arithmetic
    could not decide a sign), and `truth`, the exact sum where the paper's program has answered. For
    another arithmetic than rational, `exact` says what is true."""
    import json

    where = f"{P.name} and {Q.name}"
    scale = text_of(factor)
    exact = arithmetic == "rational" and readings is None
    thin = all(not (each.set.is_region or each.set.is_empty) for each in (P, Q))
    undecided = False
    answer: _core.Sum | ProvedSum | None = None
    seconds: float | None = None
    passages: PassageRows | None = None
    walk: PaperWalk | None = None
    step: dict[str, Any] | None = None
    try:
        if route == "dynamic" or start is not None:
            answer, passages, seconds, step = refusing(
                where, lambda: _updated(P, Q, start, factor, route)
            )
        elif readings is not None:
            from minkref.verbs.paper_update import PaperWalk

            walk = PaperWalk(P, Q, scale, arithmetic, readings)
            answer = refusing(where, walk.sum)
            seconds = walk.seconds + answer.seconds
        elif route == PROVED:
            answer = refusing(where, lambda: proved_sum(P, Q, factor))
            passages = None if thin else _passages(P, Q, factor)
            seconds = answer.seconds
        elif route == "index":
            made, at = static_pair(P, factor)
            built = index_of(index, made, Q, at, at)
            answer = refusing(where, lambda: built.sum(str(at), True))
            passages = answer.passage_rows()
            seconds = answer.seconds if index else built.seconds + answer.seconds
        else:
            answer = refusing(
                where, lambda: _core.minkowski_sum(P.set, Q.set, scale, route, arithmetic, exact)
            )
            passages = answer.passage_rows() if exact and not thin else None
            seconds = answer.seconds
    except _core.UndecidedSign:
        undecided = True
    fields: dict[str, Any] = {
        "route": route,
        "from": None if start is None else str(start),
        "step": None if start is None else step,
        "arithmetic": arithmetic,
        "undecided": undecided,
        "compute_seconds": seconds,
        **_description(answer),
        "tight_passages": None if passages is None else passages_of(passages),
        "remnants": _remnants(P, Q, scale, answer) if thin and exact and answer else None,
        "signs": _signs(answer.statistics)
        if answer and route in _core.ROUTES and start is None
        else None,
        "statistics": dict(answer.statistics) if answer else None,
        "exact": None,
        "readings": readings,
        "comparison": None,
    }
    if not exact:
        truth = refusing(
            where, lambda: _core.minkowski_sum(P.set, Q.set, scale, "paper", "rational")
        )
        described = _description(truth)
        equal = described["digest"] == fields["digest"] if answer else None
        fields["exact"] = {**described, "equal": equal}
        del fields["exact"]["result"]
        if walk is not None and isinstance(answer, _core.Sum):
            fields["comparison"] = walk.beside_exact(scale, answer, truth)
    canonical = answer.region.canonical_json() if answer else None
    fields["result"] = json.loads(canonical) if canonical else None
    fields["region"] = answer.region if answer else None
    fields["truth"] = truth.region if readings is not None else None
    return fields


def _updated(
    P: Operand, Q: Operand, start: Fraction | None, factor: PlaneScale, route: str
) -> tuple[_core.Sum, PassageRows, float, dict[str, Any]]:
    """By dynamic update from one scale to another, and what the step did; without a start over a
    window that is this scale only, or, of convex operands with a factor for each axis, from P
    unscaled (Behar & Lien 2012, Sec. 6). Scale changes do not keep the passages: these come from
    the static arrangement."""
    began = time.perf_counter()
    if isinstance(factor, tuple) and P.set.is_convex and Q.set.is_convex:
        convex = _core.DynamicPolygonSum(P.set, Q.set, "1")
        convex.update(text_of(factor))
        answer = convex.sum()
        return answer, answer.passage_rows(), time.perf_counter() - began, {}
    P, at = static_pair(P, factor)
    begin, scale = str(at if start is None else start), str(at)
    least, greatest = sorted((begin, scale), key=Fraction)
    moving = _core.DynamicSum(P.set, Q.set, least, greatest, route)
    moving.move_to(begin)
    did = dict(moving.move_to(scale))
    answer = moving.sum()
    passages = _core.tight_passages(P.set, Q.set, scale)
    return answer, passages, time.perf_counter() - began, did


def _passages(P: Operand, Q: Operand, factor: PlaneScale) -> PassageRows:
    """From the static arrangement."""
    P, at = static_pair(P, factor)
    return _core.tight_passages(P.set, Q.set, str(at))


def _remnants(
    P: Operand, Q: Operand, scale: str, answer: _core.Sum | ProvedSum
) -> list[dict[str, Any]]:
    """List the parts without area of two operands without area."""
    return passages_of(_core.sum_remnants(P.set, Q.set, scale, answer.region))


def _description(answer: _core.Sum | ProvedSum | None) -> dict[str, Any]:
    fields = dict.fromkeys(SUM_FIELDS) if answer is None else sum_fields(answer)
    return {**fields, "result": None}


def _signs(statistics: dict[str, Any]) -> dict[str, Any]:
    counts = {name: int(statistics[name]) for name in ("by_float", "by_integer", "by_rational")}
    total = sum(counts.values())
    shares = {name: count / total if total else 0.0 for name, count in counts.items()}
    return {**counts, "total": total, "shares": shares}
