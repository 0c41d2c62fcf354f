"""The entry on Fig. 12: concave features of a beetle at 20 diameters of a disc."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from fractions import Fraction
from statistics import median
from typing import Any

from minkref import _core
from minkref.plane.operand import read_operand
from minkref.reports.bench.growing_disc import BEETLE, COUNT, LEAST, MOST, REPETITIONS, Timed, timed
from minkref.reports.paper.entry import Claim, Entry, Picture, Table
from minkref.reports.paper.growing_disc_drawn import pieces_drawn, pockets_drawn

COMMAND = "minkref report paper"
TITLE = "Concave features and the decomposition of a beetle"
DOUBLE, MPFR = "double", "mpfr:53"
STATED = 68.556  # times faster
DRAWN = ("1/20", "1/5", "2/5")  # diameters of Fig. 12 (a) to (c)
LASTING = Fraction(3, 5)  # of the range in (d); the paper does not say


def figure_12(quick: bool, tell: Callable[[str], None]) -> Entry:
    """Times the Appendix's program in doubles and in MPFR, and counts features."""
    return entry(
        [timed(arithmetic, tell) for arithmetic in ([DOUBLE] if quick else [MPFR, DOUBLE])]
    )


def entry(runs: Sequence[Timed]) -> Entry:
    """The entry for the runs, at least one."""
    why = (
        f"The Appendix's own program, each sentence in its right form: the walk through the events "
        f"of pairs of arcs and segments, upwards over {COUNT} diameters evenly spaced from "
        f"{LEAST} to {MOST}, with the places of all intersections, against the search among all "
        f"pairs at each diameter in the same arithmetic. {REPETITIONS} repetitions, which take "
        "both in turn. Pocket minima and cuts are those of docs/features.md: the paper defines "
        "neither. Readings of features off the index of all radii stand beside CGAL's offsets in "
        "the evidence (features/times)."
    )
    unlike = [
        "the beetle: ours has 156 vertices; the paper's is not published",
        "the number of diameters and their spacing: the paper gives none",
        "the decomposition: the paper does not say how cuts are made",
    ]
    columns = ["arithmetic", "arcs and segments", "events", "intersections", "from scratch (ms)",
               "steps (ms)", "update (ms)", "speed-up", "least", "greatest", "pre-processing (ms)",
               "diameters that pay it back"]  # fmt: skip
    rows = [_row(run) for run in runs]
    return Entry("Fig. 12", TITLE, why, COMMAND, _claims(runs), unlike, _pictures(),
                 [Table("figure12", columns, rows)])  # fmt: skip


def _row(run: Timed) -> list[object]:
    ratios = run.speedup()
    return [
        run.arithmetic, run.curves, run.events, run.intersections,
        f"{1e3 * median(run.scratch):.2f}", f"{1e3 * median(run.stepped):.3f}",
        f"{1e3 * median(run.update):.3f}", f"{median(ratios):.1f}", f"{ratios[0]:.1f}",
        f"{ratios[-1]:.1f}", f"{1e3 * run.preprocessing:.1f}", f"{run.pays_after():.0f}",
    ]  # fmt: skip


def _claims(runs: Sequence[Timed]) -> list[Claim]:
    """In the first arithmetic, the paper's own if it was timed."""
    run, ratios = runs[0], runs[0].speedup()
    P = read_operand(BEETLE).set
    features = _core.features(P)
    alive = [len(features.at(diameter)) for diameter in DRAWN]
    small, large = features.at("1/1000000"), features.at("1000000")
    reflex = sum(1 for node in features.nodes() if node[5] is not None)
    gaps = sum(high[0] == "infinity" for _, high, *_ in features.tracks(0, features.track_count))
    return [
        Claim("The speed-up for the decomposition of the polygons shown in Fig. 12 using the "
              "proposed method is 68.556 over that of repetitive re-computation of the Minkowski "
              "sums", "Sec. 8.2",
              f"{run.arithmetic}: the median speed-up is at least {STATED}",
              f"{median(ratios):,.1f} times ({ratios[0]:,.1f} to {ratios[-1]:,.1f})",
              median(ratios) >= STATED),
        Claim("Several concave features disappear after α increases from 0.05 to 0.2", "Fig. 12",
              "two features at least are gone",
              f"features at α = {', '.join(_decimal(d) for d in DRAWN)}: "
              + ", ".join(map(str, alive)), alive[0] - alive[1] >= 2),
        Claim("when α = 0, the bridges correspond to the reflex vertices and when α = ∞, the "
              "bridges correspond to the convex hull edges of the polygon", "Sec. 8.2",
              "a bridge for each reflex vertex at α = 1/1000000, and one for each gap of the hull "
              "at α = 1000000",
              f"{_bridges(small)} bridges and {reflex} reflex vertices; {_bridges(large)} bridges "
              f"and {gaps} gaps", (_bridges(small), _bridges(large)) == (reflex, gaps)),
    ]  # fmt: skip


def _bridges(features: Sequence[tuple[Any, ...]]) -> int:
    return sum(len(row[4]) for row in features)


def _decimal(diameter: str) -> str:
    return f"{float(Fraction(diameter)):g}"


def _pictures() -> list[Picture]:
    P = read_operand(BEETLE).set
    return [
        *(
            Picture(f"({letter}) α = {_decimal(diameter)}: the sum with the disc, its corners, and "
                    "from each the deepest vertex of its feature", pockets_drawn(P, diameter))
            for letter, diameter in zip("abc", DRAWN, strict=True)
        ),
        Picture(f"(d) the pieces, cut where a feature of α = {_decimal(str(LEAST))} lasts for "
                f"more than {_decimal(str(LASTING))} up to α = {MOST}",
                pieces_drawn(P, LEAST, MOST, LASTING)),
    ]  # fmt: skip
