"""The pictures of the real pairs: operands, reduced convolution, sum."""

from __future__ import annotations

from dataclasses import dataclass

from minkref import _core
from minkref.fuzz.cases.case_name import CaseName
from minkref.fuzz.run.case_list import REAL_PAIRS
from minkref.fuzz.run.naming import load_in_plane
from minkref.model_catalogue import all_models, or_look_alike
from minkref.reports.drawing import Layer, picture


@dataclass(frozen=True)
class Showcase:
    title: str
    text: str
    pictures: list[tuple[str, str]]  # caption, SVG


def showcases() -> list[Showcase]:
    """Showcases for each real pair at hand, at scale 1."""
    known = all_models()
    pairs = [(or_look_alike(P, known), or_look_alike(Q, known)) for P, Q in REAL_PAIRS]
    return [show(P, Q) for P, Q in pairs if P in known and Q in known]


def show(P: str, Q: str) -> Showcase:
    case = load_in_plane(CaseName(f"{P}+{Q}@1", ""))
    answer = _core.minkowski_sum(case.P, case.Q, "1")
    segments = _core.convolution_segments(case.P, case.Q, "1", True)
    sizes = answer.statistics
    text = (
        f"{case.P.vertices:,} and {case.Q.vertices:,} vertices; reduced convolution "
        f"{sizes['s_edges']:,} S-edges and {sizes['t_edges']:,} T-edges; sum "
        f"{answer.region.vertices:,} vertices, {answer.components} component"
        f"{'' if answer.components == 1 else 's'}, {answer.holes} hole"
        f"{'' if answer.holes == 1 else 's'}; {answer.seconds:.3f} s by the paper's route."
    )
    captions = [
        (P, [Layer("first", case.P.approximate_rings())]),
        (Q, [Layer("second", case.Q.approximate_rings())]),
        ("reduced convolution", [Layer("convolution", segments=segments)]),
        (f"{P} + {Q}", [Layer("sum", answer.region.approximate_rings())]),
    ]
    pictures = [(caption, picture(layers, caption)) for caption, layers in captions]
    return Showcase(f"{P} + {Q}", text, pictures)
