"""Entries for Fig. 1 to 6: the paper's figures, drawn from our data."""

from __future__ import annotations

from minkref import _core
from minkref.plane.operand import read_operand
from minkref.reports.bench.pairs import SMALL, Pair
from minkref.reports.paper import drawings, moving_edges_drawn, space_drawn
from minkref.reports.paper.entry import Claim, Entry

COMMAND = "minkref report paper"
SIZES = (30, 34, 24, 43, 145)
OF_OURS = "Drawn from data of ours of the same kind; the paper gives no coordinates."


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
        *(Entry(place, title, OF_OURS, COMMAND, claims, pictures=pictures)
          for place, title, (pictures, claims) in figures),
        _figure_6(),
    ]  # fmt: skip


def _figure_1(pair: Pair, absent: str) -> Entry:
    holes = [_core.minkowski_sum(pair.P.set, pair.Q.set, scale).holes for scale in ("1", "2")]
    why = (
        "The size of the paper's disc is not given; ours has a radius of 1 % of the neuron's "
        f"extent. {absent}"
    )
    claim = Claim("the topology of the sum changes between s = 1 and s = 2",
                  f"{holes[0]} and {holes[1]} holes", holes[0] != holes[1])  # fmt: skip
    return Entry("Fig. 1", "Sums and convolutions at the scales 1 and 2", why.strip(), COMMAND,
                 [claim], pictures=drawings.figure_1(pair))  # fmt: skip


def _figure_6() -> Entry:
    found = tuple(read_operand(name).set.vertices for name in SMALL)
    claim = Claim(f"g1 to g4 and dog have {', '.join(map(str, SIZES))} vertices",
                  ", ".join(map(str, found)), found == SIZES)  # fmt: skip
    return Entry("Fig. 6", "Five small polygons", "The paper's polygons are not published.",
                 COMMAND, [claim], pictures=drawings.figure_6())  # fmt: skip
