"""What the report shows of one kind of finding: its smallest case, drawn, with witness and
program."""

from __future__ import annotations

import math
import re
from dataclasses import dataclass

from minkref import _core
from minkref.commands.verify_output import describe
from minkref.exact import approximate
from minkref.fuzz.run.runner import Finding
from minkref.fuzz.shrink.groups import Group
from minkref.fuzz.verdicts.region import minus
from minkref.reports.conformance.drawing import Layer, bounds, picture
from minkref.reports.conformance.program import Program, program


@dataclass(frozen=True)
class FindingPage:
    name: str
    verdict: str
    lines: list[str]
    pictures: list[tuple[str, str]]
    program: Program | None


def finding_page(group: Group) -> FindingPage:
    """Drawn is the smallest that it shrank to."""
    outcome = group.example.outcome
    kinds = "-".join(outcome.kinds)
    name = re.sub(r"[^A-Za-z0-9.]+", "-", f"{outcome.target}-{kinds}").strip("-")
    finding = group.example
    if group.small:
        finding = Finding(group.small[0].outcome, group.small[0].result)
    return FindingPage(
        name,
        str(outcome.verdict),
        describe(group),
        _pictures(finding),
        program(finding, name),
    )


def _pictures(finding: Finding) -> list[tuple[str, str]]:
    case, outcome = finding.case, finding.outcome
    if case.P is None or case.Q is None or case.dimension != 2:
        return []
    P, Q = _core.PolygonSet.from_json(case.P), _core.PolygonSet.from_json(case.Q)
    scale = "" if case.scale == "1" else f" (to be scaled by {case.scale})"
    shown = [
        (f"P{scale}", picture([Layer("first", P.rings())], "P")),
        ("Q", picture([Layer("second", Q.rings())], "Q")),
    ]
    if case.expected is None:
        return shown
    mark = []
    if outcome.witness:
        x, y = (approximate(number) for number in outcome.witness.point)
        if math.isfinite(x) and math.isfinite(y):
            mark = [Layer("witness", point=(x, y))]
    expected = Layer("sum", _rings(case.expected))
    layers = [("expected", [expected])]
    if outcome.got is not None:
        got = Layer("got", _rings(outcome.got))
        missing = Layer("missing", minus(case.expected, outcome.got).rings())
        extra = Layer("extra", minus(outcome.got, case.expected).rings())
        layers += [
            (f"got from {outcome.target}", [got]),
            (
                "difference: missing red, extra orange",
                [Layer("faint", expected.polygons), missing, extra],
            ),
        ]
    box = bounds([layer for _, group in layers for layer in group])
    return shown + [
        (caption, picture([*group, *mark], caption, box=box)) for caption, group in layers
    ]


def _rings(canonical: str) -> list[list[list[tuple[float, float]]]]:
    rings: list[list[list[tuple[float, float]]]] = _core.PolygonSet.from_json(canonical).rings()
    return rings
