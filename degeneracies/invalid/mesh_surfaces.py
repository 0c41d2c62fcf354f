"""Readable meshes that form no closed surface, or no convex body's surface."""

from __future__ import annotations

from collections.abc import Sequence
from fractions import Fraction
from itertools import pairwise
from random import Random

from minkref.degeneracies.invalid.member import Families, Invalid
from minkref.degeneracies.invalid.mesh_sheet import (
    MESH,
    body,
    middle,
    refused,
    sheet,
    shuffled,
    vertex_text,
)
from minkref.fuzz.geometry.polyhedron import Face, Polyhedron
from minkref.fuzz.geometry.space import Point, dot, normal
from minkref.fuzz.plane.families.drawing import convex

FAMILIES = Families(MESH)

Edge = tuple[int, int]


def edges_of(face: Sequence[int]) -> list[Edge]:
    return list(pairwise((*face, face[0])))


def least(edges: Sequence[Edge]) -> Edge:
    """Returns the edge that a check visits first."""
    return min(edges, key=lambda edge: (min(edge), max(edge)))


def with_faces(mesh: Polyhedron, faces: Sequence[Face], *more: Point) -> Polyhedron:
    return Polyhedron((*mesh.vertices, *more), tuple(faces))


def owner(faces: Sequence[Face], edge: Edge) -> int:
    """Returns the face that runs along the edge."""
    return next(k for k, face in enumerate(faces) if edge in edges_of(face))


@FAMILIES.add("a surface that lacks a face")
def open_mesh(dice: Random) -> Invalid:
    """A face is missing."""
    mesh = body(dice)
    lost = dice.randrange(len(mesh.faces))
    faces = [face for k, face in enumerate(mesh.faces) if k != lost]
    a, b = least(edges_of(mesh.faces[lost]))
    page = sheet(dice, with_faces(mesh, faces))
    face = owner(faces, (b, a))
    place = f"face {face}", f"vertices {b}, {a}", f"line {page.line_of_face(face)}"
    return refused(page, "open-mesh", "open-mesh", *place, vertex_text(page, a))


@FAMILIES.add("an edge of more than two faces")
def non_manifold_edge(dice: Random) -> Invalid:
    """A triangle more at an edge; or two bodies that share one."""
    mesh = body(dice)
    a, b = dice.choice(edges_of(dice.choice(mesh.faces)))
    count = len(mesh.vertices)
    if dice.random() < 0.5:
        outside = middle(mesh, (a, b))
        far = tuple(2 * c - m for c, m in zip(outside, _centre(mesh), strict=True))
        bad = with_faces(mesh, [*mesh.faces, (a, b, count)], (far[0], far[1], far[2]))
    else:
        bad = _glued(mesh, middle(mesh, (a, b)), {a: b, b: a})
    page = sheet(dice, bad)
    first = min(owner(bad.faces, (a, b)), owner(bad.faces, (b, a)))
    start, end = (a, b) if (a, b) in edges_of(bad.faces[first]) else (b, a)
    place = f"face {first}", f"vertices {start}, {end}", f"line {page.line_of_face(first)}"
    return refused(page, "non-manifold-edge", "non-manifold-edge", *place)


def _centre(mesh: Polyhedron) -> Point:
    return middle(mesh, range(len(mesh.vertices)))


def _glued(mesh: Polyhedron, at: Point, images: dict[int, int]) -> Polyhedron:
    """Adds the mesh's reflection in a point; `images` gives the vertices that both share."""
    numbers = dict(images)
    more: list[Point] = []
    for k, vertex in enumerate(mesh.vertices):
        if k not in numbers:
            numbers[k] = len(mesh.vertices) + len(more)
            x, y, z = (2 * c - v for c, v in zip(at, vertex, strict=True))
            more.append((x, y, z))
    faces = [tuple(numbers[k] for k in face)[::-1] for face in mesh.faces]
    return with_faces(mesh, [*mesh.faces, *faces], *more)


@FAMILIES.add("two bodies that share a vertex")
def non_manifold_vertex(dice: Random) -> Invalid:
    """Two bodies that share a vertex."""
    mesh = body(dice)
    vertex = dice.randrange(len(mesh.vertices))
    page = sheet(dice, _glued(mesh, mesh.vertices[vertex], {vertex: vertex}))
    place = f"vertex {vertex}", vertex_text(page, vertex)
    return refused(page, "non-manifold-vertex", "non-manifold-vertex", *place)


@FAMILIES.add("a face that runs the wrong way")
def wrong_orientation(dice: Random) -> Invalid:
    """Turns one face round."""
    mesh = body(dice)
    turned = dice.randrange(len(mesh.faces))
    faces = [face[::-1] if k == turned else face for k, face in enumerate(mesh.faces)]
    a, b = least(edges_of(faces[turned]))
    page = sheet(dice, with_faces(mesh, faces))
    both = sorted((turned, owner(mesh.faces, (a, b))))
    place = f"face {both[0]}", f"vertices {a}, {b}", f"and face {both[1]}", vertex_text(page, a)
    return refused(page, "wrong-orientation", "wrong-orientation", *place)


@FAMILIES.add("a surface that faces inwards", "wrong-orientation")
def inside_out(dice: Random) -> Invalid:
    page = sheet(dice, body(dice).turned_inside_out())
    place = "face 0", "inside out", f"line {page.line_of_face(0)}"
    return refused(page, "inside-out", "wrong-orientation", *place)


@FAMILIES.add("a face that visits a vertex twice")
def repeated_vertex(dice: Random) -> Invalid:
    """A face that visits a vertex twice."""
    mesh = body(dice)
    face = dice.randrange(len(mesh.faces))
    ring = mesh.faces[face]
    again = dice.choice(ring[:-2])
    faces = [(*f, again) if k == face else f for k, f in enumerate(mesh.faces)]
    faces[face] = (*ring[:-1], again, ring[-1])
    page = sheet(dice, with_faces(mesh, faces))
    place = f"face {face}", f"vertex {again}", f"line {page.line_of_face(face)}"
    return refused(page, "repeated-vertex", "repeated-vertex", *place)


@FAMILIES.add("a face without area")
def zero_area(dice: Random) -> Invalid:
    """A sliver along an edge, between the edge's ends and a vertex inside the edge."""
    mesh = body(dice)
    face = dice.randrange(len(mesh.faces))
    a, b = edges_of(mesh.faces[face])[0]
    new = len(mesh.vertices)
    faces = list(mesh.faces)
    faces[face] = (a, new, *faces[face][1:])
    at = dice.randint(0, len(faces))
    faces.insert(at, (a, b, new))
    t = Fraction(1, dice.randint(2, 5))
    ends = mesh.vertices[a], mesh.vertices[b]
    x, y, z = (p + t * (q - p) for p, q in zip(*ends, strict=True))
    page = sheet(dice, with_faces(mesh, faces, (x, y, z)))
    place = f"face {at}", f"line {page.line_of_face(at)}", vertex_text(page, new)
    return refused(page, "zero-area", "zero-area", *place)


@FAMILIES.add("a face that lies in no plane")
def non_planar_face(dice: Random) -> Invalid:
    """Moves a corner off the plane of a face with four or more, by little or much."""
    while True:
        mesh = body(dice, 4)
        face = max(mesh.faces, key=len)
        moved = dice.choice(face)
        step = Fraction(1, 2 ** dice.choice((0, 3, 30, 60)))
        x, y, z = (c + step * dice.choice((1, 2, 3)) for c in mesh.vertices[moved])
        vertices = list(mesh.vertices)
        vertices[moved] = (x, y, z)
        bad = Polyhedron(tuple(vertices), mesh.faces)
        found = bad.bad_face()
        if found and "planar" in found[1]:
            page = sheet(dice, bad)
            place = f"face {found[0]}", f"line {page.line_of_face(found[0])}", "vertex "
            return refused(page, "non-planar-face", "non-planar-face", *place)


@FAMILIES.add("a face whose edges cross")
def face_not_simple(dice: Random) -> Invalid:
    """Exchanges two corners of a face, so that its edges cross."""
    while True:
        mesh = body(dice, 4)
        face = dice.choice([k for k, ring in enumerate(mesh.faces) if len(ring) > 3])
        a, b, c, *others = mesh.faces[face]
        faces = [(a, c, b, *others) if k == face else f for k, f in enumerate(mesh.faces)]
        bad = with_faces(mesh, faces)
        if bad.bad_face() is None:
            page = sheet(dice, bad)
            place = f"face {face}", f"line {page.line_of_face(face)}", "vertices "
            return refused(page, "face-not-simple", "face-not-simple", *place)


@FAMILIES.add("a face of a vertex that is not there")
def index_out_of_range(dice: Random) -> Invalid:
    mesh = body(dice)
    page = sheet(dice, mesh)
    face = dice.randrange(len(mesh.faces))
    beyond = len(mesh.vertices) + dice.choice((0, 0, 1, 7, 10**6, 2**40))
    if dice.random() < 0.25 and page.form in ("off", "ply", "obj"):
        beyond = -1  # in OBJ 0
    page.faces[face][dice.randrange(len(page.faces[face]))] = str(beyond)
    number = str(beyond + (page.form == "obj"))
    place = f"face {face}", f"line {page.line_of_face(face)}", number
    return refused(page, "index-out-of-range", "index-out-of-range", *place)


@FAMILIES.add("a vertex of no face")
def unused_vertex(dice: Random) -> Invalid:
    """A vertex without faces: inside the body, on the body or far away."""
    mesh = body(dice)
    point = dice.choice((_centre(mesh), mesh.vertices[0], (Fraction(99),) * 3))
    page = sheet(dice, with_faces(mesh, mesh.faces, point))
    new = len(mesh.vertices)
    place = f"vertex {new}", vertex_text(page, new), f"line {page.line_of_vertex(new)}"
    return refused(page, "unused-vertex", "unused-vertex", *place)


@FAMILIES.add("an edge between equal vertices")
def zero_length_edge(dice: Random) -> Invalid:
    """A vertex given twice, and an edge between the two."""
    mesh = body(dice)
    face = dice.randrange(len(mesh.faces))
    ring = mesh.faces[face]
    new = len(mesh.vertices)
    faces = [(f[0], new, *f[1:]) if k == face else f for k, f in enumerate(mesh.faces)]
    page = sheet(dice, with_faces(mesh, faces, mesh.vertices[ring[0]]))
    place = f"face {face}", f"vertices {ring[0]}, {new}", vertex_text(page, new)
    return refused(page, "zero-length-edge", "zero-length-edge", *place)


@FAMILIES.add("a face of fewer than three vertices")
def too_few_vertices(dice: Random) -> Invalid:
    """A face with two vertices, one or none."""
    page = sheet(dice, body(dice))
    face = dice.randrange(len(page.faces))
    del page.faces[face][dice.choice((1, 2, 2, 0)) if page.form in ("off", "json") else 2 :]
    place = f"face {face}", f"line {page.line_of_face(face)}", f"{len(page.faces[face])} vert"
    return refused(page, "too-few-vertices", "too-few-vertices", *place)


@FAMILIES.add("vertices and no face")
def too_few_faces(dice: Random) -> Invalid:
    """Points alone."""
    page = sheet(dice, with_faces(body(dice), []))
    count = f"{len(page.vertices)} vertices"
    return refused(page, "too-few-faces", "too-few-faces", count)


@FAMILIES.add("a body with a dent", "not-convex")
def dent(dice: Random) -> Invalid:
    """Cuts a pyramid out of a body, with a facet as its base: by a small depth."""
    mesh = body(dice)
    face = dice.randrange(len(mesh.faces))
    t = Fraction(1, 2 ** dice.choice((1, 3, 30, 80)))
    base, centre = middle(mesh, mesh.faces[face]), _centre(mesh)
    x, y, z = (b + t * (c - b) for b, c in zip(base, centre, strict=True))
    new = len(mesh.vertices)
    faces = [f for k, f in enumerate(mesh.faces) if k != face]
    faces += [(a, b, new) for a, b in edges_of(mesh.faces[face])]
    page = sheet(dice, shuffled(dice, with_faces(mesh, faces, (x, y, z))))
    return refused(page, "dent", "not-convex", "not convex", "face ", "vertex ")


@FAMILIES.add("two convex bodies in one file", "not-convex")
def two_bodies(dice: Random) -> Invalid:
    """Apart; each is convex."""
    first, second = body(dice), body(dice)
    far = second.translated((Fraction(dice.randint(20, 60)), Fraction(0), Fraction(0)))
    page = sheet(dice, first.with_faces_of(far))
    return refused(page, "two-bodies", "not-convex", "face ")


def _small_inside(mesh: Polyhedron) -> Polyhedron:
    x, y, z = _centre(mesh)
    vertices = tuple(
        (x + (a - x) / 4, y + (b - y) / 4, z + (c - z) / 4) for a, b, c in mesh.vertices
    )
    return Polyhedron(vertices, mesh.faces)


@FAMILIES.add("a body with a cavity", "not-convex")
def cavity(dice: Random) -> Invalid:
    """A small body inside a larger one, with turned faces: a valid polyhedron, but not convex."""
    mesh = body(dice)
    both = mesh.with_faces_of(_small_inside(mesh).turned_inside_out())
    return refused(sheet(dice, shuffled(dice, both)), "cavity", "not-convex", "face ")


@FAMILIES.add("a body inside another", "shell-nesting")
def body_in_another(dice: Random) -> Invalid:
    """A small body inside a larger one, with faces unturned."""
    mesh = body(dice)
    page = sheet(dice, shuffled(dice, mesh.with_faces_of(_small_inside(mesh))))
    return refused(page, "body-in-another", "shell-nesting", "face ", "and face ")


@FAMILIES.add("two bodies that pass through each other", "self-intersection")
def crossing_bodies(dice: Random) -> Invalid:
    """A body and the same a little further, in no direction along a facet."""
    while True:
        mesh = body(dice)
        x, y, z = (
            (a - b) / 3 for a, b in zip(_centre(mesh), dice.choice(mesh.vertices), strict=True)
        )
        corners = ([mesh.vertices[k] for k in face[:3]] for face in mesh.faces)
        if all(dot(normal(a, b, c), (x, y, z)) != 0 for a, b, c in corners):
            break
    page = sheet(dice, shuffled(dice, mesh.with_faces_of(mesh.translated((x, y, z)))))
    place = "face ", "and face ", "passes through itself at ("
    return refused(page, "crossing-bodies", "self-intersection", *place)


@FAMILIES.add("two bodies on one facet", "overlapping-faces")
def common_facet(dice: Random) -> Invalid:
    """A body and its reflection in a point of a facet: both share that facet, from opposite
    sides."""
    mesh = body(dice)
    at = tuple(2 * c for c in middle(mesh, dice.choice(mesh.faces)))
    both = mesh.with_faces_of(mesh.reflected((at[0], at[1], at[2])))
    place = "face ", "and face ", "the same part of a plane at ("
    return refused(sheet(dice, shuffled(dice, both)), "common-facet", "overlapping-faces", *place)


@FAMILIES.add("a surface that goes around twice", "self-intersection")
def wound_twice(dice: Random) -> Invalid:
    """Over a pentagram: convex at each edge, and twice around."""
    while True:
        ring = convex(dice, dice.randint(6, 8), 12)[:5]
        if len(ring) == 5:
            break
    star = [ring[k] for k in (0, 2, 4, 1, 3)]
    x, y = (Fraction(sum(p[k] for p in ring)) / 5 for k in (0, 1))
    vertices = [(Fraction(a), Fraction(b), Fraction(0)) for a, b in star]
    ends = [(x, y, Fraction(dice.randint(3, 9))), (x, y, -Fraction(dice.randint(3, 9)))]
    faces = [(k, (k + 1) % 5, 5) for k in range(5)] + [((k + 1) % 5, k, 6) for k in range(5)]
    page = sheet(dice, shuffled(dice, Polyhedron((*vertices, *ends), tuple(faces))))
    return refused(page, "wound-twice", "self-intersection", "face ", "and face ")


@FAMILIES.add("a polygon from both sides, with nothing inside", "overlapping-faces")
def flat(dice: Random) -> Invalid:
    """A polygon from both sides: closed, with nothing inside."""
    ring = convex(dice, dice.randint(3, 8), 12)
    face = tuple(range(len(ring)))
    vertices = tuple((Fraction(x), Fraction(y), Fraction(x - 2 * y)) for x, y in ring)
    page = sheet(dice, shuffled(dice, Polyhedron(vertices, (face, face[::-1]))))
    return refused(page, "flat", "overlapping-faces", "face 0", "and face 1")
