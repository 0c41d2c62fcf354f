"""Entries for Fig. 1 to 6: the paper's figures, drawn from our data."""

from __future__ import annotations

from minkref import _core
from minkref.plane.operand import read_operand
from minkref.reports.bench.pairs import SMALL, Pair
from minkref.reports.paper import drawings, moving_edges_drawn, space_drawn
from minkref.reports.paper.entry import Claim, Entry

COMMAND = "minkref report paper"
SIZES = (30, 34, 24, 43, 145)
OF_OURS = "Drawn from data of ours of the same kind."
NO_COORDINATES = ["the data are ours, for the paper gives no coordinates"]


def drawn_entries(disc: Pair, absent: str) -> list[Entry]:
    """The entries; `absent` is the remark for missing paper models."""
    figures = (
        ("Fig. 2", "Two polygons, their convolution and reduced convolution", drawings.figure_2()),
        ("Fig. 3", "T-edges and S-edges", moving_edges_drawn.figure_3()),
        ("Fig. 4", "Contacts of parallel faces", space_drawn.figure_4()),
        ("Fig. 5", "Errors of convex polyhedra", space_drawn.figure_5()),
    )
    return [
        _figure_1(disc, absent),
        *(Entry(place, title, OF_OURS, COMMAND, claims, NO_COORDINATES, pictures)
          for place, title, (pictures, claims) in figures),
        _figure_6(),
    ]  # fmt: skip


def _figure_1(pair: Pair, absent: str) -> Entry:
    holes = [_core.minkowski_sum(pair.P.set, pair.Q.set, scale).holes for scale in ("1", "2")]
    claim = Claim("The topology of the Minkowski sum changes between scales", "Fig. 1",
                  "the holes of the sum at s = 1 and s = 2",
                  f"{holes[0]} and {holes[1]} holes", holes[0] != holes[1])  # fmt: skip
    unlike = [*[absent] * bool(absent), "the disc, whose size the paper does not give: ours has a "
              "radius of 1 % of the neuron's extent"]  # fmt: skip
    return Entry("Fig. 1", "Sums and convolutions at the scales 1 and 2", "", COMMAND, [claim],
                 unlike, drawings.figure_1(pair))  # fmt: skip


def _figure_6() -> Entry:
    found = tuple(read_operand(name).set.vertices for name in SMALL)
    claim = Claim("The figure shows the names and the sizes of the polygons", "Fig. 6",
                  f"our g1 to g4 and dog145 have {', '.join(map(str, SIZES))} vertices too",
                  ", ".join(map(str, found)), found == SIZES)  # fmt: skip
    return Entry("Fig. 6", "Five small polygons", "", COMMAND, [claim],
                 ["the polygons are ours, for the paper's are not published"],
                 drawings.figure_6())  # fmt: skip
