"""`minkref path` and `minkref fit --at` with --clearance: the scales at which a part keeps a
distance."""

from __future__ import annotations

from typing import Any

from minkref import _core
from minkref.certain_digits import between
from minkref.cli.memory import SMALLER, memory_wall
from minkref.cli.output import give, print_lines
from minkref.errors import Refusal, refusing
from minkref.motion.clear_values import ClearBound, ClearRange, RootScale, clear_scales_of
from minkref.motion.commands.path_answer import finish
from minkref.motion.commands.path_input import input_in_plane
from minkref.motion.commands.path_rows import MOST_ROWS, feature_text, number_text, point_text
from minkref.output.documents import Stopwatch, document
from minkref.plane.operand import read_operand
from minkref.verbs.fit import FitInPlane
from minkref.verbs.path import PathInPlane

Row = dict[str, Any]
LONGEST = 40  # characters of a number in a line


def run_path(request: PathInPlane) -> None:
    """Answers `minkref path` with a clearance."""
    if request.certify is not None:
        what = "there is no certificate of a clearance"
        raise Refusal(what, "--certify", "leave it out, or leave --clearance out")
    if request.route != "pieces":
        what = "a clearance has one route"
        raise Refusal(what, f"--route {request.route}", "leave it out, or leave --clearance out")
    if request.output is not None and request.output.suffix.lower() == ".svg":
        what = "no picture is drawn of a clearance"
        raise Refusal(what, str(request.output), "name a .json file")
    asked = input_in_plane(request)
    with asked.memory_wall("the path"):
        rows = refusing(
            asked.where,
            lambda: _core.clear_scales(
                asked.part, asked.obstacles, asked.way.points, str(request.clearance),
                request.contact, *asked.window,
            ),
        )  # fmt: skip
    motion = "translations only, along the path"
    value = asked.document("path", motion, {"clearance": str(request.clearance), **_answer(rows)})

    def printed(value: Row) -> None:
        told = f"{value['path']}, vertices {value['vertices']:,}, contact {value['contact']}"
        _print([("part", value["part"]), ("path", told)], value)

    finish(value, asked.target, request.json, printed=printed)


def run_fit_at(request: FitInPlane, place: tuple[str, str]) -> None:
    """Answers `minkref fit --at` with a clearance."""
    watch = Stopwatch()
    if request.output is not None:
        what = "no file is written of a fit with a clearance"
        raise Refusal(what, f"-o {request.output}", "leave it out; --json prints the document")
    first, second = read_operand(request.part), read_operand(request.container)
    names = f"{request.part} and {request.container}"
    with memory_wall(request.memory, "the fit", names, SMALLER):
        rows = refusing(
            f"{request.part}, {request.container}",
            lambda: _core.scales_clear_at(
                first.set, second.set, place, str(request.clearance), request.contact
            ),
        )
    value = document(
        "fit",
        watch,
        part=first.name,
        container=second.name,
        question="at",
        places=[list(place)],
        contact=request.contact,
        clearance=str(request.clearance),
        **_answer(rows),
        warnings=first.warnings + second.warnings,
    )

    def shown(value: Row) -> None:
        part = f"{value['part']} in {value['container']}, contact {value['contact']}"
        _print([("part", part), ("place", point_text(place))], value)

    give(value, request.json, shown)


def _answer(rows: Any) -> Row:
    found = clear_scales_of(rows)
    return {
        "clear": [clear_range(one) for one in found.ranges],
        "ends": [_bound(one) for one in found.bounds],
    }


def clear_range(one: ClearRange) -> Row:
    return {
        "from": _number(one.low),
        "from_in": one.low_in,
        "to": None if one.high is None else _number(one.high),
        "to_in": one.high_in,
    }


def _number(scale: RootScale) -> Row:
    low, high = scale.bounds
    return {"exact": scale.expression, "low": low, "high": high}


def _bound(bound: ClearBound) -> Row:
    return {
        "scale": _number(bound.scale),
        "event": "blocks" if bound.blocks else "frees",
        "segment": bound.segment,
        "t": _number(bound.t),
        **{
            name: {"edge" if feature.is_edge else "vertex": [feature.ring, feature.index]}
            for name, feature in (("part", bound.part), ("obstacle", bound.obstacle))
        },
    }


def _text(number: Row) -> str:
    exact: str = number["exact"]
    return exact if len(exact) <= LONGEST else between(number["low"], number["high"])


def clear_range_text(one: Row) -> str:
    if one["to"] is not None and one["from"]["exact"] == one["to"]["exact"]:
        return f"{_text(one['from'])} alone"
    high = "infinity" if one["to"] is None else _text(one["to"])
    left, right = "[" if one["from_in"] else "(", "]" if one["to_in"] else ")"
    return f"{left}{_text(one['from'])}, {high}{right}"


def _t_text(t: Row) -> str:
    exact: str = t["exact"]
    if "sqrt" in exact:
        return f"about {between(t['low'], t['high'])}"
    return f"= {number_text(exact)}"


def _print(rows: list[tuple[str, str]], value: Row) -> None:
    rows += [
        ("clearance", value["clearance"]),
        ("clear scales", ", ".join(map(clear_range_text, value["clear"])) or "none"),
    ]
    for bound in value["ends"][:MOST_ROWS]:
        near = between(bound["scale"]["low"], bound["scale"]["high"])
        part, obstacle = (feature_text(bound[name]) for name in ("part", "obstacle"))
        place = f"segment {bound['segment']}, t {_t_text(bound['t'])}"
        rows.append((near, f"{bound['event']}: {part} of the part, {obstacle}; {place}"))
    if len(value["ends"]) > MOST_ROWS:
        rows.append(("more", f"{len(value['ends']) - MOST_ROWS:,}; --json prints all"))
    if value.get("output"):
        rows.append(("written", value["output"]))
    rows.append(("seconds", f"{value['seconds']:.3f}"))
    print_lines(rows, value)
