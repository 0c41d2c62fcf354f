"""The outer Voronoi diagram of a polygon set, by CGAL's segment Delaunay graph and by
Boost.Polygon."""

from __future__ import annotations

import math
from collections.abc import Callable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from itertools import combinations
from pathlib import Path
from typing import Any, Self

from minkref.fuzz.cgal.executables import BUILD_COMMAND, built_folders, search_folders
from minkref.fuzz.cgal.line_process import LineProcess
from minkref.fuzz.features.outline import Feature, Outline, distance, height

CGAL, BOOST = "CGAL", "Boost"
_PROGRAMS = {CGAL: "minkref-cgal-diagram", BOOST: "minkref-boost-diagram"}
_BUILD = {CGAL: BUILD_COMMAND, BOOST: BUILD_COMMAND.replace("minkref_cgal", _PROGRAMS[BOOST])}
ROUNDED = 64 * 2.0**-53  # times a coordinate, by Boost
LARGEST = 2**31 - 1  # largest coordinate for Boost


@dataclass(frozen=True)
class Vertex:
    """A vertex off the boundary and outside the set. `features`: three or more, with the set's
    straight vertices replaced by the lines through them."""

    x: float
    y: float
    radius: float
    features: frozenset[Feature]


@dataclass(frozen=True)
class DiagramAnswer:
    """`vertices` is None without an answer, and then `why` gives the reason. `sides`: pairs of
    features on both sides of a diagram edge. `straight` counts vertices made by straight vertices
    of the set; `seconds` counts the library's functions only."""

    vertices: list[Vertex] | None
    sides: frozenset[frozenset[Feature]] = frozenset()
    straight: int = 0
    seconds: float = 0.0
    why: str = ""


@dataclass(frozen=True)
class DiagramEdge:
    """Two sites, and numbers of places at both ends; -1: a segment's end, or infinity."""

    sites: tuple[Feature, Feature]
    ends: tuple[int, int]
    is_infinite: bool


@dataclass(frozen=True)
class DiagramGraph:
    """All of a diagram, inside too: places with x, y and radius, and edges, some without length."""

    places: list[tuple[float, float, float]]
    edges: list[DiagramEdge]


def executable(judge: str) -> Path | None:
    folders = search_folders() if judge == CGAL else built_folders("boost")
    paths = (folder / _PROGRAMS[judge] for folder in folders)
    return next((path for path in paths if path.is_file()), None)


def absence(judge: str) -> str | None:
    """Names the missing program, and the command that builds it."""
    return None if executable(judge) else f"{_PROGRAMS[judge]} is not built: {_BUILD[judge]}"


class DiagramJudge:
    """CGAL or Boost, in a child process for many sets. Close it, or use `with`. CGAL's places are
    doubles next to exact places; Boost's are doubles, most within 64 units in the last place, and
    Boost's coordinates are integers of 32 bits."""

    def __init__(self, judge: str, seconds: float) -> None:
        path = executable(judge)
        self.judge = judge
        self._process = None if path is None else LineProcess(path, seconds)

    def __enter__(self) -> Self:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        if self._process is not None:
            self._process.close()

    def vertices(self, outline: Outline) -> DiagramAnswer:
        answer = self._asked(outline, edges=False)
        if isinstance(answer, str):
            return DiagramAnswer(None, why=answer)
        return _outer(outline, self.judge, answer)

    def graph(self, outline: Outline) -> DiagramGraph | str:
        """Returns the whole diagram, or why there is none."""
        answer = self._asked(outline, edges=True)
        if isinstance(answer, str):
            return answer
        feature = _by_number(outline) if self.judge == BOOST else _by_coordinates(outline)
        places = []
        for each in answer["vertices"]:
            x, y = (float(c) / outline.factor for c in each["at"])
            if self.judge == CGAL:
                far = math.sqrt(each["squared_radius"]) / outline.factor
            else:
                far = distance((x, y), feature(each["sites"][0]))
            places.append((x, y, far))
        edges = [
            DiagramEdge((feature(a), feature(b)), (each["ends"][0], each["ends"][1]),
                        each["infinite"])
            for each in answer["edges"]
            for a, b in [each["sites"]]
        ]  # fmt: skip
        return DiagramGraph(places, edges)

    def _asked(self, outline: Outline, edges: bool) -> dict[str, Any] | str:
        """Returns the program's answer, or why there is none."""
        if self._process is None:
            return str(absence(self.judge))
        segments = outline.integers()
        if self.judge == BOOST and max(map(max, segments)) > LARGEST:
            return "coordinates have more than 32 bits"
        sent: Any = segments
        if self.judge == CGAL:
            sent = [[str(c) for c in segment] for segment in segments]
        answer: dict[str, Any] = self._process.ask({"segments": sent, "edges": edges})
        return str(answer["error"]) if "error" in answer else answer


def _outer(outline: Outline, judge: str, answer: dict[str, Any]) -> DiagramAnswer:
    feature = _by_number(outline) if judge == BOOST else _by_coordinates(outline)
    ends = {(a, b) for x, y, u, v in outline.integers() for a, b in ((x, y), (u, v))}
    found, straight = [], 0
    sides: set[frozenset[Feature]] = set()
    for each in answer["vertices"]:
        x, y = (float(c) / outline.factor for c in each["at"])
        features = {feature(site) for site in each["sites"]}
        far = distance((x, y), next(iter(features)))
        if judge == CGAL:
            far = math.sqrt(each["squared_radius"]) / outline.factor
        elif _is_at_end(each["at"], ends):
            continue
        if not outline.is_outside(x, y):
            continue
        kept = _without_straight(outline, features, (x, y))
        sides |= {frozenset(pair) for pair in combinations(kept, 2)}
        if len(kept) < 3:
            straight += 1
            continue
        found.append(Vertex(x, y, far, kept))
    return DiagramAnswer(found, frozenset(sides), straight, float(answer["seconds"]))


def _by_number(outline: Outline) -> Callable[[Sequence[int]], Feature]:
    """Names a site of Boost's: an open segment, or an end."""

    def feature(site: Sequence[int]) -> Feature:
        piece = outline.pieces[site[0]]
        if len(site) == 1:
            return piece.line
        return ("vertex", *(piece.end if site[1] else piece.start))

    return feature


def _by_coordinates(outline: Outline) -> Callable[[Sequence[str]], Feature]:
    """A site of CGAL's: a point, or an open segment, either way round."""
    lines: dict[tuple[str, ...], Feature] = {}
    for piece, (a, b, c, d) in zip(outline.pieces, outline.integers(), strict=True):
        for ends in ((a, b, c, d), (c, d, a, b)):
            lines[tuple(map(str, ends))] = piece.line

    def feature(site: Sequence[str]) -> Feature:
        if len(site) == 4:
            return lines[tuple(site)]
        return ("vertex", *(Fraction(c) / outline.factor for c in site))

    return feature


def _is_at_end(at: Sequence[float], ends: set[tuple[int, int]]) -> bool:
    """Whether a vertex of Boost's lies at a segment end, with distance zero."""
    end = round(at[0]), round(at[1])
    return end in ends and math.dist(at, end) <= ROUNDED * max(1, *end)


def _without_straight(
    outline: Outline, features: set[Feature], spot: tuple[float, float]
) -> frozenset[Feature]:
    """Replaces the set's straight vertices by the lines through them, for places in front of such a
    line, where the vertex counts as no feature."""
    kept = set()
    for feature in features:
        lines = [line for line in outline.straight.get(feature, []) if height(spot, line) > 0]
        kept |= set(lines) or {feature}
    return frozenset(kept)
