"""Every public function and method refuses values of a wrong type in plain words; Python's exact
numbers are numbers, floats are not."""

from __future__ import annotations

from collections.abc import Callable
from fractions import Fraction
from pathlib import Path
from typing import Any

import minkref
import pytest

SQUARE = minkref.read_text("POLYGON((0 0,1 0,1 1,0 1,0 0))", "wkt")
WRONG: list[Any] = [None, 3.5, float("nan"), b"1", [], {}, object(), True, "text", 7, SQUARE]
NUMBERS = (str, int, Fraction)
SURFACES = (minkref.Polyhedron, minkref.ConvexPolyhedron)

SIMPLEX = minkref.Polyhedron(
    [(0, 0, 0), (1, 0, 0), (0, 1, 0), (0, 0, 1)], [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]]
)
BODY = minkref.ConvexPolyhedron(SIMPLEX)
BALL = minkref.Ball(1)
sum_, decide, at = minkref.minkowski_sum, minkref.decide, SQUARE.translated
CALLS: dict[str, tuple[Callable[[Any], Any], tuple[type, ...]]] = {
    "minkowski_sum P": (lambda x: sum_(x, SQUARE), (minkref.PolygonSet,)),
    "minkowski_sum Q": (lambda x: sum_(SQUARE, x), (minkref.PolygonSet,)),
    "minkowski_sum scale": (lambda x: sum_(SQUARE, SQUARE, x), NUMBERS),
    "minkowski_sum route": (lambda x: sum_(SQUARE, SQUARE, 1, x), (str,)),
    "minkowski_sum arithmetic": (lambda x: sum_(SQUARE, SQUARE, 1, "paper", x), (str,)),
    "convolution P": (lambda x: minkref.convolution(x, SQUARE), (minkref.PolygonSet,)),
    "convolution Q": (lambda x: minkref.convolution(SQUARE, x), (minkref.PolygonSet,)),
    "convolution scale": (lambda x: minkref.convolution(SQUARE, SQUARE, x), NUMBERS),
    "convolution full": (lambda x: minkref.convolution(SQUARE, SQUARE, 1, x), (bool,)),
    "convolution compatible": (lambda x: minkref.convolution(SQUARE, SQUARE, compatible=x), (str,)),
    "tight_passages P": (lambda x: minkref.tight_passages(x, SQUARE), (minkref.PolygonSet,)),
    "tight_passages scale": (lambda x: minkref.tight_passages(SQUARE, SQUARE, x), NUMBERS),
    "ball_sum P": (lambda x: minkref.ball_sum(x, BALL, 1), SURFACES),
    "ball_sum ball": (lambda x: minkref.ball_sum(SIMPLEX, x, 1), ()),
    "ball_sum tolerance": (lambda x: minkref.ball_sum(SIMPLEX, BALL, x), NUMBERS),
    "ball_sum scaling": (lambda x: minkref.ball_sum(SIMPLEX, BALL, 1, x), NUMBERS),
    "ball_sum threads": (lambda x: minkref.ball_sum(SIMPLEX, BALL, 1, threads=x), (int,)),
    "ball_erosion P": (lambda x: minkref.ball_erosion(x, BALL, 1), SURFACES),
    "ball_erosion ball": (lambda x: minkref.ball_erosion(SIMPLEX, x, 1), ()),
    "ball_erosion tolerance": (lambda x: minkref.ball_erosion(SIMPLEX, BALL, x), NUMBERS),
    "ball_erosion scaling": (lambda x: minkref.ball_erosion(SIMPLEX, BALL, 1, x), NUMBERS),
    "ball_erosion threads": (lambda x: minkref.ball_erosion(SIMPLEX, BALL, 1, threads=x), (int,)),
    "decide Q": (lambda x: decide(SQUARE, x, 1, "0", "0"), (minkref.PolygonSet,)),
    "decide scale": (lambda x: decide(SQUARE, SQUARE, x, "0", "0"), NUMBERS),
    "decide x": (lambda x: decide(SQUARE, SQUARE, 1, x, "0"), NUMBERS),
    "decide y": (lambda x: decide(SQUARE, SQUARE, 1, "0", x), NUMBERS),
    "difference first": (lambda x: minkref.difference(x, SQUARE), (minkref.PolygonSet,)),
    "difference second": (lambda x: minkref.difference(SQUARE, x), (minkref.PolygonSet,)),
    "erode P": (lambda x: minkref.erode(x, SQUARE), (minkref.PolygonSet,)),
    "erode Q": (lambda x: minkref.erode(SQUARE, x), (minkref.PolygonSet,)),
    "erode scale": (lambda x: minkref.erode(SQUARE, SQUARE, x), NUMBERS),
    "erode route": (lambda x: minkref.erode(SQUARE, SQUARE, 1, x), (str,)),
    "opening Q": (lambda x: minkref.opening(SQUARE, x), (minkref.PolygonSet,)),
    "closing P": (lambda x: minkref.closing(x, SQUARE), (minkref.PolygonSet,)),
    "closing scale": (lambda x: minkref.closing(SQUARE, SQUARE, x), NUMBERS),
    "inner_fit container": (lambda x: minkref.inner_fit(x, SQUARE), (minkref.PolygonSet,)),
    "inner_fit part": (lambda x: minkref.inner_fit(SQUARE, x), (minkref.PolygonSet,)),
    "no_fit A": (lambda x: minkref.no_fit(x, SQUARE), (minkref.PolygonSet,)),
    "no_fit B": (lambda x: minkref.no_fit(SQUARE, x), (minkref.PolygonSet,)),
    "no_fit scale": (lambda x: minkref.no_fit(SQUARE, SQUARE, x), NUMBERS),
    "inset P": (lambda x: minkref.inset(x, 1), (minkref.PolygonSet,)),
    "inset radius": (lambda x: minkref.inset(SQUARE, x), (*NUMBERS, type(None))),
    "inset threads": (lambda x: minkref.inset(SQUARE, 1, threads=x), (int,)),
    "opening_by_disc P": (lambda x: minkref.opening_by_disc(x, 1), (minkref.PolygonSet,)),
    "opening_by_disc radius": (
        lambda x: minkref.opening_by_disc(SQUARE, x),
        (*NUMBERS, type(None)),
    ),
    "closing_by_disc P": (lambda x: minkref.closing_by_disc(x, 1), (minkref.PolygonSet,)),
    "closing_by_disc threads": (lambda x: minkref.closing_by_disc(SQUARE, 1, threads=x), (int,)),
    "sum_remnants P": (lambda x: minkref.sum_remnants(x, SQUARE), (minkref.PolygonSet,)),
    "sum_remnants scale": (lambda x: minkref.sum_remnants(SQUARE, SQUARE, x), NUMBERS),
    "inradius P": (minkref.inradius, (minkref.PolygonSet,)),
    "events erode": (lambda x: minkref.events(SQUARE, SQUARE, erode=x), (bool,)),
    "events P": (lambda x: minkref.events(x, SQUARE), (minkref.PolygonSet,)),
    "events Q": (lambda x: minkref.events(SQUARE, x), (minkref.PolygonSet,)),
    "events kind": (lambda x: minkref.events(SQUARE, SQUARE, x), (str,)),
    "events from_scale": (
        lambda x: minkref.events(SQUARE, SQUARE, "pair", x),
        (*NUMBERS, type(None)),
    ),
    "events where": (lambda x: minkref.events(SQUARE, SQUARE, where=x), (str, type(None))),
    "convex_sum P": (lambda x: minkref.convex_sum(x, BODY), (minkref.ConvexPolyhedron,)),
    "convex_sum Q": (lambda x: minkref.convex_sum(BODY, x), (minkref.ConvexPolyhedron,)),
    "convex_sum scaling": (lambda x: minkref.convex_sum(BODY, BODY, x), NUMBERS),
    "convex_sum route": (lambda x: minkref.convex_sum(BODY, BODY, 1, x), (str,)),
    "offset P": (lambda x: minkref.offset(x, 1), (minkref.PolygonSet,)),
    "offset radius": (lambda x: minkref.offset(SQUARE, x), (*NUMBERS, type(None))),
    "offset squared_radius": (
        lambda x: minkref.offset(SQUARE, squared_radius=x),
        (*NUMBERS, type(None)),
    ),
    "offset threads": (lambda x: minkref.offset(SQUARE, 1, threads=x), (int,)),
    "polyhedral_closing P": (lambda x: minkref.polyhedral_closing(x, BODY), SURFACES),
    "polyhedral_closing Q": (lambda x: minkref.polyhedral_closing(SIMPLEX, x), SURFACES),
    "polyhedral_closing scaling": (lambda x: minkref.polyhedral_closing(SIMPLEX, BODY, x), NUMBERS),
    "polyhedral_closing route": (lambda x: minkref.polyhedral_closing(SIMPLEX, BODY, 1, x), (str,)),
    "polyhedral_closing threads": (
        lambda x: minkref.polyhedral_closing(SIMPLEX, BODY, threads=x),
        (int,),
    ),
    "polyhedral_erosion P": (lambda x: minkref.polyhedral_erosion(x, BODY), SURFACES),
    "polyhedral_erosion Q": (lambda x: minkref.polyhedral_erosion(SIMPLEX, x), SURFACES),
    "polyhedral_erosion scaling": (lambda x: minkref.polyhedral_erosion(SIMPLEX, BODY, x), NUMBERS),
    "polyhedral_erosion route": (lambda x: minkref.polyhedral_erosion(SIMPLEX, BODY, 1, x), (str,)),
    "polyhedral_erosion threads": (
        lambda x: minkref.polyhedral_erosion(SIMPLEX, BODY, threads=x),
        (int,),
    ),
    "polyhedral_opening P": (lambda x: minkref.polyhedral_opening(x, BODY), SURFACES),
    "polyhedral_opening Q": (lambda x: minkref.polyhedral_opening(SIMPLEX, x), SURFACES),
    "polyhedral_opening scaling": (lambda x: minkref.polyhedral_opening(SIMPLEX, BODY, x), NUMBERS),
    "polyhedral_opening route": (lambda x: minkref.polyhedral_opening(SIMPLEX, BODY, 1, x), (str,)),
    "polyhedral_opening threads": (
        lambda x: minkref.polyhedral_opening(SIMPLEX, BODY, threads=x),
        (int,),
    ),
    "polyhedral_sum P": (lambda x: minkref.polyhedral_sum(x, BODY), SURFACES),
    "polyhedral_sum Q": (lambda x: minkref.polyhedral_sum(SIMPLEX, x), SURFACES),
    "polyhedral_sum scaling": (lambda x: minkref.polyhedral_sum(SIMPLEX, BODY, x), NUMBERS),
    "polyhedral_sum route": (lambda x: minkref.polyhedral_sum(SIMPLEX, BODY, 1, x), (str,)),
    "polyhedral_sum threads": (lambda x: minkref.polyhedral_sum(SIMPLEX, BODY, threads=x), (int,)),
    "read_mesh path": (minkref.read_mesh, (str, bytes, Path)),
    "write_mesh surface": (lambda x: minkref.write_mesh(x, "off"), (minkref.Polyhedron,)),
    "write_mesh format": (lambda x: minkref.write_mesh(SIMPLEX, x), (str,)),
    "read_text text": (lambda x: minkref.read_text(x, "wkt"), (str,)),
    "read_text format": (lambda x: minkref.read_text("", x), (str,)),
    "read_text source": (lambda x: minkref.read_text("POLYGON EMPTY", "wkt", x), (str,)),
    "read_file path": (minkref.read_file, (str, bytes, Path)),
    "write set": (lambda x: minkref.write(x, "wkt"), (minkref.PolygonSet,)),
    "write format": (lambda x: minkref.write(SQUARE, x), (str,)),
    "set_memory_limit bytes": (minkref.set_memory_limit, (int, type(None))),
    "from_json text": (minkref.PolygonSet.from_json, (str,)),
    "validate source": (SQUARE.validate, (str,)),
    "scaled factor": (SQUARE.scaled, NUMBERS),
    "translated x": (lambda x: at(x, "0"), NUMBERS),
    "translated y": (lambda x: at("0", x), NUMBERS),
}
index = minkref.build_index(SQUARE, SQUARE, "1/2", 3)
CALLS |= {
    "build_index P": (lambda x: minkref.build_index(x, SQUARE), (minkref.PolygonSet,)),
    "build_index Q": (lambda x: minkref.build_index(SQUARE, x), (minkref.PolygonSet,)),
    "build_index from_scale": (
        lambda x: minkref.build_index(SQUARE, SQUARE, x),
        (*NUMBERS, type(None)),
    ),
    "build_index threads": (lambda x: minkref.build_index(SQUARE, SQUARE, 1, 2, x), (int,)),
    "open_index path": (minkref.open_index, (str, bytes, Path)),
    "rings scale": (index.rings, NUMBERS),
    "rings form": (lambda x: index.rings(1, x), (str,)),
    "sum scale": (index.sum, NUMBERS),
    "area scale": (index.area, NUMBERS),
    "area_polynomial scale": (index.area_polynomial, NUMBERS),
    "components_and_holes scale": (index.components_and_holes, NUMBERS),
    "neighbours scale": (index.neighbours, NUMBERS),
}
CALLS |= {
    "Certificate P": (lambda x: minkref.Certificate(x, SQUARE), (minkref.PolygonSet,)),
    "Certificate Q": (lambda x: minkref.Certificate(SQUARE, x), (minkref.PolygonSet,)),
    "sum scale of a certificate": (lambda x: minkref.Certificate(SQUARE, SQUARE).sum(x), NUMBERS),
    "point x": (lambda x: minkref.Certificate(SQUARE, SQUARE).point(4, (x, 1)), NUMBERS),
    "outside x": (lambda x: minkref.Certificate(SQUARE, SQUARE).outside(4, (x, 9)), NUMBERS),
    "ConvexCertificate P": (lambda x: minkref.ConvexCertificate(x, SIMPLEX), (minkref.Polyhedron,)),
    "SolidCertificate Q": (lambda x: minkref.SolidCertificate(SIMPLEX, x), (minkref.Polyhedron,)),
    "SolidPointCertificate P": (
        lambda x: minkref.SolidPointCertificate(x, SIMPLEX),
        (minkref.Polyhedron,),
    ),
    "point in space": (
        lambda x: minkref.SolidPointCertificate(SIMPLEX, SIMPLEX).point((1, 1, 1), (x, 0, 0)),
        NUMBERS,
    ),
    "outside in space": (
        lambda x: minkref.SolidPointCertificate(SIMPLEX, SIMPLEX).outside((1, x, 1), (9, 0, 0)),
        NUMBERS,
    ),
}
grown = minkref.DiscIndex(SQUARE)
CALLS |= {
    "DiscIndex P": (minkref.DiscIndex, (minkref.PolygonSet,)),
    "DiscIndex threads": (lambda x: minkref.DiscIndex(SQUARE, x), (int,)),
    "components_and_holes radius": (grown.components_and_holes, (*NUMBERS, type(None))),
    "area_and_length radius": (grown.area_and_length, (*NUMBERS, type(None))),
    "canonical_json radius": (grown.canonical_json, (*NUMBERS, type(None))),
    "vertices radius": (grown.vertices, (int, float)),
}
features = minkref.features(SQUARE)
CALLS |= {
    "features P": (minkref.features, (minkref.PolygonSet,)),
    "features threads": (lambda x: minkref.features(SQUARE, x), (int,)),
    "at alpha": (features.at, NUMBERS),
    "notches alpha": (features.notches, NUMBERS),
    "notches persistence": (lambda x: features.notches(1, x), NUMBERS),
    "notches alpha_to": (lambda x: features.notches(1, 0, x), (*NUMBERS, type(None))),
}
CALLS |= {
    "decompose P": (minkref.decompose, (minkref.PolygonSet,)),
    "decompose alpha": (lambda x: minkref.decompose(SQUARE, x), NUMBERS),
    "decompose persistence": (lambda x: minkref.decompose(SQUARE, 1, x), NUMBERS),
    "decompose alpha_to": (lambda x: minkref.decompose(SQUARE, 1, 0, x), (*NUMBERS, type(None))),
    "decompose threads": (lambda x: minkref.decompose(SQUARE, threads=x), (int,)),
}
ORIGIN = [(0, 0)]
CALLS |= {
    "valid_scales part": (
        lambda x: minkref.valid_scales(x, SQUARE, ORIGIN),
        (minkref.PolygonSet, *SURFACES),
    ),
    "valid_scales obstacles": (
        lambda x: minkref.valid_scales(SQUARE, x, ORIGIN),
        (minkref.PolygonSet,),
    ),
    "valid_scales obstacles in space": (
        lambda x: minkref.valid_scales(SIMPLEX, x, [(0, 0, 0)]),
        SURFACES,
    ),
    "valid_scales path": (lambda x: minkref.valid_scales(SQUARE, SQUARE, x), (list,)),
    "valid_scales path in space": (lambda x: minkref.valid_scales(SIMPLEX, BODY, x), (list,)),
    "valid_scales route in space": (
        lambda x: minkref.valid_scales(SIMPLEX, BODY, [(0, 0, 0)], route=x),
        (str,),
    ),
    "valid_scales contact": (lambda x: minkref.valid_scales(SQUARE, SQUARE, ORIGIN, x), (str,)),
    "valid_scales route": (lambda x: minkref.valid_scales(SQUARE, SQUARE, ORIGIN, route=x), (str,)),
    "valid_scales to_scale": (
        lambda x: minkref.valid_scales(SQUARE, SQUARE, ORIGIN, to_scale=x),
        (*NUMBERS, type(None)),
    ),
    "bad_polygons part": (
        lambda x: minkref.bad_polygons(x, SQUARE, ORIGIN, 2),
        (minkref.PolygonSet,),
    ),
    "bad_polygons obstacles": (
        lambda x: minkref.bad_polygons(SQUARE, x, ORIGIN, 2),
        (minkref.PolygonSet,),
    ),
    "bad_polygons path": (lambda x: minkref.bad_polygons(SQUARE, SQUARE, x, 2), (list,)),
    "bad_polygons to_scale": (lambda x: minkref.bad_polygons(SQUARE, SQUARE, ORIGIN, x), NUMBERS),
    "bad_polygons contact": (lambda x: minkref.bad_polygons(SQUARE, SQUARE, ORIGIN, 2, x), (str,)),
    "bad_polygons from_scale": (
        lambda x: minkref.bad_polygons(SQUARE, SQUARE, ORIGIN, 9, from_scale=x),
        (*NUMBERS, type(None)),
    ),
    "bad_polygons most": (
        lambda x: minkref.bad_polygons(SQUARE, SQUARE, ORIGIN, 2, most=x),
        (int,),
    ),
    "largest_fit part": (lambda x: minkref.largest_fit(x, SQUARE), (minkref.PolygonSet, *SURFACES)),
    "largest_fit container in space": (
        lambda x: minkref.largest_fit(SIMPLEX, x, (0, 0, 0)),
        SURFACES,
    ),
    "largest_fit at in space": (
        lambda x: minkref.largest_fit(SIMPLEX, BODY, x),
        (list, tuple, type(None)),
    ),
    "largest_fit container": (lambda x: minkref.largest_fit(SQUARE, x), (minkref.PolygonSet,)),
    "largest_fit at": (lambda x: minkref.largest_fit(SQUARE, SQUARE, x), (list, type(None))),
    "largest_fit between": (
        lambda x: minkref.largest_fit(SQUARE, SQUARE, None, x),
        (list, type(None)),
    ),
    "largest_fit contact": (lambda x: minkref.largest_fit(SQUARE, SQUARE, contact=x), (str,)),
    "trapped_scales part": (
        lambda x: minkref.trapped_scales(x, SQUARE, (0, 0)),
        (minkref.PolygonSet, *SURFACES),
    ),
    "trapped_scales obstacles": (
        lambda x: minkref.trapped_scales(SQUARE, x, (0, 0)),
        (minkref.PolygonSet,),
    ),
    "trapped_scales at": (lambda x: minkref.trapped_scales(SQUARE, SQUARE, x), (tuple,)),
    "trapped_scales in space": (lambda x: minkref.trapped_scales(SIMPLEX, x, (0, 0, 0)), SURFACES),
    "valid_radii obstacles": (lambda x: minkref.valid_radii(x, ORIGIN), (minkref.PolygonSet,)),
    "valid_radii path": (lambda x: minkref.valid_radii(SQUARE, x), (list,)),
    "valid_radii contact": (lambda x: minkref.valid_radii(SQUARE, ORIGIN, x), (str,)),
    "valid_radii clearance": (lambda x: minkref.valid_radii(SQUARE, ORIGIN, clearance=x), NUMBERS),
    "largest_disc container": (minkref.largest_disc, (minkref.PolygonSet,)),
    "largest_disc at": (lambda x: minkref.largest_disc(SQUARE, x), (list, tuple, type(None))),
    "largest_disc between": (
        lambda x: minkref.largest_disc(SQUARE, None, x),
        (list, tuple, type(None)),
    ),
    "largest_disc threads": (lambda x: minkref.largest_disc(SQUARE, threads=x), (int,)),
    "trapped_radii obstacles": (lambda x: minkref.trapped_radii(x, (9, 9)), (minkref.PolygonSet,)),
    "trapped_radii at": (lambda x: minkref.trapped_radii(SQUARE, x), (list, tuple)),
    "clear_scales part": (
        lambda x: minkref.clear_scales(x, SQUARE, ORIGIN, 1),
        (minkref.PolygonSet,),
    ),
    "clear_scales obstacles": (
        lambda x: minkref.clear_scales(SQUARE, x, ORIGIN, 1),
        (minkref.PolygonSet,),
    ),
    "clear_scales path": (lambda x: minkref.clear_scales(SQUARE, SQUARE, x, 1), (list,)),
    "clear_scales clearance": (lambda x: minkref.clear_scales(SQUARE, SQUARE, ORIGIN, x), NUMBERS),
    "clear_fit part": (lambda x: minkref.clear_fit(x, SQUARE, (0, 0), 1), (minkref.PolygonSet,)),
    "clear_fit container": (
        lambda x: minkref.clear_fit(SQUARE, x, (0, 0), 1),
        (minkref.PolygonSet,),
    ),
    "clear_fit at": (lambda x: minkref.clear_fit(SQUARE, SQUARE, x, 1), (list, tuple)),
    "clear_fits part": (lambda x: minkref.clear_fits(x, SQUARE, 1), (minkref.PolygonSet,)),
    "clear_fits container": (lambda x: minkref.clear_fits(SQUARE, x, 1), (minkref.PolygonSet,)),
    "clear_fits clearance": (lambda x: minkref.clear_fits(SQUARE, SQUARE, x), NUMBERS),
    "clear_fits between": (
        lambda x: minkref.clear_fits(SQUARE, SQUARE, 1, x),
        (list, tuple, type(None)),
    ),
    "clear_fits tolerance": (lambda x: minkref.clear_fits(SQUARE, SQUARE, 1, tolerance=x), NUMBERS),
    "clear_trap part": (lambda x: minkref.clear_trap(x, SQUARE, (9, 9), 1), (minkref.PolygonSet,)),
    "clear_trap obstacles": (
        lambda x: minkref.clear_trap(SQUARE, x, (9, 9), 1),
        (minkref.PolygonSet,),
    ),
    "clear_trap at": (lambda x: minkref.clear_trap(SQUARE, SQUARE, x, 1), (list, tuple)),
    "clear_trap contact": (lambda x: minkref.clear_trap(SQUARE, SQUARE, (9, 9), 1, x), (str,)),
    "unite set": (lambda x: minkref.unite([SQUARE, x]), (minkref.PolygonSet,)),
    "intersect set": (lambda x: minkref.intersect([SQUARE, x]), (minkref.PolygonSet,)),
    "subtract set": (lambda x: minkref.subtract(SQUARE, [x]), (minkref.PolygonSet,)),
    "subtract first": (lambda x: minkref.subtract(x, [SQUARE]), (minkref.PolygonSet,)),
    "held_scales part": (
        lambda x: minkref.held_scales(x, SQUARE, ORIGIN),
        (minkref.PolygonSet, *SURFACES),
    ),
    "held_scales obstacles": (
        lambda x: minkref.held_scales(SQUARE, x, ORIGIN),
        (minkref.PolygonSet,),
    ),
    "held_scales obstacles in space": (
        lambda x: minkref.held_scales(SIMPLEX, x, [(0, 0, 0)]),
        SURFACES,
    ),
    "held_scales way": (lambda x: minkref.held_scales(SQUARE, SQUARE, x), (list,)),
    "held_scales contact": (lambda x: minkref.held_scales(SQUARE, SQUARE, ORIGIN, x), (str,)),
    "held_scales to_scale": (
        lambda x: minkref.held_scales(SQUARE, SQUARE, ORIGIN, to_scale=x),
        (*NUMBERS, type(None)),
    ),
    "trapped_scales from_scale": (
        lambda x: minkref.trapped_scales(SQUARE, SQUARE, (0, 0), "allowed", x),
        (*NUMBERS, type(None)),
    ),
}
scene = minkref.Scene(SQUARE, [SQUARE], [minkref.Copy(0)])
CALLS |= {
    "Copy shape": (minkref.Copy, (str, int)),
    "Copy scale": (lambda x: minkref.Copy(0, x), NUMBERS),
    "Copy place": (lambda x: minkref.Copy(0, 1, x), (list, tuple)),
    "Scene robot": (lambda x: minkref.Scene(x, [SQUARE]), (minkref.PolygonSet,)),
    "Scene shapes": (lambda x: minkref.Scene(SQUARE, [x]), (minkref.PolygonSet,)),
    "Scene copies": (lambda x: minkref.Scene(SQUARE, [SQUARE], [x]), (minkref.Copy,)),
    "Scene passages": (lambda x: minkref.Scene(SQUARE, [], passages=x), (bool,)),
    "Scene threads": (lambda x: minkref.Scene(SQUARE, [], threads=x), (int,)),
    "of_arrays numbers": (
        lambda x: minkref.Scene.of_arrays(SQUARE, [SQUARE], x, [1], [(0, 0)]),
        (list, dict),
    ),
    "change copy": (scene.change, (int,)),
    "change scale": (lambda x: scene.change(0, x), (*NUMBERS, type(None))),
    "change place": (lambda x: scene.change(0, place=x), (list, tuple, type(None))),
    "add shape": (scene.add, (str, int)),
    "add scale": (lambda x: scene.add(0, x), NUMBERS),
    "remove copy": (scene.remove, (int,)),
    "sum_of copy": (scene.sum_of, (int,)),
    "read_scene path": (minkref.read_scene, (str, bytes, Path)),
}
REFUSED = (minkref.BadInput, minkref.Refusal)


def test_every_public_function_is_here() -> None:
    functions = {
        name
        for name in minkref.__all__
        if callable(getattr(minkref, name)) and not isinstance(getattr(minkref, name), type)
    }
    assert functions - {"version"} == {name.split()[0] for name in CALLS} & functions


@pytest.mark.parametrize("name", CALLS)
def test_a_wrong_type_is_refused_in_plain_words(name: str) -> None:
    call, taken = CALLS[name]
    for value in WRONG:
        if isinstance(value, taken) and (taken == (bool,) or not isinstance(value, bool)):
            continue
        with pytest.raises(TypeError) as error:
            call(value)
        said = str(error.value)
        assert "\n" not in said and "_core" not in said and "nanobind" not in said, said
        assert type(value).__name__ in said, said
        assert (
            name.startswith(("read_file", "read_mesh", "read_scene", "open_index"))
            or name.split()[1] in said
        ), said
    minkref.set_memory_limit(None)


@pytest.mark.parametrize("name", [name for name, (_, taken) in CALLS.items() if taken is NUMBERS])
def test_exact_numbers_of_python_are_numbers(name: str) -> None:
    call, _ = CALLS[name]
    for value in (Fraction(7, 5), 2, "7/5"):
        call(value)


def test_a_number_is_what_it_says() -> None:
    assert SQUARE.scaled(Fraction(7, 5)).to_json() == SQUARE.scaled("7/5").to_json()
    assert at(-2, Fraction(-1, 3)).to_json() == at("-2", "-1/3").to_json()
    assert sum_(SQUARE, SQUARE, Fraction(1, 2)).region.area() == "9/4"
    assert decide(SQUARE, SQUARE, 1, 2, Fraction(4, 2))["p"] == (1, 1)


@pytest.mark.parametrize(
    ("call", "why"),
    [
        (lambda: SQUARE.scaled(), "missing a required argument: 'factor'"),
        (lambda: SQUARE.scaled("1", "2"), "too many positional arguments"),  # type: ignore[call-arg]
        (lambda: SQUARE.scaled(by="1"), "missing a required argument: 'factor'"),  # type: ignore[call-arg]
    ],
)
def test_wrong_arguments_are_refused_in_plain_words(call: Callable[[], Any], why: str) -> None:
    with pytest.raises(TypeError) as error:
        call()
    assert why in str(error.value) and "\n" not in str(error.value)


def test_methods_keep_their_documentation() -> None:
    assert "exact" in (minkref.PolygonSet.__doc__ or "")
    assert "nothing is validated" in (minkref.PolygonSet.from_json.__doc__ or "")
    SQUARE.validate()
    SQUARE.validate(source="P")
