"""Each installed adapter on known sums, unions, offsets, features; skips others by name."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from itertools import pairwise
from math import pi
from typing import Any

import pytest
from minkref.fuzz.libraries import catalogue

Ring = list[list[int]]
Set = dict[str, Any]


def box(x: int, y: int, side: int) -> Ring:
    return [[x, y], [x + side, y], [x + side, y + side], [x, y + side]]


def plane(*polygons: list[Ring]) -> Set:
    return {"polygons": [{"outer": p[0], "holes": [h[::-1] for h in p[1:]]} for p in polygons]}


def prism(ring: Ring, height: int, base: int = 0) -> Set:
    n = len(ring)
    sides = [[i, (i + 1) % n, n + (i + 1) % n, n + i] for i in range(n)]
    return {
        "vertices": [[x, y, z] for z in (base, base + height) for x, y in ring],
        "faces": [list(range(n))[::-1], list(range(n, 2 * n)), *sides],
    }


def tunnel() -> Set:
    """A plate, 9 by 9 by 1, with a 3 by 3 tunnel."""
    vertices = [[x, y, z] for z in (0, 1) for x, y in box(0, 0, 9) + box(3, 3, 3)]
    faces = []
    for i in range(4):
        k = (i + 1) % 4
        faces += [[8 + i, 8 + k, 12 + k, 12 + i], [k, i, 4 + i, 4 + k]]
        faces += [[i, k, 8 + k, 8 + i], [4 + k, 4 + i, 12 + i, 12 + k]]
    return {"vertices": vertices, "faces": faces}


def joined(first: Set, second: Set, inwards: bool = False) -> Set:
    shift = len(first["vertices"])
    moved = [[i + shift for i in face] for face in second["faces"]]
    faces = [face[::-1] for face in moved] if inwards else moved
    vertices = first["vertices"] + second["vertices"]
    return {"vertices": vertices, "faces": first["faces"] + faces}


L = [[0, 0], [3, 0], [3, 1], [1, 1], [1, 3], [0, 3]]
UNIT, FRAME = plane([box(0, 0, 1)]), plane([box(0, 0, 9), box(3, 3, 3)])
PAIR = plane([box(0, 0, 1)], [box(9, 9, 1)])
THIN, WIDE = plane([box(0, 0, 9), box(1, 1, 7)]), plane([box(0, 0, 5), box(1, 1, 3)])
CUBE, BLOCK = prism(box(0, 0, 1), 1), prism(box(0, 0, 9), 9)
# Operands, the capabilities that the case needs, and the area of the regions' sum.
PLANE = {
    "squares": (UNIT, UNIT, set(), 4),
    "negative": (plane([box(-7, -3, 2)]), UNIT, set(), 9),
    "L and square": (plane([L]), UNIT, {"non-convex"}, 12),
    "L and L": (plane([L]), plane([L]), {"non-convex"}, 24),
    "frame and square": (FRAME, UNIT, {"non-convex", "holes"}, 96),
    "thin frame and frame": (THIN, WIDE, {"non-convex", "holes"}, 192),
    "pair and square": (PAIR, UNIT, {"non-convex", "components"}, 8),
    "square and pair": (UNIT, PAIR, {"non-convex", "components"}, 8),
}
# Sets, the capabilities that the case needs, and the area of the union.
UNIONS = {
    "overlapping": ([plane([box(0, 0, 2)]), plane([box(1, 1, 2)])], set(), 7),
    "abutting": ([plane([box(0, 0, 2)]), plane([box(2, 0, 2)]), plane([box(4, 1, 2)])], set(), 12),
    "equal": ([UNIT, UNIT, UNIT], set(), 1),
    "in the hole": ([FRAME, plane([box(4, 4, 1)])], {"non-convex", "holes"}, 73),
    "filled": ([FRAME, plane([box(3, 3, 3)])], {"non-convex", "holes"}, 81),
    "pair and bridge": ([PAIR, plane([box(0, 0, 9)])], {"non-convex", "components"}, 82),
}
# A set, the radius, the capabilities that the case needs, the area, and the number of curves.
OFFSETS = {
    "square": (plane([box(0, 0, 2)]), 1, set(), 12 + pi, 8),
    "frame": (FRAME, 1, {"non-convex", "holes"}, 116 + pi, 12),
    "filled frame": (FRAME, 2, {"non-convex", "holes"}, 153 + 4 * pi, 8),
    "pair": (PAIR, 1, {"non-convex", "components"}, 10 + 2 * pi, 16),
}
# The areas of the boundaries' sums.
CURVES = {"squares": 4, "negative": 8, "L and square": 12}
SPACE = {
    "cubes": (CUBE, CUBE, set(), 8),
    "L and cube": (prism(L, 1), CUBE, {"non-convex"}, 24),
    "L and L": (prism(L, 1), prism(L, 1), {"non-convex"}, 48),
    "tunnel": (tunnel(), CUBE, {"non-convex", "holes"}, 192),
    "cavity": (joined(BLOCK, prism(box(3, 3, 3), 3, 3), True), CUBE, {"non-convex", "holes"}, 992),
    "pair": (joined(CUBE, prism(box(9, 9, 1), 1)), CUBE, {"non-convex", "components"}, 16),
    "touching pair": (joined(CUBE, prism(box(2, 2, 1), 1)), CUBE, {"non-convex", "components"}, 16),
}


@pytest.fixture(params=filter(catalogue.in_all, catalogue.ADAPTERS))
def adapter(request: pytest.FixtureRequest, converse: Callable[[list[str]], Any]) -> Any:
    """A conversation with an installed adapter, except programs that are wrong by design.
    Boost.Polygon is compiled if missing: the project requires its headers."""
    name = request.param
    if name == "boost-polygon":
        catalogue.install(name)
    reason = catalogue.absence(name)
    command = catalogue.command(name)
    if command is None:
        pytest.skip(str(reason))
    return converse(command)


def said(value: Any, hello: dict[str, Any]) -> Any:
    """Numbers in the adapter's form; face indices stay numbers."""
    if isinstance(value, dict):
        return {k: v if k == "faces" else said(v, hello) for k, v in value.items()}
    if isinstance(value, list):
        return [said(item, hello) for item in value]
    return float(value) if hello.get("numbers", "text") == "double" else str(value)


def area(answer: dict[str, Any]) -> Fraction:
    rings = answer.get("rings")
    if rings is None:
        rings = [ring for p in answer["polygons"] for ring in (p["outer"], *p["holes"])]
    total = Fraction()
    for ring in rings:
        points = [(Fraction(x), Fraction(y)) for x, y in ring]
        pairs = zip(points[-1:] + points, points, strict=False)
        total += sum(a * d - b * c for (a, b), (c, d) in pairs)
    return abs(total) / 2


def volume(answer: dict[str, Any]) -> Fraction:
    """Volume inside a surface; each edge must be run as often forwards as backwards."""
    points = [[Fraction(x) for x in vertex] for vertex in answer["vertices"]]
    edges: dict[tuple[int, int], int] = {}
    total = Fraction()
    for face in answer["faces"]:
        for k, i in enumerate(face):
            edge = (face[k - 1], i)
            edges[edge] = edges.get(edge, 0) + 1
        for j, k in pairwise(face[1:]):
            (a, b, c), (d, e, f), (g, h, m) = points[face[0]], points[j], points[k]
            total += a * (e * m - f * h) - b * (d * m - f * g) + c * (d * h - e * g)
    assert all(edges.get((j, i)) == count for (i, j), count in edges.items())
    return total / 6


def test_known_sums(adapter: Any) -> None:
    hello = adapter.hello()
    able = set(hello["capabilities"])
    assert able & {"plane", "space"}
    for kind, table, measure in (("plane", PLANE, area), ("space", SPACE, volume)):
        for name, (P, Q, needs, expected) in table.items():
            if not needs | {kind} <= able or hello["sum"] == "none":
                continue
            if hello["sum"] == "boundary":
                if name not in CURVES:
                    continue
                expected = CURVES[name]
            answer = adapter.sum(said(P, hello), said(Q, hello))
            assert answer["status"] == "result", (name, answer)
            slack = 0 if hello["arithmetic"] == "exact" else Fraction(1, 100)
            assert abs(measure(answer) - expected) <= slack * expected, name
    assert adapter.stop() == 0


def test_known_unions(adapter: Any) -> None:
    """Without `load`, and one after the other."""
    hello = adapter.hello()
    if "union" not in hello["capabilities"]:
        others = {"offset", "join-sharp", "features", "path"}
        assert hello["sum"] != "none" or others & set(hello["capabilities"])
        assert adapter.ask("union", dimension=2, sets=[])["status"] == "skipped"
        return
    for name, (sets, needs, expected) in UNIONS.items():
        if needs <= set(hello["capabilities"]):
            answer = adapter.ask("union", dimension=2, sets=[said(each, hello) for each in sets])
            assert answer["status"] == "result", (name, answer)
            assert area(answer) == expected, name
    for wrong in (5, [5], [{"polygons": [{"outer": 7}]}]):
        answer = adapter.ask("union", dimension=2, sets=wrong)
        assert answer["status"] in ("errored", "skipped"), (wrong, answer)
    assert adapter.stop() == 0


def test_known_offsets(adapter: Any) -> None:
    """Without `load`; polygons by their area, curves by their number."""
    hello = adapter.hello()
    square = said(UNIT, hello)
    if "offset" not in hello["capabilities"]:
        answer = adapter.ask("offset", dimension=2, P=square, radius=said(1, hello))
        assert answer["status"] == "skipped"
        return
    for name, (P, radius, needs, expected, count) in OFFSETS.items():
        if not needs <= set(hello["capabilities"]):
            continue
        words = {"P": said(P, hello), "radius": said(radius, hello)}
        answer = adapter.ask("offset", dimension=2, **words)
        assert answer["status"] == "result", (name, answer)
        if "components" in answer:
            rings = [r for c in answer["components"] for r in (c["outer"], *c["holes"])]
            assert sum(map(len, rings)) == count, name
        else:
            assert abs(float(area(answer)) - expected) < 0.02 * expected, name
    answer = adapter.ask("offset", dimension=2, P=5, radius=said(1, hello))
    assert answer["status"] in ("errored", "skipped", "gave-up")
    assert adapter.stop() == 0


def test_known_sharp_offsets(adapter: Any) -> None:
    """A frame grows, and its hole becomes smaller, or the other way round."""
    hello = adapter.hello()
    for capability, radius, expected in (("join-sharp", 1, 120), ("inset-sharp", -1, 24)):
        if capability in hello["capabilities"]:
            words = {"P": said(FRAME, hello), "radius": said(radius, hello), "join": "sharp"}
            answer = adapter.ask("offset", dimension=2, **words)
            assert answer["status"] == "result", answer
            assert abs(area(answer) - expected) < Fraction(1, 10**6)


def test_known_paths(adapter: Any) -> None:
    """A unit square between two blocks two apart passes until it is twice as large."""
    hello = adapter.hello()
    if "path" not in hello["capabilities"] or not catalogue.is_named(hello["name"]):
        return
    blocks = plane([box(-5, 0, 4)], [box(1, 0, 4)])
    square = plane([[[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]]])  # type: ignore[list-item]
    words = {"dimension": 2, "P": said(square, hello), "Q": said(blocks, hello)}
    assert adapter.ask("load", **words)["status"] == "result"
    path, scales = said([[0, -3], [0, 2], [0, 7]], hello), ["1/2", "1", "7/4", "9/4"]
    answer = adapter.ask("path", path=path, contact="allowed", scales=scales)
    assert answer["valid"] == [True, True, True, False]


def test_known_features(adapter: Any) -> None:
    """The frame's hole has four corners and is filled at once."""
    hello = adapter.hello()
    words = {"P": said(FRAME, hello), "radius": said(1, hello)}
    answer = adapter.ask("features", dimension=2, **words)
    if "features" not in hello["capabilities"]:
        assert answer["status"] == "skipped"
        return
    assert answer["status"] == "result", answer
    bars = [(number(birth), number(death)) for birth, death in answer["bars"]]
    assert bars == [(0, pytest.approx(1.5))] * 4
    assert answer.get("holes", 1) == 1
    assert adapter.stop() == 0


def number(radius: Any) -> float:
    if isinstance(radius, dict):
        return float(Fraction(radius["square"])) ** 0.5
    return float(Fraction(radius[0] if isinstance(radius, list) else radius))


def test_lines_that_are_no_requests(adapter: Any) -> None:
    for line in ("garbage", "[1, 2]", "7", "{}", '{"verb": 5}', '{"verb": "load"}'):
        answer = adapter.line(line)
        assert answer["seq"] is None
        assert answer["status"] in ("errored", "skipped")
    hello = adapter.hello()
    without = "skipped" if hello["sum"] == "none" else "errored"
    assert adapter.ask("at", scale="1")["status"] == without
    for wrong in ({}, {"polygons": 5}, {"polygons": [{}]}, {"vertices": [[1]], "faces": [[7]]}):
        answer = adapter.ask("load", dimension=2, P=wrong, Q=wrong)
        if answer["status"] == "result":
            answer = adapter.ask("at", scale="1", sP=wrong)
        assert answer["status"] in ("errored", "skipped"), (wrong, answer)
    hello = adapter.hello()
    assert (hello["status"], hello["protocol"]) == ("result", "adapter-v1")


def test_sets_that_are_not_declared_harm_nothing(adapter: Any) -> None:
    hello = adapter.hello()
    flat = "plane" in hello["capabilities"]
    odd = (
        [plane(), plane([[[1, 2]]]), plane([[[0, 0], [1, 1]]])]
        if flat
        else [{"vertices": [], "faces": []}]
    )
    unit = UNIT if flat else CUBE
    for P, Q in [(a, b) for one in odd for a, b in ((one, unit), (unit, one), (one, one))]:
        answer = adapter.sum(said(P, hello), said(Q, hello))
        assert answer["status"] in ("result", "skipped", "errored")
    answer = adapter.sum(said(unit, hello), said(unit, hello))
    assert answer["status"] == ("skipped" if hello["sum"] == "none" else "result")
