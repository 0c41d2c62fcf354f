"""The Python interface: exact sets, their sums, and the difference between two sets.

Numbers are texts, `n` or `n/d`, or Python's exact numbers, int and Fraction. An argument with
another type raises TypeError, which says what is expected. Refused input raises BadInput, with the
attributes code, problem, mend, source, line, ring, vertices and coordinates. Sets are values: made
from coordinates, compared as point sets, copied and pickled. Source: docs/definitions.md.
"""

from __future__ import annotations

import os
import warnings
from collections.abc import Sequence
from fractions import Fraction
from pathlib import Path
from typing import Any

from minkref import _core
from minkref.argument_types import (
    check_methods,
    expect_bodies,
    expect_sets,
    expect_surfaces,
    factors,
    number,
    scale_text,
    surface_of,
    text_of,
    truth,
    whole,
)
from minkref.certify.motion.path_certificate import PathCertificate as PathCertificate
from minkref.certify.plane.certificate import Certificate as Certificate
from minkref.certify.plane.certificate import NoProof as NoProof
from minkref.certify.space.convex_certificate import ConvexCertificate as ConvexCertificate
from minkref.certify.space.solid_certificate import SolidCertificate as SolidCertificate
from minkref.certify.space.solid_point_certificate import (
    SolidPointCertificate as SolidPointCertificate,
)
from minkref.disc.closed import DiscClosing as DiscClosing
from minkref.disc.closed import closing_by_disc as closing_by_disc
from minkref.disc.closed import opening_by_disc as opening_by_disc
from minkref.disc.decomposition import Cut as Cut
from minkref.disc.decomposition import Decomposition as Decomposition
from minkref.disc.decomposition import Piece as Piece
from minkref.disc.decomposition import decompose as decompose
from minkref.disc.disc_index import DiscIndex as DiscIndex
from minkref.disc.disc_index import OffsetEvent as OffsetEvent
from minkref.disc.disc_index import inradius as inradius
from minkref.disc.disc_index import square_of
from minkref.disc.feature_regions import FeatureRegion as FeatureRegion
from minkref.disc.feature_regions import FeatureRest as FeatureRest
from minkref.disc.feature_regions import RegionsAt as RegionsAt
from minkref.disc.feature_regions import RestArc as RestArc
from minkref.disc.features import Bridge as Bridge
from minkref.disc.features import BridgeTrack as BridgeTrack
from minkref.disc.features import FeatureBar as FeatureBar
from minkref.disc.features import FeatureNode as FeatureNode
from minkref.disc.features import Features as Features
from minkref.disc.features import LiveFeature as LiveFeature
from minkref.disc.features import Notch as Notch
from minkref.disc.features import features as features
from minkref.drawings.drawing import is_drawing, read_drawing
from minkref.errors import Refusal as Refusal
from minkref.motion.clear_fits import ClearTrap as ClearTrap
from minkref.motion.clear_fits import clear_fits as clear_fits
from minkref.motion.clear_fits import clear_trap as clear_trap
from minkref.motion.clear_values import ClearBound as ClearBound
from minkref.motion.clear_values import ClearRange as ClearRange
from minkref.motion.clear_values import ClearScales as ClearScales
from minkref.motion.clear_values import RootScale as RootScale
from minkref.motion.clear_values import clear_fit as clear_fit
from minkref.motion.clear_values import clear_scales as clear_scales
from minkref.motion.disc_radii import DiscContact as DiscContact
from minkref.motion.disc_radii import DiscRadii as DiscRadii
from minkref.motion.disc_radii import DiscRadius as DiscRadius
from minkref.motion.disc_radii import largest_disc as largest_disc
from minkref.motion.disc_radii import trapped_radii as trapped_radii
from minkref.motion.disc_radii import valid_radii as valid_radii
from minkref.motion.held_values import HeldEnd as HeldEnd
from minkref.motion.held_values import HeldRange as HeldRange
from minkref.motion.held_values import HeldScales as HeldScales
from minkref.motion.held_values import SpaceHeldScales as SpaceHeldScales
from minkref.motion.held_values import held_scales as held_scales
from minkref.motion.path_values import BadPolygon as BadPolygon
from minkref.motion.path_values import Feature as Feature
from minkref.motion.path_values import FreeBound as FreeBound
from minkref.motion.path_values import FreeScales as FreeScales
from minkref.motion.path_values import PathBound as PathBound
from minkref.motion.path_values import ScaleRange as ScaleRange
from minkref.motion.path_values import ValidScales as ValidScales
from minkref.motion.path_values import bad_polygons as bad_polygons
from minkref.motion.path_values import largest_fit as largest_fit
from minkref.motion.path_values import trapped_scales as trapped_scales
from minkref.motion.path_values import valid_scales as valid_scales
from minkref.motion.scale_bracket import ScaleBracket as ScaleBracket
from minkref.motion.space_values import FitSupport as FitSupport
from minkref.motion.space_values import SpaceFeature as SpaceFeature
from minkref.motion.space_values import SpaceFitScales as SpaceFitScales
from minkref.motion.space_values import SpaceFreeBound as SpaceFreeBound
from minkref.motion.space_values import SpaceFreeScales as SpaceFreeScales
from minkref.motion.space_values import SpacePathBound as SpacePathBound
from minkref.motion.space_values import SpaceValidScales as SpaceValidScales
from minkref.offset_picture import show_values as show_offsets
from minkref.plane.convolution_values import Convolution as Convolution
from minkref.plane.convolution_values import ConvolutionEdge as ConvolutionEdge
from minkref.plane.convolution_values import convolution as convolution
from minkref.plane.erosion import Erosion as Erosion
from minkref.plane.erosion import NoFit as NoFit
from minkref.plane.erosion import closing as closing
from minkref.plane.erosion import erode as erode
from minkref.plane.erosion import inner_fit as inner_fit
from minkref.plane.erosion import no_fit as no_fit
from minkref.plane.erosion import opening as opening
from minkref.plane.event_values import Event as Event
from minkref.plane.event_values import Events as Events
from minkref.plane.event_values import events as events
from minkref.plane.operand import is_utf8, read_set
from minkref.plane.parents import passage_values, place_of
from minkref.plane.shown_values import show_values as show_sums
from minkref.scene.free_values import FreeCell as FreeCell
from minkref.scene.free_values import FreeComponent as FreeComponent
from minkref.scene.free_values import Holder as Holder
from minkref.scene.free_values import SceneGrowth as SceneGrowth
from minkref.scene.free_values import SceneSeam as SceneSeam
from minkref.scene.free_values import SceneStop as SceneStop
from minkref.scene.free_values import SceneWay as SceneWay
from minkref.scene.scene_input import Copy as Copy
from minkref.scene.scene_values import Owner as Owner
from minkref.scene.scene_values import Scene as Scene
from minkref.scene.scene_values import ScenePassage as ScenePassage
from minkref.scene.scene_values import read_scene as read_scene
from minkref.space.ball_sum import Between as Between
from minkref.space.ball_values import Ball as Ball
from minkref.space.ball_values import ball_sum as ball_sum
from minkref.space.remaining_values import ball_erosion as ball_erosion
from minkref.space.remaining_values import polyhedral_closing as polyhedral_closing
from minkref.space.remaining_values import polyhedral_erosion as polyhedral_erosion
from minkref.space.remaining_values import polyhedral_opening as polyhedral_opening
from minkref.space.shown_values import show_values as show_convex_sums

BadInput = _core.BadInput
ConvexPolyhedron = _core.ConvexPolyhedron
ConvexSum = _core.ConvexSum
LimitExceeded = _core.LimitExceeded
Offset = _core.Offset
PolygonSet = _core.PolygonSet
PolyhedralSet = _core.PolyhedralSet
Polyhedron = _core.Polyhedron
ScaleIndex = _core.ScaleIndex
Sum = _core.Sum
UndecidedSign = _core.UndecidedSign
check_methods()
for show in (show_sums, show_offsets, show_convex_sums):
    show()

Number = str | int | Fraction
PlaneScale = Number | Sequence[Number]


def minkowski_sum(
    P: PolygonSet,
    Q: PolygonSet,
    scale: PlaneScale = 1,
    route: str = "paper",
    arithmetic: str = "rational",
) -> Sum:
    """Compute the Minkowski sum of P, scaled by `scale` > 0 about the origin, and Q. `scale`: one
    factor, or two, one for each axis.

    With the arithmetic `rational` the sum is exact and in canonical form; `interval` is exact or
    raises UndecidedSign; `double` and `mpfr:BITS` may be wrong, and raise UndecidedSign if a value
    is no number. The routes `paper`, `winding` and `definition` give the same set; other
    arithmetics work only with `paper`. Both operands are validated first; they may be open lines.
    The result finds its `tight_passages` when first asked. The route `paper` takes O((N + k) log
    N), N the size of the reduced convolution, k its crossings. Raises BadInput for an invalid
    operand, scale, route or arithmetic. Behar & Lien, "Dynamic Minkowski Sums Under Scaling", 2012,
    Sec. 3."""
    _validate(True, P=P, Q=Q)
    s = scale_text("scale", scale)
    return _core.minkowski_sum(P, Q, s, text_of("route", route), text_of("arithmetic", arithmetic))


def offset(
    P: PolygonSet,
    radius: Number | None = None,
    squared_radius: Number | None = None,
    threads: int = 1,
    route: str = "definition",
) -> Offset:
    """Compute the Minkowski sum of P and a disc about the origin, given by `radius` > 0 or by the
    radius's square: a region bounded by segments and arcs, with components, holes, area and length
    (each between two doubles) and a canonical form with rational numbers.

    P may be points and segments, and is validated first. Exact: uses intervals of doubles, and
    square roots where intervals do not decide. O(n log n + k) for k pairs of an offset curve and an
    edge that may be nearer to the curve than the radius. The routes `definition` and `paper` give
    the same; `paper` takes the convolution's faces with a positive winding number, on one thread,
    and needs O((n + k) log n) for k pairs of curves. Raises BadInput. Behar & Lien 2012, Sec. 3 and
    Appendix; docs/disc.md."""
    _validate(True, P=P)
    square = square_of(radius, squared_radius, "offset")
    return _core.offset(P, square, max(1, whole("threads", threads)), text_of("route", route))


def inset(
    P: PolygonSet,
    radius: Number | None = None,
    squared_radius: Number | None = None,
    threads: int = 1,
    route: str = "definition",
) -> Offset:
    """Erode P by a disc about the origin, given by `radius` > 0 or by the radius's square: all
    places at least the radius away from P's outside. `tight_passages` lists the remnants, points
    and segments beside the region. Exact; computed as offset computes sums, for P's outside. Empty
    for a segment or a point. Raises BadInput. docs/erosion.md."""
    _validate(P=P)
    square = square_of(radius, squared_radius, "inset")
    return _core.inset(P, square, max(1, whole("threads", threads)), text_of("route", route))


def convex_sum(
    P: ConvexPolyhedron,
    Q: ConvexPolyhedron,
    scaling: Number | Sequence[Number] = 1,
    route: str = "traversal",
) -> ConvexSum:
    """Compute the Minkowski sum of P, scaled about the origin, and Q, exactly and in canonical
    form: its `surface`, and the vertices of P and Q behind each vertex and facet. `scaling`: one
    positive factor, or one for each axis. The routes `traversal` and `brute-force` give the same.
    Raises BadInput. Behar & Lien 2012, Sec. 6; docs/convex-polyhedra.md."""
    expect_bodies(P=P, Q=Q)
    return _core.convex_sum(P, Q, factors("scaling", scaling), text_of("route", route))


def polyhedral_sum(
    P: Polyhedron | ConvexPolyhedron,
    Q: Polyhedron | ConvexPolyhedron,
    scaling: Number | Sequence[Number] = 1,
    route: str = "edges",
    threads: int = 1,
) -> PolyhedralSet:
    """Compute the Minkowski sum of polyhedra of any shape, P scaled about the origin and Q, exactly
    and in canonical form. `scaling`: one positive factor, or one for each axis. Either operand may
    be a plane polygon (a single face), a segment or a point; an empty operand gives an empty sum.
    The routes `edges` and `definition`, which takes no plane polygon, give the same set; `edges`
    runs on `threads`. Both operands are validated first. Raises BadInput, LimitExceeded. Behar &
    Lien 2012, Sec. 3 and 5; docs/space-sums.md."""
    surfaces = surface_of("P", P), surface_of("Q", Q)
    by, chosen = factors("scaling", scaling), text_of("route", route)
    count = max(1, whole("threads", threads))
    for name, surface in zip("PQ", surfaces, strict=True):
        surface.validate_summand(name)
    if chosen == "definition":
        for name, surface in zip("PQ", surfaces, strict=True):
            if surface.faces == 1:
                surface.validate(name)
        return _core.definition_sum_in_space(*surfaces, by)
    if chosen != "edges":
        raise Refusal(f"there is no route {chosen!r}", "route", "choose edges or definition")
    return _core.edge_sum_in_space(*surfaces, by, count)


def build_index(
    P: PolygonSet,
    Q: PolygonSet,
    from_scale: Number | None = None,
    to_scale: Number | None = None,
    threads: int = 1,
    lazy: bool = False,
) -> ScaleIndex:
    """Index all scales: finds the sums of P, scaled by any factor in the closed window, and Q once
    for all. A single sum then takes microseconds: in doubles with a certain error, in integers, or
    exactly; so do areas, holes and components, and events.

    Without bounds, all scales above 0. A `lazy` index answers by static sums at first, and is built
    when they have cost as much, or when a question needs the index (tracks, events, lives, `save`);
    `is_built` tells. Exact. Both operands are validated first. Cost: docs/scale-index.md. Raises
    BadInput; LimitExceeded if memory does not suffice."""
    _validate(True, P=P, Q=Q)
    bounds = (("from_scale", from_scale), ("to_scale", to_scale))
    first, last = (None if bound is None else number(name, bound) for name, bound in bounds)
    count = max(1, whole("threads", threads))
    return _core.ScaleIndex(P, Q, first, last, count, lazy=truth("lazy", lazy))


def open_index(path: str | os.PathLike[str]) -> ScaleIndex:
    """Open an index written by `ScaleIndex.save` or `minkref index`. The index copies the file,
    which may change afterwards. Linear in the file's length. Raises BadInput for a damaged file or
    another kind of file. docs/formats.md."""
    return _core.ScaleIndex.open(os.fsdecode(path))


def read_mesh(path: str | os.PathLike[str]) -> Polyhedron:
    """Read the polyhedron in a file, exactly as written; the ending gives the format (`.off`,
    `.obj`, `.stl`, `.ply`, `.json`). Not validated: PolyhedralSet(...) validates, and
    ConvexPolyhedron(...) also certifies convexity. Linear. Raises BadInput. docs/formats.md."""
    return _core.read_mesh_file(os.fsdecode(path))[0]


def write_mesh(surface: Polyhedron, format: str, *, triangles: bool = False) -> str:
    """Write a polyhedron as `off`, `obj`, `stl`, `ply` or `json`. `json` is exact; other formats
    round numbers that are no decimals to doubles. With `triangles`, cuts faces into triangles with
    positive area. O(n log n). Raises BadInput. docs/formats.md."""
    expect_surfaces(surface=surface)
    mesh = surface.cut_into_triangles() if triangles else surface
    return _core.write_mesh(mesh, text_of("format", format))


def set_memory_limit(bytes: int | None) -> None:
    """Limit the process's memory while a sum, events or an index are computed: a number of bytes,
    or None for nine tenths of the memory free when the work begins. Work that needs more raises
    LimitExceeded with the code `memory-limit`, before the work begins if the need is known then,
    else as soon as the limit is passed; unfinished results are lost. The limit holds for all
    threads, from the next call on. Raises Refusal for a number below one."""
    if bytes is not None and whole("bytes", bytes) < 1:
        what = f"it has to be a number of bytes, or None, not {bytes}"
        raise Refusal(what, "set_memory_limit", "give 4 << 30 for four GiB")
    _core.set_memory_limit(bytes or 0)


def tight_passages(P: PolygonSet, Q: PolygonSet, scale: PlaneScale = 1) -> list[dict[str, Any]]:
    """Find the points and polylines inside the sum of P, scaled by `scale` > 0 about the origin,
    and Q that the sum of their interiors misses: `points`, pairs of Fractions, and for each segment
    the features in `contacts`, as in `minkref sum --json`. Exact, in canonical order. Both operands
    are validated first. Takes the time to build the reduced convolution's arrangement, and one
    decision for each part where shapes may touch from all sides. Raises BadInput.
    docs/definitions.md, "Tight passages"."""
    _validate(True, P=P, Q=Q)
    return passage_values(_core.tight_passages(P, Q, scale_text("scale", scale)))


def sum_remnants(P: PolygonSet, Q: PolygonSet, scale: PlaneScale = 1) -> list[dict[str, Any]]:
    """Find the points and polylines of the sum of P, scaled by `scale` > 0, and Q beside its
    region: none unless both are points and segments. Exact, in canonical order, without contacts.
    Takes O(mn) pairs beside the time of the sum. Raises BadInput. docs/definitions.md."""
    region = minkowski_sum(P, Q, scale).region
    if any(each.is_region or each.is_empty for each in (P, Q)):
        return []
    return passage_values(_core.sum_remnants(P, Q, scale_text("scale", scale), region))


def read_file(path: str | os.PathLike[str]) -> PolygonSet:
    """Read the polygon set in a file, exactly as written; the ending gives the format (`.wkt`,
    `.geojson`, `.poly`, `.json`; `.dxf` and `.svg` without curves). Not validated. The set's
    `warnings` tell what the reader dropped; those of a drawing are issued (UserWarning). Linear in
    the file's length. Raises BadInput (Refusal for a file whose name is not UTF-8, and for
    drawings). docs/formats.md."""
    name = os.fsdecode(path)
    if is_drawing(Path(name)):
        found, told = read_drawing(Path(name))
        for each in told:
            warnings.warn(each, UserWarning, stacklevel=2)
        return found
    return _core.read_file(name) if is_utf8(name) else read_set(Path(name))


def read_text(text: str, format: str, source: str = "") -> PolygonSet:
    """Read the polygon set in a `wkt`, `geojson`, `poly`, `json` or `case` text, exactly as
    written; refusals call the text `source`. Not validated. Linear in the length. Raises BadInput.
    docs/formats.md."""
    given = {"text": text, "format": format, "source": source}
    return _core.read_text(*(text_of(name, value) for name, value in given.items()))


def write(set: PolygonSet, format: str) -> str:
    """Write a set as `wkt`, `geojson`, `poly`, `json` or `svg`. `json` is exact; other formats know
    only decimals and round other numbers to doubles. Linear. Raises BadInput for another format,
    and for a set that the format cannot hold. docs/formats.md."""
    expect_sets(set=set)
    return _core.write(set, text_of("format", format))


def decide(P: PolygonSet, Q: PolygonSet, scale: PlaneScale, x: Number, y: Number) -> dict[str, Any]:
    """Decide whether scale P + Q contains the point (x, y), exactly and from the definition:
    `contact` says how scale P and the point less Q meet (`empty`, `touching`, `overlapping`), and
    `p`, `q`, pairs of Fractions, give scale p + q = (x, y) if they do. O(mn) pairs of triangles,
    after both operands' validation. Raises BadInput. docs/definitions.md."""
    _validate(True, P=P, Q=Q)
    found = _core.decide(P, Q, scale_text("scale", scale), number("x", x), number("y", y))
    return {**found, **{name: place_of(found[name]) for name in "pq" if found[name]}}


def difference(first: PolygonSet, second: PolygonSet) -> dict[str, Any] | None:
    """Find an interior point of the symmetric difference (`point`, a pair of Fractions), and
    whether it lies `in_first`; None for equal sets. Exact. Takes the time to build a winding number
    arrangement of both boundaries, after both sets' validation. Raises BadInput.
    docs/definitions.md."""
    _validate(first=first, second=second)
    found = _core.difference(first, second)
    return None if found is None else {**found, "point": place_of(found["point"])}


def unite(sets: Sequence[PolygonSet]) -> PolygonSet:
    """The union, in canonical form; empty of no sets. Exact. O((n + k) log n) for n vertices and k
    crossings. Raises BadInput for invalid sets. docs/definitions.md."""
    return _combined("union", sets)


def intersect(sets: Sequence[PolygonSet]) -> PolygonSet:
    """The closure of what the interiors of all sets share, in canonical form. As unite."""
    return _combined("intersection", sets)


def subtract(first: PolygonSet, others: Sequence[PolygonSet]) -> PolygonSet:
    """The closure of `first` without the others, in canonical form. As unite."""
    _validate(first=first)
    return _combined("difference", [first, *others])


def _combined(operation: str, sets: Sequence[PolygonSet]) -> PolygonSet:
    _validate(False, **{f"set {number}": each for number, each in enumerate(sets)})
    return _core.combined(operation, sets)[0]


def _validate(lines: bool = False, /, **operands: PolygonSet) -> None:
    expect_sets(**operands)
    for name, operand in operands.items():
        operand.validate(name, lines)
