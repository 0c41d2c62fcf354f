"""Scenes as values: a robot among placed, scaled copies of shapes."""

from __future__ import annotations

import os
from collections.abc import Iterable, Sequence
from dataclasses import dataclass
from fractions import Fraction
from functools import cached_property
from pathlib import Path
from typing import Any

from minkref import _core
from minkref.argument_types import expect_sets, number, truth, whole
from minkref.errors import Refusal, choice
from minkref.exact import digest, exact_scale
from minkref.plane.parents import EdgeRow
from minkref.plane.small_picture import small_picture
from minkref.scene.copies_text import CopyRow
from minkref.scene.free_values import (
    CONTACTS,
    FreeComponent,
    Holder,
    SceneGrowth,
    SceneWay,
    components_of,
    growth_of,
)
from minkref.scene.scene_file import read_scene_file
from minkref.scene.scene_input import (
    Copy,
    Number,
    Place,
    Sets,
    Shapes,
    place_of,
    row_of,
    rows_of,
    rows_of_columns,
    shapes_of,
)


@dataclass(frozen=True)
class Owner:
    """A copy on whose sum's boundary an edge lies, and the edge of the convolution there: `kind` S
    for an edge of the copy's shape at a vertex of the robot turned by 180 degrees, T for the
    reverse; `edge` and `vertex` by ring and index, as in events."""

    copy: int
    kind: str
    edge: tuple[int, int]
    vertex: tuple[int, int]


@dataclass(frozen=True)
class ScenePassage:
    """A tight passage of a scene: a point or a polyline. `owners`: for each segment, for a point
    alone once, the edges of sums that touch there."""

    points: tuple[Place, ...]
    owners: tuple[tuple[Owner, ...], ...]


class Scene:
    """A robot among obstacles, placed and scaled copies of shapes: the places at which the robot
    meets them, exact. A value: a change gives another scene, which redoes what the change touches.

    `shapes`: a mapping by name, or a sequence. The union of the sums of all copies and the robot
    turned by 180 degrees is found when it is first needed, on `threads`, and by changes; with
    `passages` also its tight passages, kept through changes. Every set is validated first. Robot
    and shape cannot both lack an area. Cost: each shape's sum once for each of its scales; then the
    edges of all sums, each with the sums near it. Raises BadInput; LimitExceeded if memory does not
    suffice. Behar & Lien 2012, Sec. 8.1; docs/scenes.md."""

    def __init__(
        self,
        robot: _core.PolygonSet,
        shapes: Sets,
        copies: Iterable[Copy] = (),
        *,
        passages: bool = False,
        threads: int = 1,
    ) -> None:
        read = _checked(robot, shapes)
        self._build(robot, read, rows_of(copies, read), passages, threads)

    @classmethod
    def of_arrays(
        cls,
        robot: _core.PolygonSet,
        shapes: Sets,
        numbers: Any,
        scales: Any,
        places: Any,
        *,
        passages: bool = False,
        threads: int = 1,
    ) -> Scene:
        """Make a scene from columns, arrays of NumPy or sequences: for each copy the number of its
        shape, its scale and its place, a row of an (n, 2) array. Floats count by their bits: 0.1 is
        the double next to a tenth. Raises as Scene."""
        read = _checked(robot, shapes)
        scene = cls.__new__(cls)
        rows = rows_of_columns(numbers, scales, places, read)
        scene._build(robot, read, rows, passages, threads)
        return scene

    def _build(
        self,
        robot: _core.PolygonSet,
        shapes: Shapes,
        rows: list[CopyRow],
        passages: bool,
        threads: int,
    ) -> None:
        self._robot, self._shapes, self._rows = robot, shapes, rows
        self._has_passages = truth("passages", passages)
        self._threads = max(1, whole("threads", threads))
        _ = self._questions  # refuses what is no scene

    def _union_of(self, passages: bool) -> _core.SceneUnion:
        return _core.SceneUnion(self._robot, self._shapes.sets, self._rows, passages, self._threads)

    @cached_property
    def _found(self) -> _core.SceneUnion:
        return self._union_of(self._has_passages)

    def _with(self, rows: list[CopyRow], found: _core.SceneUnion) -> Scene:
        other = type(self).__new__(type(self))
        other._robot, other._shapes, other._threads = self._robot, self._shapes, self._threads
        other._rows, other._has_passages = rows, self._has_passages
        other.__dict__["_found"] = found
        return other

    @property
    def robot(self) -> _core.PolygonSet:
        """The robot as given."""
        return self._robot

    @property
    def shapes(self) -> dict[str, _core.PolygonSet] | list[_core.PolygonSet]:
        """The shapes as given: by name, or in a list."""
        sets, names = self._shapes.sets, self._shapes.names
        return list(sets) if names is None else dict(zip(names, sets, strict=True))

    @property
    def copies(self) -> list[Copy]:
        """All copies in order. Linear."""
        names = None if self._shapes.names is None else list(self._shapes.names)
        return [
            Copy(shape if names is None else names[shape], scale, (x, y))
            for shape, scale, x, y in self._rows
        ]

    def union(self) -> _core.PolygonSet:
        """The closed C-obstacle: the places at which the robot meets an obstacle, in canonical
        form. Linear, once."""
        return self._found.region()

    @property
    def digest(self) -> str:
        """The SHA-256 of the union's canonical JSON: equal iff the sets are equal."""
        return digest(self.union().canonical_json())

    @property
    def components(self) -> int:
        """The number of connected components of the union's interior."""
        return self._found.components_of_set

    @property
    def holes(self) -> int:
        """The number of bounded connected components of the union's complement."""
        return self._found.holes

    def owners(self) -> list[list[list[Owner]]]:
        """Name all owners of each boundary edge: for each ring of the union (per polygon the outer
        ring, then its holes), for each side, from vertex i to i + 1, each copy whose sum has a part
        of the side on its boundary, with its edge of the convolution. Linear."""
        return [[[_owner(row) for row in side] for side in ring] for ring in self._found.owners()]

    def passages(self) -> list[ScenePassage]:
        """Find the tight passages: points and polylines inside the union at which the robot touches
        obstacles and collides with none, in canonical order. Linear for a scene made with
        `passages`; another one is built once more. docs/scenes.md."""
        return [
            ScenePassage(
                tuple((Fraction(x), Fraction(y)) for x, y in points),
                tuple(tuple(_owner(row) for row in side) for side in owners),
            )
            for points, owners in self._found_with_passages.passages()
        ]

    @cached_property
    def _found_with_passages(self) -> _core.SceneUnion:
        return self._found if self._has_passages else self._union_of(True)

    def free_components(self, contact: str = "allowed") -> list[FreeComponent]:
        """Find the free components by a rule of contact: `allowed` or `forbidden`.
        Component 0 is without bound. O(b log b) for b vertices; with contact allowed as passages().
        docs/scenes.md."""
        rule = _rule(contact)
        found = self._found_with_passages if rule == "allowed" else self._found
        return components_of(*found.free_components(rule))

    def holders(self, place: Sequence[Any]) -> list[Holder]:
        """Name the copies that the robot meets at a place, without the union. If none, the
        place is free with contact forbidden. Linear in boxes, and a point's decision for each copy
        near it."""
        return [Holder(*row) for row in self._questions.holders(*place_of("place", place))]

    def way(self, points: Sequence[Sequence[Any]], contact: str = "allowed") -> SceneWay:
        """Tell whether the robot may follow a polyline (a single point is a place), without the
        union, and which copies stop it. Takes the copies near the way."""
        free, stopped_by = self._questions.way(_path(points), _rule(contact))
        return SceneWay(free, tuple(stopped_by))

    def growth(
        self, points: Sequence[Sequence[Any]], contact: str = "allowed"
    ) -> SceneGrowth | None:
        """Find the largest factor by which all copies may grow, each about its own place, while a
        way stays free; None for a way already blocked. Closing seams stop thin robots that may
        touch. Cost: the copies near the way; for seams once more per factor at which a vertex
        meets the way."""
        return growth_of(self._questions.growth(_path(points), _rule(contact)))

    @cached_property
    def _questions(self) -> _core.SceneQuestions:
        return _core.SceneQuestions(self._robot, self._shapes.sets, self._rows)

    def sum_of(self, copy: int) -> _core.PolygonSet:
        """The sum of a single copy and the robot turned by 180 degrees, in canonical form."""
        return self._found.sum_of(self._number(copy))

    def change(
        self, copy: int, scale: Number | None = None, place: Sequence[Any] | None = None
    ) -> Scene:
        """Give the scene in which a copy has another scale, another place or both. Equal to the
        scene made anew; takes the copies that meet the old or the new sum. Raises BadInput."""
        at = self._number(copy)
        shape, factor, x, y = self._rows[at]
        if scale is not None:
            factor = str(exact_scale(number("scale", scale), "scale"))
        if place is not None:
            x, y = place_of("place", place)
        rows = [*self._rows[:at], CopyRow(shape, factor, x, y), *self._rows[at + 1 :]]
        return self._with(rows, self._found.changed(at, factor, x, y))

    def add(self, shape: str | int, scale: Number = 1, place: Sequence[Any] = (0, 0)) -> Scene:
        """Give the scene with one more copy, the last one. Takes the copies that meet its sum.
        Raises BadInput."""
        row = row_of(Copy(shape, scale, place), self._shapes, "add")
        return self._with([*self._rows, row], self._found.added(*row))

    def remove(self, copy: int) -> Scene:
        """Give the scene without a copy; later copies move up by one. Takes the copies that meet
        its sum. Raises BadInput."""
        at = self._number(copy)
        rows = [*self._rows[:at], *self._rows[at + 1 :]]
        return self._with(rows, self._found.removed(at))

    @property
    def counts(self) -> dict[str, int]:
        """The work behind this scene: all of it, or that of the last change."""
        return dict(self._found.counts())

    @property
    def copies_redone(self) -> int:
        """The number of copies whose boundary was looked at again to make this scene."""
        return self.counts["copies_redone"]

    def __eq__(self, other: object) -> bool:
        """Tell whether robot, shapes and copies are equal."""
        return isinstance(other, Scene) and self._parts() == other._parts()

    def __hash__(self) -> int:
        return hash((self._robot, tuple(self._shapes.sets), tuple(self._rows)))

    def _repr_svg_(self) -> str:
        """The picture of the union in a notebook."""
        return small_picture([self.union()], repr(self)[1:-1])

    def __repr__(self) -> str:
        copies, shapes = len(self._rows), len(self._shapes.sets)
        many = "copy" if copies == 1 else "copies"
        return f"<Scene: {copies:,} {many} of {shapes:,} shape{'' if shapes == 1 else 's'}>"

    def __copy__(self) -> Scene:
        return self

    def __deepcopy__(self, memo: object) -> Scene:
        return self

    def __reduce__(self) -> tuple[Any, ...]:
        given = (self._robot, self.shapes, self.copies, self._has_passages, self._threads)
        return _made_again, given

    def _parts(self) -> tuple[Any, ...]:
        return self._robot, self._shapes.names, self._shapes.sets, self._rows

    def _number(self, copy: Any) -> int:
        count = len(self._rows)
        if not 0 <= whole("copy", copy) < count:
            mend = f"choose a number from 0 to {count - 1}" if count else "add a copy first"
            raise Refusal(f"there is no copy {copy}", "copy", mend, "no-such-copy")
        return int(copy)


def read_scene(
    path: str | os.PathLike[str],
    copies: str | os.PathLike[str] | None = None,
    *,
    passages: bool = False,
    threads: int = 1,
) -> Scene:
    """Read and build the scene in a file (`scene-v1`, docs/formats.md). `copies`: a CSV file in
    place of its copies. Raises BadInput, and as Scene."""
    listed = None if copies is None else Path(os.fsdecode(copies))
    read = read_scene_file(os.fsdecode(path), listed)
    sets = [operand.set for operand in read.shapes.values()]
    shapes = Shapes(sets, {name: k for k, name in enumerate(read.shapes)})
    scene = Scene.__new__(Scene)
    scene._build(read.robot.set, shapes, read.copies, passages, threads)
    return scene


def _checked(robot: Any, shapes: Any) -> Shapes:
    """Validate the robot; read and validate the shapes."""
    expect_sets(robot=robot)
    robot.validate("robot")
    return shapes_of(shapes)


def _made_again(
    robot: _core.PolygonSet, shapes: Sets, copies: list[Copy], passages: bool, threads: int
) -> Scene:
    return Scene(robot, shapes, copies, passages=passages, threads=threads)


def _rule(contact: Any) -> str:
    if contact not in CONTACTS:
        raise Refusal(f"there is no rule {contact!r}", "contact", choice(str(contact), CONTACTS))
    return str(contact)


def _path(points: Sequence[Sequence[Any]]) -> list[tuple[str, str]]:
    return [place_of(f"vertex {k}", point) for k, point in enumerate(points)]


def _owner(row: tuple[int, EdgeRow]) -> Owner:
    copy, (kind, _, edge_ring, edge, vertex_ring, vertex) = row
    return Owner(copy, kind, (edge_ring, edge), (vertex_ring, vertex))
