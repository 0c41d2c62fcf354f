"""Findings of `verify` and `shrink`, with their cases."""

from __future__ import annotations

from typing import Annotated, Literal, NotRequired, TypedDict

from minkref.schemas.grammar import Either, ruled
from minkref.schemas.space.values import Face
from minkref.schemas.values import Count, Digest, Number, PositiveCount, Rule
from msgspec import Meta

AnyPoint = Annotated[list[Number], Meta(min_length=2, max_length=3)]
Verdict = Literal[
    "wrong", "known", "errored", "crashed", "timed-out", "out-of-memory", "gave-up", "undecided"
]  # fmt: skip

Reason = Literal[
    "missing",
    "extra",
    "hole-lost",
    "hole-invented",
    "component",
    "not-closed",
    "self-intersecting",
    "not-canonical",
    "event-missed",
    "event-invented",
    "event-misplaced",
    "state-drift",
    "passage-missed",
    "passage-invented",
    "bar-missed",
    "bar-invented",
    "bridge-missed",
    "bridge-invented",
    "collision-missed",
    "collision-invented",
    "nondeterministic",
    "accepted-invalid",
    "rejected-valid",
]

CaseRing = list[AnyPoint]

# What is wrong of a library is shown by a point, and has a reason.
WRONG_IS_SHOWN = [
    {
        "if": {
            "properties": {
                "verdict": {"const": "wrong"},
                "target": {"not": {"pattern": "^minkref@"}},
            }
        },
        "then": {"properties": {"witness": {"type": "object"}}},
    },
    {
        "if": {"properties": {"verdict": {"const": "wrong"}}},
        "then": {"properties": {"reasons": {"minItems": 1}}},
    },
]


class Isolation(TypedDict):
    """The walls around the programs of others (docs/security.md)."""

    kind: Literal["sandbox", "none"]
    tool: Annotated[str | None, Meta(description="What makes the sandbox, with its version.")]
    why_none: Annotated[str | None, Meta(description="Why there is no sandbox.")]
    memory: Annotated[
        Literal["control group of version 1", "control group of version 2", "measured"],
        Meta(description="How the memory of all processes of a program is held to its limit."),
    ]
    processes: Annotated[
        Literal[
            "control group of version 1",
            "control group of version 2",
            "limit of its user",
            "limit of its user space",
            "not held",
        ],
        Meta(description="How the number of all processes of a program is held to its limit."),
    ]
    own_user: Annotated[
        bool,
        Meta(
            description="Without a sandbox, as root: whether each program runs as a user of its "
            "own."
        ),
    ]
    passed: Annotated[list[str], Meta(description="Variables handed on beside those of the list.")]


class Tolerance(TypedDict):
    """Absolute, and relative to the coordinates; of offsets, a part of the radius too."""

    absolute: str
    relative: str
    radius: NotRequired[str]


class FeatureClaim(TypedDict):
    """A bar, a bridge at the case's radius, a count of the alpha-shape, or a set refused."""

    kind: Literal["bar", "bridge", "shape", "set"]
    what: str
    in_set: Annotated[int, Meta(description="How many the set has; of shape, the count.")]
    in_answer: int
    nearest: Annotated[str | None, Meta(description="The bar most like an invented one.")]
    begins_at: Annotated[list[str] | None, Meta(description="Of a bar: near the birth's place.")]
    ends_at: Annotated[list[str] | None, Meta(description="Of a bar: near the death's place.")]


class Witness(TypedDict):
    """Inside: scale p + q = point. Outside: the scaled P does not meet the point less Q. Of a
    path: point + scale p = q, or at no place that decides does the part collide. For a union: a set
    has the point, or none has it. For an offset: the squared distance from the set. For features:
    what the set has, near the point."""

    point: AnyPoint
    in_truth: Annotated[bool, Meta(description="The point lies in the sum.")]
    p: AnyPoint | None
    q: AnyPoint | None
    scale: NotRequired[
        Annotated[Number, Meta(description="That of P here, where it is not the case's.")]
    ]
    tolerance: NotRequired[
        Annotated[
            Number,
            Meta(
                description="The whole square or cube of this half side around the point lies "
                "inside, or outside; for an offset, at each radius that differs by at most this."
            ),
        ]
    ]
    sum: NotRequired[
        Annotated[
            Literal["boundary"],
            Meta(description="p and q lie on the boundaries: the sum of these is meant."),
        ]
    ]
    contact: NotRequired[Annotated[Rule, Meta(description="Of a path: the rule.")]]
    on_path: NotRequired[
        Annotated[
            tuple[str, Number] | None,
            Meta(description="Segment of the path, and how far along it the place is."),
        ]
    ]
    places: NotRequired[
        Annotated[int | None, Meta(description="How many places decide that the part passes.")]
    ]
    sets: NotRequired[Annotated[int, Meta(description="For a union: how many sets it unites.")]]
    of_set: NotRequired[
        Annotated[
            int | None,
            Meta(description="The number of a set with the point, from 1; null if no set has it."),
        ]
    ]
    radius: NotRequired[
        Annotated[Number, Meta(description="For an offset: that of the disc; below 0, to erode.")]
    ]
    manner: NotRequired[
        Annotated[str, Meta(description="Joins and caps of an offset, if not all are round.")]
    ]
    squared_distance: NotRequired[
        Annotated[
            Number | None,
            Meta(
                description="From the set that is grown, or from the outside of one that is "
                "eroded; null where the set is empty."
            ),
        ]
    ]
    nearest: NotRequired[
        Annotated[
            list[str] | None,
            Meta(description="Its nearest feature: inside, outside, vertex x y, or edge x y x y."),
        ]
    ]
    feature: NotRequired[FeatureClaim]


class CasePolygon(TypedDict):
    holes: list[CaseRing]
    outer: CaseRing


class CaseSet(TypedDict):
    """A polygon set: outer rings counter-clockwise, holes clockwise."""

    polygons: list[CasePolygon]


class CasePolyhedron(TypedDict):
    vertices: CaseRing
    faces: list[Face]


class CaseOperand(TypedDict):
    name: str
    set: Annotated[
        Either[CaseSet, CasePolyhedron, None], Meta(description="In full where it is small.")
    ]


class WitnessCertificate(TypedDict):
    """The certificate of a witness, or why there is none."""

    file: Annotated[str | None, Meta(description="In the folder of --report, for `minkref check`.")]
    claim: Annotated[str | None, Meta(description="What it proves: about the point alone.")]
    why_none: str | None


@ruled(allOf=WRONG_IS_SHOWN)
class Finding(TypedDict):
    target: str
    target_version: str | None
    verdict: Verdict
    was: Annotated[
        Literal["wrong", "errored", "crashed", "timed-out", "out-of-memory", "gave-up", None],
        Meta(description="The verdict that the baseline turned into known."),
    ]
    reasons: list[Reason]
    message: str
    signal: str | None
    case: str
    group: str
    scale: Annotated[
        str, Meta(description="Of P: a number, or in space three with commas between.")
    ]
    P: CaseOperand
    Q: CaseOperand
    witness: Witness | None
    digest: Digest | None
    expected_digest: Digest | None
    reproduce: Annotated[str, Meta(description="The command line that shows it again.")]
    certificate: NotRequired[
        Annotated[
            WitnessCertificate,
            Meta(description="With --report, of a finding that it shows with a witness."),
        ]
    ]


@ruled(allOf=WRONG_IS_SHOWN)
class Shrunk(Finding):
    found_as: Annotated[str, Meta(description="The case that was shrunk, by name.")]
    count: Annotated[PositiveCount, Meta(description="Findings of this kind.")]
    calls: Annotated[Count, Meta(description="Of the target, to shrink it.")]
    complete: Annotated[bool, Meta(description="No step makes it smaller.")]
    stable: Annotated[bool, Meta(description="It showed again when asked again.")]
    call_seconds: Annotated[
        float | None,
        Meta(
            description="Of a time-out: the limit of the calls that made it small; the smallest "
            "case was asked with that of the run."
        ),
    ]
