"""`minkref fit` and `minkref trap` of a part at one scale that keeps a distance: a disc of that
radius among the sum of the obstacles and the turned part."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from minkref.cli.memory import SIMPLER, memory_wall
from minkref.cli.output import print_lines
from minkref.errors import Refusal, refusing
from minkref.motion.clear_rooms import Container, WayOut
from minkref.motion.commands.disc_rows import distance_text, radii_range, rounded_place
from minkref.motion.commands.path_answer import finish
from minkref.motion.commands.path_rows import BY_TRANSLATION, point_text
from minkref.motion.disc_radii import DiscRadii, RadiusQuestion, anywhere, between, trapped
from minkref.output.documents import Stopwatch, document
from minkref.plane.commands.scale_index import cores
from minkref.plane.operand import Operand, read_operand
from minkref.verbs.fit import FitInPlane
from minkref.verbs.trap import Trap

Row = dict[str, Any]


def run_fit(request: FitInPlane, question: str, places: list[tuple[str, str]]) -> None:
    """Answers `--anywhere` or `--between` with a clearance, for one scale."""
    watch = Stopwatch()
    first, second = _operands(request, request.container)
    given = None if question == "anywhere" else (places[0], places[1])
    assert request.clearance is not None and request.scale is not None
    scale = request.scale
    asked = Container(first.set, second.set, second.name, given, request.clearance, cores())
    radius = _radius(request)

    def answer() -> DiscRadii:
        inner = asked.inner(scale)
        if inner.is_empty:
            return radius.none("meets")
        if given is None:
            return anywhere(inner, second.name, radius, asked.threads)
        return between(inner, given, second.name, radius, asked.threads)

    where = f"{question} {' and '.join(map(point_text, places))}".rstrip()
    _give(
        request, "fit", answer, watch, (first, second), ("fits", where), container=second.name,
        question=question, places=[list(place) for place in places],
    )  # fmt: skip


def run_trap(request: Trap) -> None:
    """Answers `minkref trap` with a clearance, for one scale."""
    watch = Stopwatch()
    first, second = _operands(request, request.obstacles)
    assert request.clearance is not None and request.scale is not None
    asked = WayOut(first.set, second.set, request.at, request.clearance, cores())
    grown, radius, scale = asked.grown, _radius(request), request.scale

    def answer() -> DiscRadii:
        return trapped(grown(scale), request.at, radius, asked.threads)

    where = f"at {point_text(request.at)}"
    _give(
        request, "trap", answer, watch, (first, second), ("trapped", where),
        obstacles=second.name, at=list(request.at),
    )  # fmt: skip


def _operands(request: FitInPlane | Trap, among: str) -> tuple[Operand, Operand]:
    if request.output is not None:
        what = "no file is written of one scale with a clearance"
        raise Refusal(what, f"-o {request.output}", "leave it out; --json prints the document")
    if isinstance(request, Trap) and (request.from_scale or request.to_scale):
        raise Refusal("one scale is asked", "--from, --to", "leave --from, --to or --scale out")
    first, second = read_operand(request.part), read_operand(among)
    if first.set.is_empty:
        raise Refusal("the part is empty", first.name, "name a set of polygons", "empty-operand")
    return first, second


def _radius(request: FitInPlane | Trap) -> RadiusQuestion:
    assert request.clearance is not None
    return RadiusQuestion(request.contact, squared_radius=request.clearance**2)


def _give(
    request: FitInPlane | Trap,
    name: str,
    answer: Callable[[], DiscRadii],
    watch: Stopwatch,
    operands: tuple[Operand, Operand],
    told: tuple[str, str],
    **fields: Any,
) -> None:
    first, second = operands
    with memory_wall(request.memory, f"the {name}", f"{first.name} and {second.name}", SIMPLER):
        found = refusing(second.name, answer)
    value = document(
        name,
        watch,
        part=first.name,
        **fields,
        contact=request.contact,
        clearance=str(request.clearance),
        scale=str(request.scale),
        motion=BY_TRANSLATION,
        holds=bool(found.holds),
        distances=None if found.is_empty else radii_range(found),
        cause=found.cause,
        near=[rounded_place(event.place) for event in found.events],
        warnings=first.warnings + second.warnings,
    )
    word, where = told

    def shown(value: Row) -> None:
        among = value.get("container") or value["obstacles"]
        distances = value["distances"]
        rows = [
            ("part", f"{value['part']} in {among}, contact {value['contact']}"),
            ("scale", value["scale"]),
            (word, f"{where}: {'yes' if value['holds'] else 'no'}, clearance {value['clearance']}"),
            ("clearances", "none" if distances is None else distance_text(distances)),
            ("motion", value["motion"]),
            ("seconds", f"{value['seconds']:.3f}"),
        ]
        print_lines(rows, value)

    finish(value, None, request.json, printed=shown)
