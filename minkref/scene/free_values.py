"""Free places of a scene as values: components, a place, a way, room to grow."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from fractions import Fraction
from typing import Any

from minkref.scene.scene_input import Place

CONTACTS = ("allowed", "forbidden")
Feature = tuple[str, int, int]


@dataclass(frozen=True)
class FreeCell:
    """A connected component of the union's complement: rings in canonical form, `outer` None
    without bound."""

    outer: tuple[Place, ...] | None
    holes: tuple[tuple[Place, ...], ...]


@dataclass(frozen=True)
class FreeComponent:
    """A component of the free places. Number 0 has no bound; a component without cells is a tight
    passage."""

    number: int
    cells: tuple[FreeCell, ...]


@dataclass(frozen=True)
class Holder:
    """A copy that the robot meets at a place; `contact`: touching or overlapping."""

    copy: int
    contact: str


@dataclass(frozen=True)
class SceneWay:
    """Whether the robot may go a way, and the copies that stop it by themselves; nobody does where
    a seam between copies stops a robot without area."""

    free: bool
    stopped_by: tuple[int, ...]


@dataclass(frozen=True)
class SceneStop:
    """The contact at which growing copies stop the robot: the copy, the robot's place on the way
    (`segment`, `t`, `at`), the features (vertex or edge, ring, index) of robot and copy that touch,
    and where."""

    copy: int
    segment: int
    t: Fraction
    at: Place
    robot: Feature
    shape: Feature
    touching: Place


@dataclass(frozen=True)
class SceneSeam:
    """Copies that stop a thin robot together, none alone; its place on the way (`segment`, `t`,
    `at`); `touching`: a point inside their union that it would pass."""

    copies: tuple[int, ...]
    segment: int
    t: Fraction
    at: Place
    touching: Place


@dataclass(frozen=True)
class SceneGrowth:
    """How far all copies may grow by one `factor`, each about its own place, while a way stays
    free; None: without bound. `included`: still free at the factor itself, and not just above it.
    Either a `stop` or a `seam` ends it."""

    factor: Fraction | None
    included: bool
    stop: SceneStop | None
    seam: SceneSeam | None = None


CellRow = tuple[int, Sequence[tuple[str, str]], Sequence[Sequence[tuple[str, str]]]]


def components_of(count: int, cells: Sequence[CellRow]) -> list[FreeComponent]:
    """All components from rows of `_core.SceneUnion.free_components`. Linear."""
    own: list[list[FreeCell]] = [[] for _ in range(count)]
    for component, outer, holes in cells:
        cell = FreeCell(_ring(outer) if outer else None, tuple(map(_ring, holes)))
        own[component].append(cell)
    return [FreeComponent(number, tuple(found)) for number, found in enumerate(own)]


def growth_of(row: tuple[Any, ...] | None) -> SceneGrowth | None:
    """The growth from a row of `_core.SceneQuestions.growth`."""
    if row is None:
        return None
    factor, included, stop, seam = row
    if seam is not None:
        copies, segment, t, at, touching = seam
        made = SceneSeam(tuple(copies), segment, Fraction(t), _point(at), _point(touching))
        return SceneGrowth(Fraction(factor), included, None, made)
    if stop is None:
        return SceneGrowth(None, included, None)
    copy, segment, t, at, robot, shape, touching = stop
    found = SceneStop(
        copy, segment, Fraction(t), _point(at), _feature(robot), _feature(shape), _point(touching)
    )
    return SceneGrowth(Fraction(factor), included, found)


def _feature(row: tuple[bool, int, int]) -> Feature:
    is_edge, ring, index = row
    return ("edge" if is_edge else "vertex", ring, index)


def _point(row: tuple[str, str]) -> Place:
    return Fraction(row[0]), Fraction(row[1])


def _ring(points: Sequence[tuple[str, str]]) -> tuple[Place, ...]:
    return tuple(map(_point, points))
