"""The page of `minkref view` in space: what it shows, as JSON that its scripts read, in one file
that needs nothing else."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterator
from fractions import Fraction
from typing import Any

from minkref.errors import Refusal
from minkref.exact import in_double_range
from minkref.output.terminal import escaped
from minkref.page.template import json_for_script, page_template
from minkref.space.operand import SpaceOperand
from minkref.space.scaling import Scaling
from minkref.space.space_sum import SpaceSum
from minkref.space.sums import sum_fields

KINDS = ("fv", "vf", "ee", "facet+edge", "edge+facet", "facet+facet")
STEPS = ("fv_errors", "vf_errors", "ee_errors", "descent_steps", "chains_walked")
MOST_BYTES = 100_000_000  # of the frames in a page

Triple = tuple[Fraction, Fraction, Fraction]
_FACES = {
    (3, 1): "fv", (1, 3): "vf", (2, 2): "ee",
    (3, 2): "facet+edge", (2, 3): "edge+facet", (3, 3): "facet+facet",
}  # fmt: skip


class Body:
    """An operand: `data` is what the page has of it."""

    def __init__(self, operand: SpaceOperand) -> None:
        surface = operand.canonical()
        points = surface.points()
        low, high = ([end(axis) for axis in zip(*points, strict=True)] for end in (min, max))
        self.centre = _triple((b + a) / 2 for a, b in zip(low, high, strict=True))
        self.sides = _triple(b - a for a, b in zip(low, high, strict=True))
        self.data = {
            "name": escaped(operand.name),
            "points": surface.written_points(),
            "near": [
                [
                    float((axis - middle) / (side or 1))
                    for axis, middle, side in zip(point, self.centre, self.sides, strict=True)
                ]
                for point in points
            ],
            "faces": surface.rings(),
        }
        if operand.body is None:  # no fan of triangles fills a face that is not convex
            self.data["triangles"] = surface.triangles()


class FrameBox:
    """The box of a sum, which is the sum of the boxes; `data` is what a frame has of it."""

    def __init__(self, scale: list[str], P: Body, Q: Body) -> None:
        scaling = [Fraction(factor) for factor in scale]
        scaled = _triple(s * side for s, side in zip(scaling, P.sides, strict=True))
        sides = _triple(p + q for p, q in zip(scaled, Q.sides, strict=True))
        self.size = max(sides)
        self.centre = _triple(
            s * p + q for s, p, q in zip(scaling, P.centre, Q.centre, strict=True)
        )
        self.data = {
            "P": [float(side / self.size) for side in scaled],
            "Q": [float(side / self.size) for side in Q.sides],
            "size": in_double_range(str(self.size)),
            "centre": [in_double_range(str(axis)) for axis in self.centre],
        }


def frame_row(scaling: Scaling, answer: SpaceSum, did: dict[str, Any]) -> dict[str, Any]:
    """The row of a frame for both the document and the page."""
    found = Counter(kind_of(*parents) for parents in answer.facet_parents)
    return {
        "scale": list(scaling),
        **sum_fields(answer),
        "kinds": {kind: found[kind] for kind in KINDS},
        **{name: did[name] for name in STEPS},
    }


def kind_of(P: list[int], Q: list[int]) -> str:
    """The kind of a facet that is the sum of these faces, given by their vertices."""
    return _FACES[min(len(P), 3), min(len(Q), 3)]


def frame_text(row: dict[str, Any], answer: SpaceSum, P: Body, Q: Body) -> str:
    """A frame of the page: its row, and what is drawn."""
    return json_for_script(
        {
            **row,
            **FrameBox(row["scale"], P, Q).data,
            "pairs": [number for pair in answer.vertex_parents for number in pair],
            "rings": answer.surface.rings(),
        }
    )


class Frames:
    """The texts of the frames, as many as a page can hold."""

    def __init__(self, wanted: int) -> None:
        self.texts: list[str] = []
        self._wanted = wanted
        self._bytes = 0

    def add(self, text: str) -> None:
        self._bytes += len(text)
        if self._bytes > MOST_BYTES:
            raise self._refusal()
        self.texts.append(text)

    def _refusal(self) -> Refusal:
        held = len(self.texts)
        most = f"{MOST_BYTES // 10**6} MB, the most that a page takes"
        if held == 0:
            mend = "take operands with fewer vertices"
            return Refusal(f"one frame has more than {most}", "minkref view", mend, "limit")
        return Refusal(
            f"{held:,} of the {self._wanted:,} frames fill {most}",
            "--scales",
            f"give a file with at most {held:,} scales",
            "limit",
        )


def viewer() -> str:
    """The text of plotly.js. Refuses where the package plotly is missing."""
    try:
        from plotly.offline import get_plotlyjs
    except ModuleNotFoundError as error:
        mend = "install the package plotly: pip install 'minkref[view]'"
        raise Refusal("a package is missing", str(error.name), mend, "missing-package") from error
    return str(get_plotlyjs())


def viewer_name() -> str:
    from plotly.offline import get_plotlyjs_version

    return f"plotly.js {get_plotlyjs_version()}"


def page(P: Body, Q: Body, frames: Frames, library: str, events: str = "null") -> Iterator[str]:
    """The pieces of the file. `events`: what the axis of events is drawn from, as JSON."""
    template, usual = page_template("space")
    pieces: Iterator[str] = template.generate(
        P=P.data["name"],
        Q=Q.data["name"],
        operands=json_for_script({"P": P.data, "Q": Q.data}),
        frames=frames.texts,
        events=events,
        viewer=viewer_name(),
        library=library,
        **usual,
    )
    return pieces


def _triple(axes: Iterator[Fraction]) -> Triple:
    x, y, z = axes
    return x, y, z
