"""The pages of `minkref view`: sizes, and drawn rings compared with the sum."""

from __future__ import annotations

import math
import random
import tempfile
import time
from fractions import Fraction
from pathlib import Path
from typing import Any

from minkref import _core
from minkref.disc.page import picture as disc_picture
from minkref.disc.page.write_page import page as disc_page
from minkref.fuzz.geometry.plane import read_shape
from minkref.output.documents import write_atomically
from minkref.plane.operand import Operand
from minkref.plane.page.boundary import Window
from minkref.plane.page.picture import picture
from minkref.plane.page.write_page import page
from minkref.reports.evidence.framework.browser import PACKAGES, absent, browser
from minkref.reports.evidence.framework.operands import operand, tell_absent
from minkref.reports.evidence.framework.part import Counts, Findings, Minutes, Size
from minkref.reports.evidence.pages.disc_rings import ring_difference, true_rings

MINUTES = Minutes(0.2, 0.6, 1)

SEED = 2012
PAIR = Counts(("g3", "g2"), ("disc1", "neuron"), ("disc1", "neuron"))
SCALES = Counts(4, 25, 50)
MOST_BYTES = 10_000_000
MOST_SECONDS = 10
CLOSE = 1e-9  # diagonals of the sum
RINGS = """return arguments[0].map(
    (s) => window.minkref.rings(s).map((polygon) => [polygon.outer, ...polygon.holes]))"""
MARKS = "return document.getElementById('marks').getAttribute('d').split('M').length - 1"
Polygons = list[list[list[tuple[float, float]]]]  # each polygon's outer ring, then holes
OFFSETS = """return arguments[0].map((r) => window.minkref.rings(r).map((ring) => ring.pieces))"""


def run(findings: Findings, size: Size) -> None:
    names = size.of(PAIR)
    P, Q = (operand(name) for name in names)
    tell_absent(findings, *names)
    began = time.perf_counter()
    data = picture(
        P.set,
        Q.set,
        Window("1/10", "10"),
        lambda: _core.ScaleIndex(P.set, Q.set, "1/10", "10"),
        lambda done, total: None,
    )
    text = page(P.name, Q.name, data)
    seconds = time.perf_counter() - began
    length = len(text.encode("utf-8"))
    findings.figures |= {
        "pair": f"{P.name} + {Q.name}",
        "bytes": length,
        "seconds to make": round(seconds, 2),
        "boundary events": len(data["scales"]),
        "topology events": len(data["topology"]),
        "tracks": len(data["tracks"]) // 4,
        "holes": len(data["holes"]) - 1,
    }
    findings.target(
        "seconds to make", seconds <= MOST_SECONDS, f"at most {MOST_SECONDS}", f"{seconds:.1f}"
    )
    findings.target(
        "bytes of the page", length <= MOST_BYTES, f"at most {MOST_BYTES:,}", f"{length:,}"
    )
    count = size.of(SCALES)
    reason = absent()
    if reason is not None:
        findings.note(f"install {' and '.join(PACKAGES)}, then run this part with --again")
        findings.target(f"rings at {count} scales in Chromium", False, "looked at", reason)
        return
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder, "view.html")
        write_atomically(path, text)
        _look(findings, path, data, (P.set, Q.set), count)
        _look_at_disc(findings, path.with_name("disc.html"), Q, count)


def _look(
    findings: Findings,
    path: Path,
    data: dict[str, Any],
    operands: tuple[_core.PolygonSet, _core.PolygonSet],
    count: int,
) -> None:
    dice = random.Random(SEED)
    scales = [math.exp(dice.uniform(math.log(0.1), math.log(10.0))) for _ in range(count)]
    with browser() as window:
        began = time.perf_counter()
        window.open(path)
        marks = window.run(MARKS)
        findings.figures["seconds to open"] = round(time.perf_counter() - began, 2)
        began = time.perf_counter()
        drawn = window.run(RINGS, scales)
        per_scale = (time.perf_counter() - began) / count
        findings.figures["milliseconds a scale"] = round(1000 * per_scale, 1)
        messages = window.messages()
    differences = [
        difference(got, true_polygons(*operands, scale))
        for scale, got in zip(scales, drawn, strict=True)
    ]
    alike = sum(found < CLOSE for found in differences)
    findings.equal("scales whose rings are those of the sum", count, alike)
    findings.figures["greatest difference, in diagonals"] = max(differences)
    events = len(data["scales"])
    findings.equal("marks, one for each boundary event", events, marks)
    findings.none("errors of the page", len(messages))


def true_polygons(P: _core.PolygonSet, Q: _core.PolygonSet, scale: float) -> Polygons:
    """The polygons of `minkref sum` at exactly this double."""
    text = _core.minkowski_sum(P, Q, str(Fraction(scale))).region.canonical_json()
    return [
        [[(float(x), float(y)) for x, y in ring] for ring in polygon]
        for polygon in read_shape(text)
    ]


def difference(got: Any, wanted: Polygons) -> float:
    """The greatest distance of a vertex from its true place, divided by the sum's diagonal;
    infinite if the rings differ."""
    if [[len(ring) for ring in polygon] for polygon in got] != [
        [len(ring) for ring in polygon] for polygon in wanted
    ]:
        return math.inf
    pairs = [
        (p, q)
        for one, other in zip(got, wanted, strict=True)
        for ring, true_ring in zip(one, other, strict=True)
        for p, q in zip(ring, true_ring, strict=True)
    ]
    points = [q for _, q in pairs]
    if not points:
        return 0.0
    sides = [max(q[i] for q in points) - min(q[i] for q in points) for i in (0, 1)]
    return max(math.dist(p, q) for p, q in pairs) / (math.hypot(*sides) or 1.0)


def _look_at_disc(findings: Findings, path: Path, P: Operand, count: int) -> None:
    dice = random.Random(SEED)
    index = _core.disc_index(P.set)
    first, last = disc_picture.window_around(index, P.set)
    data = disc_picture.picture(index, P.set, Window(str(first), str(last)))
    write_atomically(path, disc_page(P.name, data))
    # Radii near the events and somewhat beyond.
    radii = [dice.choice(data["radii"]) * dice.uniform(0.8, 1.3) for _ in range(count)]
    with browser() as window:
        window.open(path)
        marks = window.run(MARKS)
        drawn = window.run(OFFSETS, radii)
        messages = window.messages()
    differences = [
        ring_difference(got, true_rings(P.set, radius))
        for radius, got in zip(radii, drawn, strict=True)
    ]
    findings.figures |= {
        "bytes with a disc": path.stat().st_size,
        "parts of the diagram": len(data["halves"]) // 2,
        "greatest difference with a disc, in diagonals": max(differences),
    }
    alike = sum(found < CLOSE for found in differences)
    findings.equal("radii whose rings are those of the sum", count, alike)
    findings.equal("marks, one for each event with a disc", len(data["kinds"]), marks)
    findings.none("errors of the page with a disc", len(messages))
