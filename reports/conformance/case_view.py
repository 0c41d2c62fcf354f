"""The view of a finding's case: a drawing, words, text and a program."""

from __future__ import annotations

import json
from dataclasses import dataclass, field, replace
from fractions import Fraction
from typing import Any

from minkref import _core
from minkref.errors import cut
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.geometry.polyhedron import Polyhedron
from minkref.fuzz.judges.witness_certificate import WitnessCertificate, certificate_of
from minkref.fuzz.libraries.program import Program
from minkref.fuzz.libraries.programs import program, why_none
from minkref.fuzz.plane.boundary_sum import MOST_PAIRS, boundary_sum
from minkref.fuzz.run.naming import load_in_plane
from minkref.fuzz.run.runner import Finding
from minkref.fuzz.run.worker import CaseResult
from minkref.fuzz.shrink.groups import Group
from minkref.fuzz.verdicts.verdict import Outcome, Reason
from minkref.output.terminal import counted, escaped
from minkref.reports.conformance.argument import argument_in_plane, point_text
from minkref.reports.conformance.feature_words import (
    feature_argument,
    feature_question,
    features_lines,
    features_set,
)
from minkref.reports.conformance.offset_pictures import offset_pictures
from minkref.reports.conformance.offset_words import (
    is_inward,
    offset_argument,
    offset_question,
    offset_set,
)
from minkref.reports.conformance.path_words import path_argument, path_question
from minkref.reports.conformance.plane_pictures import (
    Picture,
    comparison_pictures,
    meeting_picture,
    operand_pictures,
    placed_picture,
    set_pictures,
)
from minkref.reports.conformance.space_argument import argument_in_space
from minkref.reports.conformance.space_pictures import (
    expected_in_space,
    space_comparison_pictures,
    space_operand_pictures,
)
from minkref.reports.conformance.union_words import named_sets, union_argument, union_question

MOST_TEXT = 6000  # characters of a written-out operand
MOST_PICTURES = 12  # sets to unite that are drawn one by one
MOST_ROWS = 60  # rows shown from a vertex or face table


@dataclass(frozen=True)
class SolidTable:
    name: str
    vertices: list[tuple[int, list[str]]]
    faces: list[tuple[int, str]]
    more: str


@dataclass
class CaseView:
    finding: Finding
    title: str
    operands: list[Picture] = field(default_factory=list)
    panes: list[Picture] = field(default_factory=list)
    meeting: Picture | None = None
    tables: list[SolidTable] = field(default_factory=list)
    argument: list[str] = field(default_factory=list)
    expected: str | None = None
    program: Program | None = None
    no_program: str = ""
    undrawn: str = ""
    certificate: WitnessCertificate | None = None

    @property
    def outcome(self) -> Outcome:
        return self.finding.outcome

    @property
    def case(self) -> CaseResult:
        return self.finding.case

    @property
    def invalid(self) -> bool:
        """Whether an operand is invalid: no sum exists, and the right answer is a refusal."""
        return Reason.ACCEPTED_INVALID in self.outcome.reasons

    @property
    def refusal(self) -> str:
        """Names the operands' fault and its place."""
        witness = self.outcome.witness
        at = f", at {point_text(witness.point)}" if witness else ""
        what = escaped(cut(self.outcome.message))
        return f"An operand is invalid ({what}){at}: the right answer is a refusal."

    @property
    def reproduce(self) -> str:
        return escaped(self.finding.reproduce)

    @property
    def question(self) -> list[str]:
        """The question about the operands, a line each."""
        if self.case.union:
            return union_question(self.case.union)
        if self.case.offset:
            return offset_question(self.case.offset)
        if self.case.features:
            return feature_question(self.case.features)
        return path_question(self.case.path) if self.case.path else [f"scale: {self.case.scale}"]

    @property
    def claim(self) -> str:
        """The witness's claim, whose argument follows."""
        witness = self.outcome.witness
        if witness is None or witness.contact is not None or witness.feature is not None:
            return ""
        has = "has" if witness.in_truth else "does not have"
        wrong = "; the result is wrong there" if self.outcome.got else ""
        what = "sum" if witness.sets is None else "union"
        if witness.radius is not None:
            what = "erosion" if is_inward(witness.radius) else "grown set"
        return f"The {what} {has} the point x = {point_text(witness.point)}{wrong}."

    @property
    def operand_texts(self) -> list[tuple[str, str]]:
        if self.case.union:
            return [(name, written(text)) for name, text in named_sets(self.case.union)]
        if self.case.offset:
            return [("the set", written(offset_set(self.case.offset)))]
        if self.case.features:
            return [("the set", written(features_set(self.case.features)))]
        return [
            (name, written(text))
            for name, text in (("P", self.case.P), ("Q", self.case.Q))
            if text is not None
        ]


def case_views(group: Group, name: str, boundary: bool) -> list[CaseView]:
    """A view of each shrunk case; without shrunk cases, a view of the smallest finding."""
    if not group.small:
        finding = group.example
        title = f"The smallest found, not made smaller: {finding.case.size[0]:,} vertices"
        return [_view(finding, title, name, boundary)]
    views = []
    for number, small in enumerate(group.small):
        stays = "" if small.stable else "; it does not show every time"
        end = "" if small.complete else "; more calls might make it smaller"
        title = (
            f"Shrunk to {small.result.size[0]:,} vertices in {counted(small.calls, 'call')}"
            f"{stays}{end}"
        )
        finding = Finding(small.outcome, small.result)
        views.append(_view(finding, title, f"{name}-{number + 1}" if number else name, boundary))
    return views


def _view(finding: Finding, title: str, name: str, boundary: bool) -> CaseView:
    view = CaseView(finding, title, certificate=certificate_of(finding, name))
    case = finding.case
    if case.P is None or case.Q is None:
        view.no_program = why_none(finding)
        return view
    try:
        view.program = program(_without_witness(finding) if view.invalid else finding, name)
        if view.invalid:
            view.operands = operand_pictures(case.P, case.Q, case.scale)
        elif case.path is not None:
            _fill_path(view, case.P, case.Q)
        elif case.union is not None:
            _fill_union(view, case.union)
        elif case.offset is not None:
            _fill_offset(view, case.offset)
        elif case.features is not None:
            _fill_features(view, case.features)
        elif case.dimension == 3:
            _fill_space(view, case.P, case.Q)
        else:
            _fill_plane(view, case.P, case.Q, boundary)
    except Exception as error:  # noqa: BLE001 operands may be invalid on purpose: still a report
        view.undrawn = f"Not all of it is drawn: {escaped(cut(str(error)))}"
    view.no_program = "" if view.program else why_none(finding)
    return view


def _without_witness(finding: Finding) -> Finding:
    return Finding(replace(finding.outcome, witness=None), finding.case)


def _fill_path(view: CaseView, part: str, obstacles: str) -> None:
    view.operands = operand_pictures(part, obstacles, "1")
    witness = view.outcome.witness
    if witness is not None:
        view.argument = path_argument(witness)
        view.meeting = placed_picture(part, obstacles, witness)


def _fill_union(view: CaseView, literal: str) -> None:
    view.operands = set_pictures(named_sets(literal)[:MOST_PICTURES])
    view.expected = view.case.expected
    if view.expected is not None:
        view.panes = comparison_pictures(view.expected, view.outcome)
    if view.outcome.witness is not None:
        view.argument = union_argument(view.outcome.witness)


def _fill_offset(view: CaseView, literal: str) -> None:
    view.operands = set_pictures([("the set", offset_set(literal))])
    view.expected = view.case.expected
    if view.expected is not None:
        radius = Fraction(json.loads(literal)["radius"])
        view.panes = offset_pictures(view.expected, radius, view.outcome)
    if view.outcome.witness is not None:
        view.argument = offset_argument(view.outcome.witness)


def _fill_features(view: CaseView, literal: str) -> None:
    view.operands = set_pictures([("the set", features_set(literal))])
    view.expected = view.case.expected
    if view.outcome.witness is not None:
        view.argument = feature_argument(view.outcome.witness)


def _fill_plane(view: CaseView, P: str, Q: str, boundary: bool) -> None:
    case, witness = view.case, view.outcome.witness
    view.operands = operand_pictures(P, Q, case.scale)
    view.expected = _expected(case, P, Q, boundary or bool(witness and witness.boundary))
    if view.expected is not None:
        view.panes = comparison_pictures(view.expected, view.outcome)
    if witness is not None:
        view.argument = argument_in_plane(P, Q, case.scale, witness)
        view.meeting = meeting_picture(P, Q, case.scale, witness)


def _expected(case: CaseResult, P: str, Q: str, boundary: bool) -> str | None:
    """The intended sum as canonical JSON; None if the sum fails or would take too long."""
    if not boundary and case.expected is not None:
        return case.expected
    first, second = _core.PolygonSet.from_json(P), _core.PolygonSet.from_json(Q)
    if first.vertices * second.vertices > MOST_PAIRS:
        return None
    if boundary:
        text = json.dumps({"P": json.loads(P), "Q": json.loads(Q), "scale": case.scale})
        return boundary_sum(load_in_plane(CaseName(text, "report"))).json
    try:
        region = _core.minkowski_sum(first, second, case.scale).region
    except (ValueError, RuntimeError):
        return None
    canonical: str = region.canonical_json()
    return canonical


def _fill_space(view: CaseView, P: str, Q: str) -> None:
    case, witness = view.case, view.outcome.witness
    first, second = Polyhedron.from_json(P), Polyhedron.from_json(Q)
    view.operands = space_operand_pictures(first, second, case.scale)
    view.panes = space_comparison_pictures(first, second, case, view.outcome)
    view.tables = [_table("P", first), _table("Q", second)]
    known = expected_in_space(case)
    view.expected = known.to_json() if known else None
    if witness is not None:
        view.argument = argument_in_space(P, Q, case.scale, witness)


def _table(name: str, solid: Polyhedron) -> SolidTable:
    vertices = [
        (number, [str(x) for x in vertex])
        for number, vertex in enumerate(solid.vertices[:MOST_ROWS])
    ]
    faces = [
        (number, " ".join(str(k) for k in face))
        for number, face in enumerate(solid.faces[:MOST_ROWS])
    ]
    left = [
        f"{count - MOST_ROWS:,} more {noun}"
        for count, noun in ((len(solid.vertices), "vertices"), (len(solid.faces), "faces"))
        if count > MOST_ROWS
    ]
    return SolidTable(name, vertices, faces, " and ".join(left))


def written(text: str) -> str:
    """A set as readable text: one polygon or list per line, cut when long."""
    value = json.loads(text)
    lines = []
    if "polygons" in value:
        for polygon in value["polygons"]:
            lines.append(f"polygon {_ring(polygon['outer'])}")
            lines += [f"  hole {_ring(hole)}" for hole in polygon.get("holes", [])]
        lines = lines or ["the empty set"]
    elif "bars" in value:
        lines += features_lines(value) or ["no features"]
    elif "components" in value:
        for component in value["components"]:
            lines.append(f"ring {_curves(component['outer'])}")
            lines += [f"  hole {_curves(hole)}" for hole in component["holes"]]
        lines = lines or ["the empty set"]
    else:
        lines.append(f"vertices {_ring(value['vertices'])}")
        lines.append("faces " + " ".join(f"[{' '.join(map(str, f))}]" for f in value["faces"]))
    whole = "\n".join(lines)
    if len(whole) > MOST_TEXT:
        return f"{whole[:MOST_TEXT]} ... ({len(whole):,} characters)"
    return whole


def _ring(ring: list[list[Any]]) -> str:
    return " ".join(f"({', '.join(str(n) for n in point)})" for point in ring)


def _curves(ring: list[list[str]]) -> str:
    """Circles about a centre, and lines by direction and height (docs/disc.md)."""
    return " ".join(f"{kind} ({', '.join(numbers)})" for kind, *numbers in ring)
