"""The types of the documents, of which the published schemas are made."""

from __future__ import annotations

import pkgutil
from collections.abc import Collection
from importlib import import_module
from typing import Annotated, Any, Literal, TypedDict, get_args, is_typeddict

import pytest
from minkref import schemas
from minkref.disc.commands import events as disc_events
from minkref.disc.commands import pair_events
from minkref.disc.commands import sum as disc_sum
from minkref.disc.commands import sweep as disc_sweep
from minkref.fuzz.judges.space import convex_claims
from minkref.fuzz.verdicts.verdict import GOOD
from minkref.fuzz.verdicts.verdict import Reason as OurReason
from minkref.fuzz.verdicts.verdict import Verdict as OurVerdict
from minkref.motion import scale_ranges
from minkref.plane import convolution_values, event_values
from minkref.plane.commands import sweep as plane_sweep
from minkref.plane.commands import sweep_folder
from minkref.plane.commands import view as plane_view
from minkref.reports.bench import baselines
from minkref.schemas import make, names, result_schema
from minkref.schemas.bench.table1 import Baseline
from minkref.schemas.certificates import CheckVerdict
from minkref.schemas.disc.erode import DiscErodeRoute
from minkref.schemas.disc.events import DiscEventsKind
from minkref.schemas.disc.pair_events import Condition, PairChange
from minkref.schemas.disc.sum import DiscSumRoute
from minkref.schemas.disc.sweep import DiscSweepFormat
from minkref.schemas.disc.values import DiscEventKind
from minkref.schemas.grammar import EXACTLY_ONE, Either, ruled
from minkref.schemas.motion.path import PathRoute, SpacePathRoute
from minkref.schemas.plane.convolution import Compatible
from minkref.schemas.plane.erode import ErodeRoute
from minkref.schemas.plane.events import EventsKind, EventsRoute
from minkref.schemas.plane.sum import SumRoute
from minkref.schemas.plane.sweep import SweepFormat
from minkref.schemas.plane.values import SweepRoute, ViewRoute
from minkref.schemas.report import Subject
from minkref.schemas.space.convolution import ConvolutionFacetKind
from minkref.schemas.space.erode import SpaceErodeRoute
from minkref.schemas.space.events import SpaceEventKind, SpaceEventsKind
from minkref.schemas.space.repair import Fault
from minkref.schemas.space.sum import SpaceSumRoute
from minkref.schemas.space.sweep import SpaceSweepFormat
from minkref.schemas.space.view import FrameKinds
from minkref.schemas.values import Form, Number, Rule
from minkref.schemas.verify.cases import Reason, Verdict
from minkref.schemas.verify.document import EveryVerdict
from minkref.space import facets
from minkref.space.commands import event_parts
from minkref.space.commands import events as space_events
from minkref.space.commands import sum as space_sum
from minkref.space.page import general_frames
from minkref.verbs import check, erode_request, report
from minkref.verbs import sum as sum_command
from msgspec import Meta

#: Words of a type, and where the program has them.
WORDS: dict[str, tuple[Any, Collection[Any]]] = {
    "baselines of bench": (
        Baseline, (baselines.PAIRWISE, baselines.CONTACTS, baselines.STATIC, baselines.CGAL)
    ),
    "verdicts of check": (CheckVerdict, check.WORDS.values()),
    "subjects of report": (Subject, report.SUBJECTS),
    "verdicts of verify": (EveryVerdict, OurVerdict),
    "verdicts of findings": (Verdict, set(OurVerdict) - {*GOOD, OurVerdict.SKIPPED}),
    "reasons": (Reason, OurReason),
    "rules of contact": (Rule, scale_ranges.CONTACTS),
    "routes of path": (PathRoute, scale_ranges.PATH_ROUTES),
    "routes of path in space": (SpacePathRoute, scale_ranges.PATH_ROUTES[:2]),
    "routes of sum": (SumRoute, sum_command.ROUTES),
    "routes of sum in space": (SpaceSumRoute, space_sum.ALL_ROUTES),
    "routes of sum with a disc": (DiscSumRoute, disc_sum.DISC_ROUTES),
    "routes of erode": (ErodeRoute, erode_request.ROUTES),
    "routes of erode with a disc": (DiscErodeRoute, erode_request.DISC_ROUTES),
    "routes of erode in space": (SpaceErodeRoute, erode_request.SPACE_ROUTES),
    "routes of sweep": (SweepRoute, plane_sweep.ROUTES),
    "routes of view": (ViewRoute, plane_view.ROUTES),
    "routes of events": (EventsRoute, event_values.ROUTES),
    "formats of sweep": (SweepFormat, sweep_folder.FORMATS),
    "formats of sweep in space": (SpaceSweepFormat, sweep_folder.SPACE_FORMATS),
    "formats of sweep with a disc": (DiscSweepFormat, disc_sweep.FORMATS),
    "forms of formulas": (Form, event_values.FORMS),
    "ends of turns": (Compatible, convolution_values.COMPATIBLE),
    "kinds of events": (EventsKind, event_values.KINDS),
    "kinds of events in space": (SpaceEventsKind, space_events.KINDS),
    "kinds of one event in space": (
        SpaceEventKind, (*event_parts.OF_PAIRS, *event_parts.OF_MORE)
    ),
    "kinds of events with a disc": (DiscEventsKind, disc_events.KINDS),
    "kinds of places with a disc": (DiscEventKind, disc_events.KINDS_OF_PLACES),
    "conditions of pairs with a disc": (Condition, pair_events.CONDITIONS),
    "changes of pairs with a disc": (PairChange, pair_events.CHANGES),
    "kinds of facets": (ConvolutionFacetKind, facets.KINDS),
    "faults of a repair": (
        Fault, (convex_claims.NOT_SUPPORTING, convex_claims.OVERLAPPING, convex_claims.MISSING)
    ),
}  # fmt: skip


@pytest.mark.parametrize("what", WORDS)
def test_words_of_a_type_are_those_of_the_program(what: str) -> None:
    kind, ours = WORDS[what]
    assert set(get_args(kind)) == set(ours)
    assert len(get_args(kind)) == len(ours)


def test_frames_count_the_kinds_that_the_page_shows() -> None:
    assert set(FrameKinds.__annotations__) == set(general_frames.GENERAL_KINDS)


def test_no_two_types_of_objects_have_one_name() -> None:
    """A schema knows them by their names alone."""
    modules = [
        import_module(each.name)
        for each in pkgutil.walk_packages(schemas.__path__, f"{schemas.__name__}.")
    ]
    kinds = {kind for module in modules for kind in vars(module).values() if is_typeddict(kind)}
    assert len({kind.__name__ for kind in kinds}) == len(kinds) > 100


@pytest.mark.parametrize("name", names())
def test_a_document_has_a_title_and_no_other_properties(name: str) -> None:
    document = result_schema(name)
    assert document["title"] and not document["title"].endswith(".")
    assert document["additionalProperties"] is False
    assert not any("title" in each for each in document["$defs"].values())


@ruled(**EXACTLY_ONE)
class _Choice(TypedDict, total=False):
    left: int
    right: int


class _Other(TypedDict):
    """Another."""

    z: Literal["only"]
    a: Annotated[Number, Meta(description="Here.")]


class _Document(TypedDict):
    """A document
    in two lines."""

    chosen: Either[_Choice, _Other, None]
    number: Number | None


def test_of_a_type_a_schema_is_made(monkeypatch: pytest.MonkeyPatch) -> None:
    kinds = {kind.__name__: kind for kind in (_Choice, _Other, _Document)}
    monkeypatch.setattr(make, "_classes", lambda: kinds)
    number = {"$ref": "#/$defs/Number"}
    made = make.made(_Document)
    assert made.pop("$defs")["Number"]["type"] == "string"
    assert made == {
        "$schema": make.DRAFT,
        "title": "A document in two lines",
        "type": "object",
        "properties": {
            "chosen": {
                "anyOf": [{"$ref": "#/$defs/_Choice"}, {"$ref": "#/$defs/_Other"}, {"type": "null"}]
            },
            "number": {"anyOf": [number, {"type": "null"}]},
        },
        "required": ["chosen", "number"],
        "additionalProperties": False,
    }
    parts = make.made(_Document)["$defs"]
    assert parts["_Choice"]["required"] == []
    assert {**parts["_Choice"], **EXACTLY_ONE} == parts["_Choice"]
    assert parts["_Other"] == {
        "type": "object",
        "description": "Another.",
        "properties": {"z": {"const": "only"}, "a": {**number, "description": "Here."}},
        "required": ["z", "a"],
        "additionalProperties": False,
    }
    assert list(parts["_Other"]["properties"]) == ["z", "a"]
